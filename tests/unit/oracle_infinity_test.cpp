// What flows to infinity, by the oracle, worked out by hand: of sets of all dimensions, with pieces that have one
// corner at infinity or two, and what leads to these. And which shares of a stable set are in which Voronoi cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"

namespace oracle::oracle_infinity_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;

struct Subject {
  explicit Subject(const Rows& rows) : set(rows), infinity(stable_set_of_infinity(set)) {
    for (const StationaryPoint& z : stationary_points(set).stationary) sets.emplace_back(z, stable_set(set, z));
  }

  PointSet set;
  StableSet infinity;
  std::vector<std::pair<StationaryPoint, StableSet>> sets;
};

bool leads_to_infinity(const Subject& s, const Point& x) {
  const bool found = flows_to_infinity(s.set, s.infinity, x);
  EXPECT_EQ(found, !orbit(s.set, x).limit);
  return found;
}

TEST(OracleInfinity, OfNoPointAndOfOne) {
  CITES("FC-STAB-08");
  EXPECT_EQ(stable_set_of_infinity(PointSet(Rows{})), StableSet{});
  EXPECT_FALSE(flows_to_infinity(PointSet(Rows{}), StableSet{}, {0, 0, 0}));
  const Subject one({{1, 2, 3}});
  EXPECT_EQ(one.infinity, StableSet{});
  EXPECT_FALSE(leads_to_infinity(one, {1, 2, 3}));
  EXPECT_TRUE(leads_to_infinity(one, {1, 2, 4}));
}

TEST(OracleInfinity, OfPointsOnALine) {
  CITES("FC-STAB-08");
  const Subject two({{0, 0, 0}, {2, 0, 0}});
  // The facet is a plane, cut into quarters by four rays from the saddle.
  EXPECT_EQ(two.infinity.segments.size(), 4U);
  EXPECT_EQ(two.infinity.sectors.size(), 4U);
  for (const BackwardSegment& s : two.infinity.segments) {
    EXPECT_TRUE(s.front.at_infinity);
    EXPECT_EQ(s.back, (Point{1, 0, 0}));
  }
  EXPECT_TRUE(std::ranges::all_of(two.infinity.sectors, is_unbounded));
  EXPECT_TRUE(two.infinity.points.empty() && two.infinity.intervals.empty() && two.infinity.crossed.empty());
  EXPECT_FALSE(leads_to_infinity(two, {1, 0, 0}));
  EXPECT_FALSE(leads_to_infinity(two, {1.5, 0, 0}));
  EXPECT_TRUE(leads_to_infinity(two, {1, 0, 1}));
  EXPECT_TRUE(leads_to_infinity(two, {1, 2, -3}));
  EXPECT_TRUE(leads_to_infinity(two, {3, 0, 0}));
  EXPECT_TRUE(leads_to_infinity(two, {0.5, 0.1, 0}));
}

TEST(OracleInfinity, OfAnAcuteTriangle) {
  CITES("FC-STAB-08");
  const Subject t({{-3, 0, 0}, {3, 0, 0}, {0, 5, 0}});
  // Up and down from the centre (0,8/5,0): 9 + y^2 = (5 - y)^2.
  const Point z = {0, Rational(8, 5), 0}, up = {0, 0, 1}, down = {0, 0, -1};
  const Names all = {0, 1, 2};
  EXPECT_EQ(t.infinity.intervals, (std::vector<EdgePart>{{all, {down, true}, z}, {all, {up, true}, z}}));
  // In each facet, from the midpoint: up, outwards, and down. Sectors inside of the triangle are between z and m.
  EXPECT_EQ(t.infinity.segments.size(), 9U);
  EXPECT_EQ(t.infinity.sectors.size(), 12U);
  const Point m = {0, 0, 0};
  const Region inner = {{0, 1}, {{m, false}, {z, false}, {up, true}}};
  const Region outer = {{0, 1}, {{m, false}, {{0, -1, 0}, true}, {up, true}}};
  EXPECT_TRUE(std::ranges::find(t.infinity.sectors, inner) != t.infinity.sectors.end());
  EXPECT_TRUE(std::ranges::find(t.infinity.sectors, outer) != t.infinity.sectors.end());
  EXPECT_FALSE(leads_to_infinity(t, {0, 1, 0}));
  EXPECT_TRUE(leads_to_infinity(t, {0, 1, Rational(1, 100)}));
  EXPECT_TRUE(leads_to_infinity(t, {0, -1, 0}));
}

// The triangle is obtuse at its lower edge, and its line is crossed by rays from the midpoint of that. The triangle
// itself flows to infinity, but for the two upper edges.
TEST(OracleInfinity, OfAnObtuseTriangle) {
  CITES("FC-STAB-08");
  const Subject t({{-3, 0, 0}, {3, 0, 0}, {0, 1, 0}});
  // 9 + y^2 = (1 - y)^2 at y = -4.
  const Point o = {0, -4, 0}, up = {0, 0, 1}, down = {0, 0, -1};
  const Names all = {0, 1, 2};
  EXPECT_TRUE(t.infinity.intervals.empty());
  EXPECT_EQ(t.infinity.crossed, (std::vector<EdgePart>{{all, o, {down, true}}, {all, o, {up, true}}}));
  EXPECT_TRUE(leads_to_infinity(t, {0, Rational(1, 4), 0}));
  EXPECT_TRUE(leads_to_infinity(t, {0, 0, 0}));
  EXPECT_TRUE(leads_to_infinity(t, o));
  EXPECT_FALSE(leads_to_infinity(t, {1, Rational(2, 3), 0}));
}

