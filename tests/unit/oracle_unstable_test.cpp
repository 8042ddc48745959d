// The oracle's λ-lists, worked out by hand: a whole circle, one with single directions and arcs, half circles, the
// directions of saddles of index 2, and none.
#include <gtest/gtest.h>

#include <stdexcept>

#include "oracle/unstable_set.h"
#include "tests/cites.h"

namespace oracle::oracle_unstable_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;

std::vector<UnstableEntry> list_of(const Rows& rows, const Names& contact) {
  for (const StationaryPoint& point : stationary_points(rows).stationary) {
    if (point.contact == contact) return lambda_list(PointSet(rows), point);
  }
  throw std::logic_error("no such stationary point");
}

// The contact sets of the limits, empty for infinity, with "arc" or "direction".
std::vector<std::pair<std::string, Names>> words_of(const std::vector<UnstableEntry>& list) {
  std::vector<std::pair<std::string, Names>> words;
  words.reserve(list.size());
  for (const UnstableEntry& entry : list) {
    words.emplace_back(entry.is_arc ? "arc" : "direction", entry.limit ? entry.limit->contact : Names{});
  }
  return words;
}

using Words = std::vector<std::pair<std::string, Names>>;

TEST(OracleUnstable, OfTwoPointsIsAWholeCircle) {
  CITES("FC-UNST-02");
  const auto list = list_of({{0, 0, 0}, {2, 0, 0}}, {0, 1});
  EXPECT_EQ(words_of(list), (Words{{"arc", {}}}));
  EXPECT_FALSE(list[0].from);
  EXPECT_FALSE(list[0].to);
}

// From the midpoint of points 1 and 2: two points of kind (1,2) by single directions, two of kind (1,3) by arcs.
TEST(OracleUnstable, OfAChainOfRightAngles) {
  CITES("FC-UNST-01", "FC-UNST-02");
  const auto list = list_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}}, {1, 2});
  EXPECT_EQ(words_of(list), (Words{{"direction", {0, 1, 2}},
                                   {"arc", {0, 1, 2, 3}},
                                   {"direction", {1, 2, 3}},
                                   {"arc", {1, 2, 3, 4}},
                                   {"direction", {1, 2, 3, 4}},
                                   {"arc", {}}}));
  // The edge goes along y, and point 2 has the greater name: seen from it, -x turns to z, and z to x.
  EXPECT_EQ(list[0].from, (Direction{-1, 0, 0}));
  EXPECT_EQ(list[2].from, (Direction{0, 0, 1}));
  // Here the ray meets the samples 3 and 4 at once, at the centre of the right triangle 1, 2, 4. All rays behind it
  // come to the edge of that triangle, and run away from the centre.
  EXPECT_EQ(list[4].from, (Direction{1, 0, 1}));
  for (std::size_t k = 0; k < list.size(); ++k) EXPECT_EQ(list[k].to, list[(k + 1) % list.size()].from);
}

TEST(OracleUnstable, OfRegularPointsIsAnArc) {
  CITES("FC-UNST-01");
  // Kind (1,2): points 0 and 1 are a diameter, and no direction leads towards point 2.
  const auto half = list_of({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}}, {0, 1, 2});
  ASSERT_EQ(words_of(half), (Words{{"direction", {}}, {"arc", {}}, {"direction", {}}}));
  EXPECT_EQ(half[0].from, (Direction{0, 0, 1}));
  EXPECT_EQ(half[2].from, (Direction{0, 0, -1}));
  // Kind (1,3): a quarter of a circle.
  const auto quarter = list_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3});
  ASSERT_EQ(words_of(quarter), (Words{{"direction", {}}, {"arc", {}}, {"direction", {}}}));
  EXPECT_EQ(quarter[0].from, (Direction{0, 0, -1}));
  EXPECT_EQ(quarter[2].from, (Direction{0, -1, 0}));
}

TEST(OracleUnstable, OfPolygonsIsTwoDirectionsOrOne) {
  CITES("FC-UNST-01");
  const Rows pyramid = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}};
  const auto base = list_of(pyramid, {0, 1, 2, 3});
  EXPECT_EQ(words_of(base), (Words{{"direction", {}}, {"direction", {0, 1, 2, 3, 4}}}));
  EXPECT_EQ(base[1].from, (Direction{0, 0, 1}));
  const Rows half_octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const auto down = list_of(half_octahedron, {0, 1, 2, 3, 4});
  EXPECT_EQ(words_of(down), (Words{{"direction", {}}}));
  EXPECT_EQ(down[0].from, (Direction{0, 0, -1}));
}

TEST(OracleUnstable, OfMaximaIsEmptyAndOfSamplesIsNone) {
  CITES("FC-UNST-01");
  const Rows rows = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  EXPECT_TRUE(list_of(rows, {0, 1, 2, 3}).empty());
  EXPECT_THROW((void)list_of(rows, {0}), std::invalid_argument);
}

}  // namespace
}  // namespace oracle::oracle_unstable_test
