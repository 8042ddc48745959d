// Locations by the oracle, worked out by hand: limits of each kind, samples, infinity, and ties of nearest samples.
#include <gtest/gtest.h>

#include <stdexcept>

#include "oracle/orbit.h"
#include "tests/cites.h"

namespace oracle::oracle_location_test {
namespace {

using Names = std::vector<std::size_t>;

const PointSet kCube({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}});

TEST(OracleLocation, InACube) {
  CITES("FC-LOC-01", "FC-LOC-03");
  const Names all = {0, 1, 2, 3, 4, 5, 6, 7};
  const Location inside = locate(kCube, {Rational(1, 2), Rational(1, 3), Rational(3, 4)});
  EXPECT_EQ(inside.limit->contact, all);
  EXPECT_EQ(inside.nearest, Names{0});
  // On a side of the cube a point flows to the centre of the side, and outside of the cube to infinity.
  const Location on_side = locate(kCube, {1, Rational(1, 3), 0});
  EXPECT_EQ(on_side.limit->contact, (Names{0, 1, 2, 3}));
  EXPECT_EQ(on_side.nearest, (Names{0, 1}));
  const Location outside = locate(kCube, {1, 1, -1});
  EXPECT_FALSE(outside.limit);
  EXPECT_EQ(outside.nearest, (Names{0, 1, 2, 3}));
  // On an edge of the cube.
  EXPECT_EQ(locate(kCube, {0, 0, Rational(1, 9)}).limit->contact, (Names{0, 4}));
}

TEST(OracleLocation, AStationaryPointIsItsOwn) {
  CITES("FC-LOC-01");
  for (const StationaryPoint& z : stationary_points(kCube).stationary) {
    EXPECT_EQ(locate(kCube, z.center), (Location{z, z.contact}));
  }
}

TEST(OracleLocation, ARegularPointAndRepeatedSamples) {
  CITES("FC-LOC-01");
  const PointSet set({{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {2, 2, 0}});
  const Location location = locate(set, {2, 1, 0});
  EXPECT_EQ(location.nearest, Names{3});
  EXPECT_EQ(location.limit->contact, (Names{0, 1, 3}));
  EXPECT_FALSE(location.limit->is_critical());
  EXPECT_EQ(locate(set, {0, 0, 0}).limit->contact, Names{0});
  EXPECT_FALSE(locate(set, {2, 0, 1}).limit);
}

TEST(OracleLocation, OfSmallSets) {
  CITES("FC-LOC-01", "FC-LOC-02");
  EXPECT_THROW(locate(PointSet({}), {0, 0, 0}), std::invalid_argument);
  const PointSet one({{1, 2, 3}});
  EXPECT_EQ(locate(one, {1, 2, 3}).limit->contact, Names{0});
  EXPECT_FALSE(locate(one, {1, 2, 4}).limit);
  EXPECT_EQ(locate(one, {1, 2, 4}).nearest, Names{0});
}

}  // namespace
}  // namespace oracle::oracle_location_test
