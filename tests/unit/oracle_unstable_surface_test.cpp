// The oracle's unstable sets of dimension 2, worked out by hand: a plane, a half plane beyond a triangle, quarters that
// meet at a maximum, and a sheet that fans out beyond an obtuse triangle.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "oracle/line_intervals.h"
#include "oracle/unstable_surface.h"
#include "tests/cites.h"

namespace oracle::oracle_unstable_surface_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;

UnstableSurface surface_of(const Rows& rows, const Names& contact) {
  for (const StationaryPoint& point : stationary_points(rows).stationary) {
    if (point.contact == contact) return unstable_surface(PointSet(rows), point);
  }
  throw std::logic_error("no such stationary point");
}

TEST(OracleUnstableSurface, OfTwoPointsIsAPlane) {
  CITES("FC-UNST-04");
  const Rows rows = {{0, 0, 0}, {2, 0, 0}};
  const UnstableSurface set = surface_of(rows, {0, 1});
  EXPECT_EQ(set.sheets, (std::vector<Region>{{{0, 1}, {}}}));
  EXPECT_TRUE(set.traces.empty() && set.runs.empty() && set.segments.empty() && set.vertices.empty());
  EXPECT_TRUE(contains(PointSet(rows), set, {1, 5, -7}));
  EXPECT_FALSE(contains(PointSet(rows), set, {0, 5, -7}));
}

// The three facets of an obtuse triangle meet in one line. It leads into the facet of the long edge.
TEST(OracleUnstableSurface, InAPlaneTracesAreLines) {
  CITES("FC-UNST-04", "FC-UNST-05");
  const Rows obtuse = {{-4, 0, 0}, {4, 0, 0}, {0, 1, 0}};
  const UnstableSurface set = surface_of(obtuse, {0, 2});
  EXPECT_EQ(set.sheets, (std::vector<Region>{{{0, 1}, {}}, {{0, 2}, {}}}));
  EXPECT_EQ(set.traces, (std::vector<EdgePart>{{{0, 1, 2}, {{0, 0, -1}, true}, {{0, 0, 1}, true}}}));
  EXPECT_TRUE(set.segments.empty() && set.runs.empty());
  // The circle's centre is (0, -15/2, 0). The facet of points 0 and 1 goes on from there.
  EXPECT_TRUE(contains(PointSet(obtuse), set, {0, -8, 3}));
  EXPECT_TRUE(contains(PointSet(obtuse), set, {0, Rational(-15, 2), -9}));
  EXPECT_FALSE(contains(PointSet(obtuse), surface_of(obtuse, {1, 2}), {-2, 8, 0}));
}

// From an edge of the cube, through the centres of two squares, to the maximum. The set is one corner of a facet, a
// quarter of a plane, with its sides.
TEST(OracleUnstableSurface, OfAnEdgeOfACubeIsAQuarter) {
  CITES("FC-UNST-04", "FC-UNST-06");
  Rows cube;
  for (int k = 0; k < 8; ++k) cube.push_back({double(k & 1) * 2, double(k >> 1 & 1) * 2, double(k >> 2) * 2});
  const UnstableSurface set = surface_of(cube, {0, 1});
  EXPECT_EQ(set.vertices, (std::vector<Point>{{1, 1, 1}}));
  EXPECT_EQ(set.traces, (std::vector<EdgePart>{{{0, 1, 2, 3}, {{1, 1, 1}, false}, {{0, 0, -1}, true}},
                                               {{0, 1, 4, 5}, {{1, 1, 1}, false}, {{0, -1, 0}, true}}}));
  EXPECT_EQ(set.sheets, (std::vector<Region>{{{0, 1}, {{{1, 1, 1}, false}, {{0, -1, 0}, true}, {{0, 0, -1}, true}}}}));
  EXPECT_TRUE(set.runs.empty() && set.segments.empty());
  const PointSet points(cube);
  EXPECT_TRUE(contains(points, set, {1, 0, -5}));
  EXPECT_TRUE(contains(points, set, {1, 1, -5}));
  EXPECT_TRUE(contains(points, set, {1, 1, 1}));
  EXPECT_FALSE(contains(points, set, {1, 1, 2}));
  EXPECT_FALSE(contains(points, set, {1, 2, 2}));
}

// The triangle 0, 1, 2 is obtuse at the edge of 0 and 1, and a point far above makes its Voronoi edge a ray. The trace
// on it fans out in the facet of 0 and 1, all of whose rays come from there.
TEST(OracleUnstableSurface, FansOutBeyondAnObtuseTriangle) {
  CITES("FC-UNST-05");
  const Rows rows = {{-4, 0, 0}, {4, 0, 0}, {0, 1, 0}, {0, 0, 40}};
  const PointSet points(rows);
  const UnstableSurface set = surface_of(rows, {0, 2});
  const auto fan = std::find_if(set.sheets.begin(), set.sheets.end(),
                                [](const Region& s) { return s.samples == std::array<std::size_t, 2>{0, 1}; });
  ASSERT_NE(fan, set.sheets.end());
  // The Voronoi vertex is on the axis (0, -15/2, t), where 16 + 225/4 + t^2 = 225/4 + (t - 40)^2, so t = 99/5.
  const Point vertex = {0, Rational(-15, 2), Rational(99, 5)};
  EXPECT_EQ(set.vertices, (std::vector<Point>{vertex}));
  EXPECT_TRUE(contains(points, set, {0, -15, 0}));
  EXPECT_TRUE(contains(points, set, {0, Rational(-15, 2), -100}));
  EXPECT_TRUE(contains(points, set, vertex));
  // The midpoint of points 1 and 2 is stationary itself.
  EXPECT_FALSE(contains(points, set, {2, Rational(1, 2), 0}));
}

TEST(OracleUnstableSurface, OnlyFacesOfDimension1HaveSheets) {
  const Rows rows = {{0, 0, 0}, {2, 0, 0}};
  EXPECT_THROW(surface_of(rows, {0}), std::invalid_argument);
}

TEST(LineIntervals, AreOneWhereTheyMeet) {
  const auto at = [](int x) { return Corner(Point{x, 0, 0}); };
  const Interval low = {at(0), at(1)}, point = {at(1), at(1), true, true}, high = {at(1), {{1, 0, 0}, true}};
  EXPECT_EQ(components({high, low}).size(), 2U);
  const std::vector<Interval> all = components({high, point, low});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].from, at(0));
  EXPECT_EQ(all[0].to, Corner({1, 0, 0}, true));
  EXPECT_FALSE(all[0].has_from);
  EXPECT_TRUE(covers(all, point));
  EXPECT_FALSE(covers(components({high, low}), point));
  EXPECT_EQ(open_remainder(all, {point}).size(), 2U);
  EXPECT_TRUE(open_remainder({point}, {}).empty());
}

}  // namespace
}  // namespace oracle::oracle_unstable_surface_test