TEST(OracleInfinity, OfATetrahedron) {
  CITES("FC-STAB-08");
  const Subject t({{3, 3, 3}, {3, -3, -3}, {-3, 3, -3}, {-3, -3, 3}});
  EXPECT_TRUE(t.infinity.points.empty());
  EXPECT_EQ(t.infinity.intervals.size(), 4U);
  // Three beside each of the four axes, and one beyond each edge. Each facet has two of the axes' directions.
  EXPECT_EQ(t.infinity.sectors.size(), 12U + 6U);
  EXPECT_EQ(t.infinity.segments.size(), 12U);
  EXPECT_TRUE(leads_to_infinity(t, {2, 2, -2}));
  EXPECT_FALSE(leads_to_infinity(t, {1, 1, 0}));
}

// The centre of the four points is beyond the lower triangle, which contains its own centre: the Voronoi vertex, and
// all of the Voronoi edge below it, flow away from there.
TEST(OracleInfinity, AVoronoiVertexThatFlowsToInfinity) {
  CITES("FC-STAB-08");
  const Subject t({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 1}});
  // 25 + c^2 = (1 - c)^2 at c = -12.
  const Point o = {0, 0, -12};
  // On the three ways back from there, the Voronoi edges of the other triangles are crossed.
  ASSERT_EQ(t.infinity.points.size(), 4U);
  EXPECT_TRUE(std::ranges::any_of(t.infinity.points, [&](const SkeletonPoint& y) { return y.position == o; }));
  const EdgePart down = {{0, 1, 2}, {{0, 0, -1}, true}, o};
  EXPECT_TRUE(std::ranges::find(t.infinity.intervals, down) != t.infinity.intervals.end());
  EXPECT_TRUE(leads_to_infinity(t, o));
  EXPECT_TRUE(leads_to_infinity(t, {0, 0, 0}));
}

// The sphere of the four points has its centre in (0,1,0). The facet of 0 and 1 is a wedge with its tip there, and one
// of the rays of its sector comes through the tip.
TEST(OracleInfinity, ASectorWithAVoronoiVertexAsItsTip) {
  CITES("FC-STAB-08");
  const Subject t({{-3, 0, 0}, {3, 0, 0}, {-1, -2, 0}, {0, -2, -1}});
  const Point tip = {0, 1, 0};
  const Region wedge = {{0, 1}, {{tip, false}, {{0, 0, 1}, true}, {{0, Rational(1, 2), -1}, true}}};
  EXPECT_TRUE(std::ranges::find(t.infinity.sectors, wedge) != t.infinity.sectors.end());
  const SkeletonPoint vertex = {tip, {0, 1, 2, 3}};
  EXPECT_TRUE(std::ranges::find(t.infinity.points, vertex) != t.infinity.points.end());
  EXPECT_TRUE(leads_to_infinity(t, {0, 1, 0}));
  EXPECT_TRUE(leads_to_infinity(t, {1, Rational(2, 3), 0}));
}

std::map<Names, std::vector<Rational>> shares_of(const Rows& rows) {
  std::map<Names, std::vector<Rational>> found;
  for (const auto& [z, stable] : Subject(rows).sets) {
    const std::vector<Rational> parts = shares(PointSet(rows), stable);
    if (volume(PointSet(rows), stable) != 0) found.emplace(z.contact, parts);
  }
  return found;
}

TEST(OracleInfinity, SharesOfSamples) {
  CITES("FC-VOL-02");
  using Shares = std::map<Names, std::vector<Rational>>;
  const Rows cube = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(shares_of(cube), (Shares{{{0, 1, 2, 3, 4, 5, 6, 7}, std::vector<Rational>(8, {1, 8})}}));
  const Rows half_octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  EXPECT_EQ(
      shares_of(half_octahedron),
      (Shares{{{0, 1, 2, 3, 4}, {Rational(1, 9), Rational(1, 9), Rational(1, 9), Rational(1, 9), Rational(2, 9)}}}));
  // Two right-angled tetrahedra, each of volume 1/6, of kinds (1,3).
  const Shares chain = shares_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}});
  ASSERT_EQ(chain.size(), 2U);
  for (const Names& contact : {Names{0, 1, 2, 3}, Names{1, 2, 3, 4}}) {
    Rational sum = 0;
    for (const Rational& part : chain.at(contact)) sum += part;
    EXPECT_EQ(sum, Rational(1, 6));
  }
  EXPECT_EQ(chain.at({0, 1, 2, 3})[4], 0);
}

}  // namespace
}  // namespace oracle::oracle_infinity_test
