// Doubles beside differences and sums of roots, judged by the oracle: right ones, their neighbours, and exact cases.
#include <gtest/gtest.h>

#include <cmath>

#include "fuzz/judge/root_sum.h"
#include "oracle/pockets.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/property/root_differences.h"

namespace oracle::oracle_roots_test {
namespace {

using flowcert::judge::is_root_sum;
using Rows = std::vector<std::array<double, 3>>;

TEST(OracleRoots, DifferencesAreComparedExactly) {
  CITES("FC-POCK-11");
  EXPECT_EQ(compare_root_difference(9, 4, 1), 0);
  EXPECT_EQ(compare_root_difference(9, 4, Rational(99, 100)), 1);
  EXPECT_EQ(compare_root_difference(9, 4, Rational(101, 100)), -1);
  EXPECT_EQ(compare_root_difference(4, 9, -1), 0);
  EXPECT_EQ(compare_root_difference(4, 9, -2), 1);
  EXPECT_EQ(compare_root_difference(4, 9, -4), 1);
  EXPECT_EQ(compare_root_difference(0, 9, -3), 0);
  EXPECT_EQ(compare_root_difference(1, 9, -3), 1);
  EXPECT_EQ(compare_root_difference(9, 0, 2), 1);
  EXPECT_EQ(compare_root_difference(9, 0, 4), -1);
  EXPECT_EQ(compare_root_difference(8, 2, 1), 1);  // sqrt(2)
  EXPECT_EQ(compare_root_difference(8, 2, 2), -1);
}

TEST(OracleRoots, OneDoubleIsNearest) {
  CITES("FC-POCK-11");
  const double root = std::sqrt(2.0);  // rounded correctly
  EXPECT_TRUE(is_nearest_root_difference(root, 8, 2));
  EXPECT_FALSE(is_nearest_root_difference(std::nextafter(root, 2), 8, 2));
  EXPECT_FALSE(is_nearest_root_difference(std::nextafter(root, 1), 8, 2));
  EXPECT_TRUE(is_nearest_root_difference(1, 9, 4));
  EXPECT_FALSE(is_nearest_root_difference(INFINITY, 9, 4));
  // A difference of two roots that have one nearest double.
  const Rational close = 2 + Rational(1) / Rational(Integer(1) << 60);
  EXPECT_FALSE(is_nearest_root_difference(0, close, 2));
  EXPECT_TRUE(is_nearest_root_difference(std::ldexp(root, -62), close, 2));
}

TEST(OracleRoots, SumsMayDifferByASmallShare) {
  CITES("FC-POCK-11");
  EXPECT_TRUE(is_root_sum(0, {}));
  EXPECT_TRUE(is_root_sum(0, {0, 0}));
  EXPECT_FALSE(is_root_sum(0, {1}));
  EXPECT_FALSE(is_root_sum(1, {}));
  EXPECT_TRUE(is_root_sum(3, {1, 4}));
  EXPECT_TRUE(is_root_sum(3 * (1 + std::ldexp(1, -41)), {1, 4}));
  EXPECT_FALSE(is_root_sum(3 * (1 + std::ldexp(1, -39)), {1, 4}));
  EXPECT_FALSE(is_root_sum(3 * (1 - std::ldexp(1, -39)), {1, 4}));
  EXPECT_TRUE(is_root_sum(std::sqrt(2.0) + std::sqrt(3.0), {2, 3}));
  EXPECT_TRUE(is_root_sum(std::sqrt(2e-300), {Rational(2e-300)}));
}

// Each triangle of an octahedron is cut into six, with 3/4 as the square of the whole area.
TEST(OracleRoots, AnAreaOfAMouth) {
  CITES("FC-POCK-04", "FC-POCK-11");
  const PointSet set(Rows{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  const auto all = stationary_points(set).stationary;
  const Pocket pocket = pockets(set, all, 0).pockets.at(0);
  for (const std::size_t mouth : pocket.mouths) {
    const std::vector<Rational> squares = squared_areas(set, stable_set(set, all[mouth]));
    EXPECT_EQ(squares, std::vector<Rational>(6, Rational(1, 48)));
    EXPECT_TRUE(is_root_sum(std::sqrt(0.75), squares));
  }
  EXPECT_TRUE(is_nearest_root_difference(1 - std::sqrt(2.0 / 3), 1, Rational(2, 3)));
}

}  // namespace
}  // namespace oracle::oracle_roots_test
