// Pockets by the oracle, worked out by hand: lattices, a tube with one open end, and a chain of index-2 points.
#include <gtest/gtest.h>

#include "oracle/fast/point_set.h"
#include "oracle/merge_tree.h"
#include "oracle/pockets.h"
#include "tests/cites.h"

namespace oracle::oracle_pockets_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;
using Places = std::vector<std::size_t>;

// Named otherwise than the function pockets().
struct Input {
  explicit Input(const Rows& rows) : set(rows), all(stationary_points(set).stationary) {}

  Pockets at(const Rational& persistence) const { return pockets(set, all, persistence * persistence); }
  const Rational& value(std::size_t place) const { return all[place].squared_distance; }
  std::vector<Names> contacts(const Places& places) const {
    std::vector<Names> result;
    for (const std::size_t place : places) result.push_back(all[place].contact);
    return result;
  }

  fast::PointSet set;
  std::vector<StationaryPoint> all;
};

// All corners of a box.
void add_box(Rows& rows, const std::array<double, 2>& xs, const std::array<double, 2>& ys,
             const std::array<double, 2>& zs) {
  for (const double x : xs) {
    for (const double y : ys) {
      for (const double z : zs) rows.push_back({x, y, z});
    }
  }
}

const Rows kOctahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// Three squares of edge 4, at distances of 2, and a point at 3 from the first: a tube with the axis z. The first 4
// samples are at z = 2.
Rows tube() {
  Rows rows;
  for (const double z : {2, 4, 6}) {
    for (const double x : {-2, 2}) {
      for (const double y : {-2, 2}) rows.push_back({x, y, z});
    }
  }
  rows.push_back({0, 0, -1});
  return rows;
}

