// The medial axis by the oracle, worked out by hand: angles, persistence, and what lies on the unstable sets.
#include <gtest/gtest.h>

#include "oracle/medial_axis.h"
#include "tests/cites.h"

namespace oracle::oracle_medial_axis_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;

const Rows kOctahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const Rows kCube = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

std::vector<StationaryPoint> of_index(const std::vector<StationaryPoint>& all, int index) {
  std::vector<StationaryPoint> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found),
               [&](const StationaryPoint& z) { return z.is_critical() && z.hull_dimension == index; });
  return found;
}

TEST(OracleMedialAxis, AnglesAreToldByRationalCosines) {
  CITES("FC-MED-02");
  const PointSet octahedron(kOctahedron), cube(kCube);
  const auto all = stationary_points(octahedron).stationary;
  for (const StationaryPoint& z : of_index(all, 1)) EXPECT_EQ(contact_cosine(octahedron, z), -1);
  for (const StationaryPoint& z : of_index(all, 2)) EXPECT_EQ(contact_cosine(octahedron, z), Rational(-1, 2));
  for (const StationaryPoint& z : of_index(stationary_points(cube).stationary, 2)) {
    EXPECT_EQ(contact_cosine(cube, z), -1);
  }
  // What is at 120 degrees is not above them.
  EXPECT_EQ(above_angle(octahedron, all, Rational(-1, 2)).size(), 12U);
  EXPECT_EQ(above_angle(octahedron, all, Rational(-49, 100)).size(), 20U);
  EXPECT_TRUE(above_angle(octahedron, all, -1).empty());
}

// Of the cube: 7 of 12 edges join samples, 5 begin tunnels, which 5 of 6 squares fill; the sixth makes the void.
TEST(OracleMedialAxis, PairsTellHowManyPointsAreAboveAPersistence) {
  CITES("FC-MED-03");
  const std::vector<PersistencePair> pairs = persistence_pairs(PointSet(kCube));
  // The roots of 1/4, 1/2 and 3/4 are 0.5, 0.707 and 0.866; the last numbers here are squares.
  EXPECT_EQ(count_above_persistence(pairs, 1, Rational(1, 4), Rational(1, 25)), 12U);
  EXPECT_EQ(count_above_persistence(pairs, 1, Rational(1, 4), Rational(1, 20)), 7U);
  EXPECT_EQ(count_above_persistence(pairs, 1, Rational(1, 4), Rational(1, 4)), 0U);
  EXPECT_EQ(count_above_persistence(pairs, 2, Rational(1, 2), 0), 6U);
  EXPECT_EQ(count_above_persistence(pairs, 2, Rational(1, 2), Rational(1, 36)), 5U);
  EXPECT_EQ(count_above_persistence(pairs, 2, Rational(1, 2), Rational(1, 4)), 0U);
  EXPECT_EQ(count_above_persistence(pairs, 2, Rational(1, 3), 0), 0U);
}

// Of a square, U2 is the axis, and U1 of an edge is a half plane: the other way it goes to infinity, too.
TEST(OracleMedialAxis, OfASquare) {
  CITES("FC-MED-01");
  const PointSet set({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}});
  const auto all = stationary_points(set).stationary;
  const auto squares = of_index(all, 2), edges = of_index(all, 1);
  ASSERT_EQ(squares.size(), 1U);
  for (const int z : {-7, 0, 7}) EXPECT_TRUE(in_medial_axis(set, squares, {0, 0, z}));
  EXPECT_FALSE(in_medial_axis(set, squares, {1, 0, 0}));
  EXPECT_FALSE(in_medial_axis(set, squares, {0, Rational(1, 9), 5}));
  for (const Point& x : {Point{3, 0, 5}, Point{0, -2, -1}, Point{0, 0, 4}, Point{0, 0, 0}}) {
    EXPECT_TRUE(in_medial_axis(set, edges, x));
  }
  EXPECT_FALSE(in_medial_axis(set, edges, {1, 2, 0}));
  EXPECT_FALSE(in_medial_axis(set, {}, {0, 0, 0}));
}

// The orbits of U2 from a triangle of the octahedron: to the centre, and to infinity.
TEST(OracleMedialAxis, OfAnOctahedron) {
  CITES("FC-MED-01");
  const PointSet set(kOctahedron);
  const auto all = stationary_points(set).stationary;
  const auto triangles = of_index(all, 2);
  ASSERT_EQ(triangles[0].contact, (Names{0, 2, 4}));
  const std::vector<StationaryPoint> one = {triangles[0]};
  for (const Rational& t : {Rational(0), Rational(1, 4), Rational(1, 3), Rational(5)}) {
    EXPECT_TRUE(in_medial_axis(set, one, {t, t, t}));
  }
  EXPECT_FALSE(in_medial_axis(set, one, {-1, -1, -1}));
  EXPECT_TRUE(in_medial_axis(set, triangles, {-1, -1, -1}));
  EXPECT_FALSE(in_medial_axis(set, triangles, {Rational(1, 4), Rational(1, 4), 0}));
  EXPECT_TRUE(in_medial_axis(set, of_index(all, 1), {Rational(1, 4), Rational(1, 4), 0}));
}

// In (0,5,0), (-3,0,-2), (3,0,-2), (0,0,12), (0,-5,0) the orbit from {0,1,2} goes on to the centre of {0,3,4}, in
// several segments. It ends there, at height 119/24.
TEST(OracleMedialAxis, OrbitsOfSeveralSegments) {
  CITES("FC-MED-01");
  const PointSet set({{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}});
  const auto all = stationary_points(set).stationary;
  const auto first = std::find_if(all.begin(), all.end(), [](const auto& z) { return z.contact == Names{0, 1, 2}; });
  ASSERT_NE(first, all.end());
  EXPECT_TRUE(in_medial_axis(set, {*first}, {0, 0, Rational(119, 24)}));
  EXPECT_TRUE(in_medial_axis(set, {*first}, {0, 0, 4}));
  EXPECT_FALSE(in_medial_axis(set, {*first}, {0, 0, 5}));
  EXPECT_FALSE(in_medial_axis(set, {*first}, {1, 0, 4}));
}

}  // namespace
}  // namespace oracle::oracle_medial_axis_test
