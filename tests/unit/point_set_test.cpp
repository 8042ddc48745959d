// The input as everything else sees it: what PointSet refuses, what it merges and how it names the classes;
// and exact_sphere(), the smallest sphere through a few of its points.
//
// exact_sphere is compared with its definition in rationals: all points are at one distance from the centre,
// and the centre is in their affine hull.
#include "flowcert/point_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/stationary_points.h"
#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"
#include "tests/unit/rational_geometry.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::point_set_test {
namespace {

using flowcert_tests::determinant;
using flowcert_tests::exactly;
using flowcert_tests::inner;
using flowcert_tests::minus;
using flowcert_tests::normal_of;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

TEST(PointSetTest, RefusesCoordinatesThatAreNotFinite) {
  CITES("FC-IN-01");
  for (const double bad : {std::nan(""), -std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<Point> rows(3, Point{1, 2, 3});
      flowcert_tests::coordinate_of(rows[2], axis) = bad;
      try {
        const PointSet set(rows);
        ADD_FAILURE() << bad << " was taken";
      } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("point 2"), std::string::npos) << error.what();
      }
    }
  }
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(PointSet(std::vector<Point>{{largest, -largest, 0}}).size(), 1u);
}

TEST(PointSetTest, MergesEqualRowsUnderTheSmallestId) {
  CITES("FC-IN-03");
  const std::vector<Point> rows = {{5, 5, 5}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {5, 5, 5}, {1, 1, 1}, {0, 0, 0}};
  const PointSet set(rows);
  EXPECT_EQ(set.row_count(), 7u);
  EXPECT_EQ(set.size(), 4u);
  EXPECT_EQ(set.merged_duplicates(), 3u);
  // Positions ascend with names, whatever the coordinates.
  const std::vector<PointId> names = {0, 1, 2, 5};
  for (std::size_t k = 0; k < names.size(); ++k) {
    EXPECT_EQ(set.name(k), names[k]);
    EXPECT_EQ(set[k], rows[names[k]]);
  }
  const std::vector<std::size_t> positions = {0, 1, 2, 1, 0, 3, 1};
  for (PointId row = 0; row < rows.size(); ++row) EXPECT_EQ(set.ordinal_of_row(row), positions[row]);
  EXPECT_EQ(set.repeated_classes(), (std::vector<std::vector<PointId>>{{0, 4}, {1, 3, 6}}));
}

TEST(PointSetTest, AZerosSignIsNoCoordinate) {
  CITES("FC-IN-02", "FC-IN-03");
  const PointSet set(std::vector<Point>{{-0.0, 0.0, -0.0}, {0.0, -0.0, 0.0}, {1, -0.0, 1}});
  EXPECT_EQ(set.size(), 2u);
  EXPECT_EQ(set.repeated_classes(), (std::vector<std::vector<PointId>>{{0, 1}}));
  for (const Point& p : set.points()) {
    EXPECT_FALSE(std::signbit(p.x) || std::signbit(p.y) || std::signbit(p.z));
  }
}

TEST(PointSetTest, NothingElseIsMerged) {
  CITES("FC-IN-02", "FC-IN-03");
  const double tiny = std::numeric_limits<double>::denorm_min();
  const PointSet set(
      std::vector<Point>{{1, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}, {0, 0, 0}, {0, tiny, 0}, {0, -tiny, 0}});
  EXPECT_EQ(set.size(), 5u);
  EXPECT_EQ(set.merged_duplicates(), 0u);
  EXPECT_TRUE(set.repeated_classes().empty());
  EXPECT_EQ(set[1].x, std::nextafter(1.0, 2.0));
  EXPECT_EQ(set[4].y, -tiny);
}

// Compares with a map from coordinates to rows.
TEST(PointSetTest, RandomRowsWithManyRepetitions) {
  CITES("FC-IN-03");
  PortableRandom random(21);
  for (int run = 0; run < 300; ++run) {
    std::vector<Point> rows(random.below(60));
    for (Point& p : rows)
      p = {double(random.between(-1, 1)), double(random.between(-1, 1)), random.coin() ? 0.0 : -0.0};
    const PointSet set(rows);
    std::map<std::tuple<double, double>, std::vector<PointId>> classes;
    for (PointId row = 0; row < rows.size(); ++row) classes[{rows[row].x, rows[row].y}].push_back(row);
    std::map<PointId, std::vector<PointId>> repeated;
    for (const auto& [key, members] : classes) {
      for (const PointId row : members) {
        ASSERT_EQ(set.name(set.ordinal_of_row(row)), members.front());
        ASSERT_EQ(set[set.ordinal_of_row(row)], rows[row]);
      }
      if (members.size() > 1) repeated[members.front()] = members;
    }
    ASSERT_EQ(set.size(), classes.size());
    ASSERT_EQ(set.merged_duplicates(), rows.size() - classes.size());
    std::vector<std::vector<PointId>> expected;
    expected.reserve(repeated.size());
    for (const auto& [name, members] : repeated) expected.push_back(members);
    ASSERT_EQ(set.repeated_classes(), expected);
    for (std::size_t k = 1; k < set.size(); ++k) ASSERT_LT(set.name(k - 1), set.name(k));
  }
}