TEST(OraclePockets, OfSetsWithoutMaxima) {
  CITES("FC-POCK-02", "FC-POCK-07", "FC-POCK-08");
  for (const Rows& rows : {Rows{}, Rows{{1, 2, 3}}, Rows{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                           Rows{{4, 0, 0}, {-4, 4, 0}, {-4, -4, 0}, {0, 0, 1}}}) {
    const Input input(rows);
    const Pockets found = input.at(0);
    EXPECT_EQ(found, Pockets{});
    EXPECT_FALSE(widest_path(found));
    EXPECT_TRUE(largest_balls(input.all, found).empty());
  }
}

TEST(OraclePockets, OfAnOctahedron) {
  CITES("FC-POCK-02", "FC-POCK-03", "FC-POCK-04", "FC-POCK-05", "FC-POCK-07", "FC-POCK-08");
  const Input input(kOctahedron);
  const Pockets found = input.at(Rational(183, 1000));
  ASSERT_EQ(found.pockets.size(), 1U);
  const Pocket& pocket = found.pockets[0];
  EXPECT_EQ(input.contacts(pocket.maxima), (std::vector<Names>{{0, 1, 2, 3, 4, 5}}));
  EXPECT_EQ(pocket.peaks, pocket.maxima);
  EXPECT_EQ(pocket.cell, pocket.maxima);
  EXPECT_EQ(pocket.mouths.size(), 8U);
  EXPECT_EQ(pocket.neighbours, Places{1});
  EXPECT_EQ(pocket.height - pocket.highest_mouth, Rational(1, 3));
  EXPECT_EQ(pocket.volume, Rational(4, 3));
  EXPECT_EQ(pocket.to_infinity, (WidestPath{Rational(2, 3), pocket.mouths}));
  EXPECT_EQ(widest_path(found), pocket.to_infinity);
  EXPECT_EQ(largest_balls(input.all, found), pocket.peaks);
  // The length of the pair, 1 less the root of 2/3, is between these.
  EXPECT_EQ(input.at(Rational(184, 1000)), (Pockets{{}, pocket.maxima}));
}

TEST(OraclePockets, WhatIsEqualToTheProbePasses) {
  CITES("FC-POCK-06");
  const Input input(kOctahedron);
  const Pocket pocket = input.at(0).pockets[0];
  EXPECT_EQ(passage(input.all, pocket, Rational(2, 3)), Passage::kChannel);
  EXPECT_EQ(passage(input.all, pocket, Rational(667, 1000)), Passage::kCavity);
  EXPECT_EQ(passage(input.all, pocket, 0), Passage::kChannel);
}

// Two unit cells: each has five squares to the outside, and one between them.
TEST(OraclePockets, OfTwoCellsOfALattice) {
  CITES("FC-POCK-02", "FC-POCK-03", "FC-POCK-04", "FC-POCK-07");
  Rows rows;
  add_box(rows, {0, 1}, {0, 1}, {0, 1});
  rows.insert(rows.end(), {{0, 0, 2}, {0, 1, 2}, {1, 0, 2}, {1, 1, 2}});
  const Input input(rows);
  const Pockets found = input.at(0);
  ASSERT_EQ(found.pockets.size(), 2U);
  for (const std::size_t k : {0U, 1U}) {
    const Pocket& pocket = found.pockets[k];
    EXPECT_EQ(pocket.mouths.size(), 6U);
    EXPECT_EQ(pocket.neighbours, (Places{1 - k, 2}));
    EXPECT_EQ(pocket.height - pocket.highest_mouth, Rational(1, 4));
    EXPECT_EQ(pocket.volume, 1);
    EXPECT_EQ(pocket.to_infinity.value, Rational(1, 2));
    EXPECT_EQ(pocket.to_infinity.gates.size(), 10U);  // also those of the other cell, through the square between them
  }
  EXPECT_EQ(largest_balls(input.all, found).size(), 2U);
  EXPECT_EQ(input.at(Rational(3, 20)), found);
  EXPECT_TRUE(input.at(Rational(4, 25)).pockets.empty());
}

// The ball has the radius 65, and the wider mouths, the two triangles, have 60.
TEST(OraclePockets, APairAsLongAsXIsNotLonger) {
  CITES("FC-POCK-02", "FC-PERS-06");
  Rows rows;
  for (const double x : {0.0, 50.0}) rows.insert(rows.end(), {{x, 60, 0}, {x, -36, 48}, {x, -36, -48}});
  const Input input(rows);
  ASSERT_EQ(input.at(0).pockets.size(), 1U);
  EXPECT_EQ(input.at(0).pockets[0].height, 65 * 65);
  EXPECT_EQ(input.at(0).pockets[0].highest_mouth, 60 * 60);
  EXPECT_EQ(input.at(Rational(4999, 1000)).pockets.size(), 1U);
  EXPECT_EQ(input.at(5).pockets.size(), 0U);
}

// The cell of edge 4: the tetrahedral holes are shallow at 8/3 if X is 0.1 or more, and lead to the octahedral hole and
// to the outside, through the midpoints of edges of the cell, which are regular stationary.
TEST(OraclePockets, OfAFaceCentredLattice) {
  CITES("FC-POCK-01", "FC-POCK-02", "FC-POCK-03", "FC-POCK-09");
  Rows rows = {{2, 2, 0}, {2, 2, 4}, {2, 0, 2}, {2, 4, 2}, {0, 2, 2}, {4, 2, 2}};
  add_box(rows, {0, 4}, {0, 4}, {0, 4});
  const Input input(rows);
  const Pockets found = input.at(0);
  ASSERT_EQ(found.pockets.size(), 9U);
  EXPECT_EQ(found.pockets[0].height - found.pockets[0].highest_mouth, Rational(4, 3));
  EXPECT_EQ(found.pockets[0].volume, Rational(32, 3));
  EXPECT_EQ(found.pockets[0].mouths.size(), 8U);
  EXPECT_EQ(found.pockets[0].neighbours, (Places{1, 2, 3, 4, 5, 6, 7, 8}));
  for (std::size_t k = 1; k < 9; ++k) {
    EXPECT_EQ(found.pockets[k].height - found.pockets[k].highest_mouth, Rational(1, 3));
    EXPECT_EQ(found.pockets[k].volume, Rational(8, 3));
    EXPECT_EQ(found.pockets[k].mouths.size(), 4U);
    EXPECT_EQ(found.pockets[k].neighbours, (Places{0, 9}));
  }
  EXPECT_EQ(widest_path(found)->value, Rational(8, 3));
  EXPECT_EQ(widest_path(found)->gates.size(), 24U);
  EXPECT_EQ(largest_balls(input.all, found), found.pockets[0].peaks);
  EXPECT_EQ(input.at(Rational(1, 10)), found);  // they stay apart
  EXPECT_TRUE(input.at(Rational(3, 8)).pockets.empty());
}

// On the axis of the tube the values are 289/36, 9 and 9, at the heights 11/6, 3 and 5; the squares between them have
// 8. The sides have 5 and, around the last sample, 289/52.
TEST(OraclePockets, OfATube) {
  CITES("FC-POCK-02", "FC-POCK-04", "FC-POCK-05", "FC-POCK-06", "FC-POCK-07", "FC-POCK-08");
  const Input input(tube());
  const Pockets three = input.at(0);
  ASSERT_EQ(three.pockets.size(), 3U);
  EXPECT_EQ(input.contacts(three.pockets[1].maxima), (std::vector<Names>{{0, 1, 2, 3, 12}}));
  EXPECT_EQ(three.pockets[1].height - three.pockets[1].highest_mouth, Rational(1, 36));
  EXPECT_EQ(three.pockets[1].neighbours, (Places{0, 3}));
  EXPECT_EQ(three.pockets[1].mouths.size(), 5U);

  const Pockets two = input.at(Rational(1, 200));
  ASSERT_EQ(two.pockets.size(), 2U);
  const Pocket &inner = two.pockets[0], &outer = two.pockets[1];
  EXPECT_EQ(input.contacts(inner.maxima), (std::vector<Names>{{0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 12}}));
  EXPECT_EQ(input.contacts(inner.peaks), (std::vector<Names>{{0, 1, 2, 3, 4, 5, 6, 7}}));
  EXPECT_EQ(input.contacts(outer.peaks), (std::vector<Names>{{4, 5, 6, 7, 8, 9, 10, 11}}));
  EXPECT_EQ(inner.height - inner.highest_mouth, 1);
  EXPECT_EQ(inner.volume, 32 + 16);
  EXPECT_EQ(outer.volume, 32);
  EXPECT_EQ(input.contacts(inner.to_infinity.gates), (std::vector<Names>{{8, 9, 10, 11}}));
  EXPECT_EQ(inner.to_infinity.value, 8);
  EXPECT_EQ(passage(input.all, inner, 8), Passage::kPocket);
  EXPECT_EQ(passage(input.all, outer, 8), Passage::kChannel);
  EXPECT_EQ(passage(input.all, inner, Rational(289, 52)), Passage::kChannel);
  EXPECT_EQ(passage(input.all, outer, Rational(801, 100)), Passage::kCavity);
  EXPECT_EQ(input.contacts(largest_balls(input.all, two)), input.contacts({inner.peaks[0], outer.peaks[0]}));

  const Pockets none = input.at(Rational(172, 1000));
  EXPECT_TRUE(none.pockets.empty());
  EXPECT_EQ(none.outside.size(), 3U);
}

// {0,1,2} and {1,2,4} lead to the centre of {0,3,4}, which is between both maxima, and to infinity.
TEST(OraclePockets, WithAChainOfIndexTwoPoints) {
  CITES("FC-POCK-01", "FC-POCK-03", "FC-POCK-04");
  const Input input({{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}});
  const Pockets found = input.at(0);
  ASSERT_EQ(found.pockets.size(), 2U);
  EXPECT_EQ(input.contacts(found.pockets[0].maxima), (std::vector<Names>{{0, 1, 3, 4}}));
  EXPECT_EQ(input.contacts(found.pockets[0].mouths),
            (std::vector<Names>{{0, 1, 2}, {0, 1, 3}, {0, 3, 4}, {1, 2, 4}, {1, 3, 4}}));
  EXPECT_EQ(found.pockets[0].neighbours, (Places{1, 2}));
  EXPECT_EQ(found.pockets[0].height - found.pockets[0].highest_mouth, Rational(265885, 5184) - Rational(658255, 12842));
  EXPECT_EQ(found.pockets[0].volume, found.pockets[1].volume);
  const auto chain = std::find_if(input.all.begin(), input.all.end(),
                                  [](const StationaryPoint& z) { return z.contact == Names{0, 1, 2}; });
  EXPECT_EQ(pockets_above(input.set, input.all, found, *chain), (Places{0, 1, 2}));
  EXPECT_EQ(pockets_above(input.set, input.all, found, std::nullopt), Places{2});
}

}  // namespace
}  // namespace oracle::oracle_pockets_test