TEST(PointSetTest, TheEmptySetHasAnAnswer) {
  CITES("FC-IN-04", "FC-INV-01");
  for (const PointSet& set : {PointSet(), PointSet(std::vector<Point>{})}) {
    EXPECT_TRUE(set.empty());
    EXPECT_EQ(set.row_count(), 0u);
    EXPECT_EQ(set.merged_duplicates(), 0u);
    EXPECT_TRUE(set.repeated_classes().empty());
    const VoronoiDiagram diagram{Delaunay(set)};
    EXPECT_EQ(diagram.dimension(), -1);
    const StationaryPoints none = stationary_points(diagram);
    EXPECT_EQ(none.size(), 0u);
    EXPECT_EQ(none.euler_sum(), 0);
  }
}

RationalPoint rational_point(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z}; }

ExactSphere sphere_of_all(const std::vector<Point>& rows) {
  const PointSet set(rows);
  std::vector<PointId> ids(rows.size());
  std::iota(ids.begin(), ids.end(), PointId{0});
  return exact_sphere(set, ids);
}

TEST(ExactSphereTest, OfFewPoints) {
  CITES("FC-OUT-01");
  const ExactSphere one = sphere_of_all({{1, 2, 3}});
  EXPECT_EQ(one.center, rational_point(1, 2, 3));
  EXPECT_EQ(one.squared_radius, 0);
  const ExactSphere two = sphere_of_all({{0, 0, 0}, {1, 0, 2}});
  EXPECT_EQ(two.center, rational_point(Rational(1) / 2, 0, 1));
  EXPECT_EQ(two.squared_radius, Rational(5) / 4);
  const ExactSphere three = sphere_of_all({{1, 1, 0}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_EQ(three.center, rational_point(Rational(2) / 3, Rational(2) / 3, Rational(2) / 3));
  EXPECT_EQ(three.squared_radius, Rational(2) / 3);
  const ExactSphere four = sphere_of_all({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(four.center, rational_point(Rational(1) / 2, Rational(1) / 2, Rational(1) / 2));
  EXPECT_EQ(four.squared_radius, Rational(3) / 4);
  EXPECT_THROW((void)exact_sphere(PointSet(), {}), std::invalid_argument);
}

// More points than the sphere needs; the first ones do not span the hull, and ids are names after merging.
TEST(ExactSphereTest, OfCosphericalSupersets) {
  CITES("FC-OUT-01", "FC-IN-03");
  const ExactSphere square = sphere_of_all({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}});
  EXPECT_EQ(square.center, rational_point(Rational(1) / 2, Rational(1) / 2, 5));
  EXPECT_EQ(square.squared_radius, Rational(1) / 2);
  const ExactSphere pyramid = sphere_of_all({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
  EXPECT_EQ(pyramid.center, rational_point(0, 0, 0));
  EXPECT_EQ(pyramid.squared_radius, 1);
  const PointSet set(std::vector<Point>{{9, 9, 9}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}});
  const std::vector<PointId> pair = {2, 3};
  EXPECT_EQ(exact_sphere(set, pair).center, rational_point(2, 0, 0));
}

// Three points on a line have no circle; the answer is then the sphere of the first two, and the caller sees
// that the third is not on it.
TEST(ExactSphereTest, OfCollinearPoints) {
  CITES("FC-CRIT-05");
  const ExactSphere sphere = sphere_of_all({{0, 0, 0}, {2, 2, 2}, {6, 6, 6}});
  EXPECT_EQ(sphere.center, rational_point(1, 1, 1));
  EXPECT_EQ(sphere.squared_radius, 3);
}

TEST(ExactSphereTest, MeetsItsDefinition) {
  CITES("FC-CRIT-05", "FC-OUT-01");
  PortableRandom random(22);
  int checked = 0;
  for (const TupleKind kind : flowcert_tests::kTupleKinds) {
    for (int run = 0; run < 200; ++run) {
      const auto tuple = flowcert_tests::draw_tuple<4>(kind, random);
      const std::size_t count = 1 + random.below(4);
      const std::vector<Point> rows(tuple.begin(), tuple.begin() + static_cast<std::ptrdiff_t>(count));
      std::vector<RationalPoint> p;
      p.reserve(count);
      for (const Point& row : rows) p.push_back(exactly(row));
      // Only affinely independent points, which always have a sphere.
      if (count == 2 && p[0] == p[1]) continue;
      if (count == 3 && inner(normal_of(p[0], p[1], p[2]), normal_of(p[0], p[1], p[2])) == 0) continue;
      if (count == 4 && determinant(minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0])) == 0) continue;
      const ExactSphere sphere = sphere_of_all(rows);
      for (const RationalPoint& q : p) {
        ASSERT_EQ(flowcert_tests::squared_distance(q, sphere.center), sphere.squared_radius);
      }
      const RationalPoint from_first = minus(sphere.center, p[0]);
      if (count == 2) {
        const RationalPoint off_line = normal_of(p[0], p[1], sphere.center);
        ASSERT_EQ(inner(off_line, off_line), 0);
      }
      if (count == 3) {
        ASSERT_EQ(inner(normal_of(p[0], p[1], p[2]), from_first), 0);
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 1200);
}

}  // namespace
}  // namespace flowcert::point_set_test
