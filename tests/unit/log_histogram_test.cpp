// The histogram of lengths and its valley: against the words of the specification, on lists of every shape.
//
// Guarantees: lists are drawn with one heap, two, or many, of every width; most of them meet edges of bins exactly. The
// run fails if valleys, or histograms without one, are rare.
#include "morse/log_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "tests/cites.h"
#include "tests/exact_valley.h"
#include "tests/unit/portable_random.h"

namespace flowcert::log_histogram_test {
namespace {

using flowcert_tests::PortableRandom;
using geometry::ValueRange;
using morse::ValueOrder;

// Each with a doubtful bound or none, as those of critical points are.
ValueOrder order_of(const std::vector<Rational>& squares) {
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> keys(squares.size());
  std::iota(keys.begin(), keys.end(), std::uint64_t{0});
  ranges.reserve(squares.size());
  for (const Rational& square : squares) {
    const double nearest = std::sqrt(nearest_double(square).value());
    ranges.push_back({nearest * (1 - 1e-12), nearest * (1 + 1e-12)});
  }
  return {ranges, keys, [squares](std::size_t i) { return geometry::RootDifference{squares[i]}; }};
}

Rational power_of_ten(int exponent) {
  const Rational power = pow(boost::multiprecision::mpz_int(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(1 / power) : power;
}

// Heaps around numbers that are `apart` powers of ten from each other at most; some lengths are 0.
std::vector<Rational> drawn_squares(PortableRandom& random) {
  std::vector<Rational> squares;
  const int apart = random.coin() ? 1 : random.between(1, 60);
  const std::size_t heaps = random.below(5);
  for (std::size_t heap = 0; heap < heaps; ++heap) {
    const Rational base = power_of_ten(random.between(-apart, apart));
    const int width = random.between(1, 400);
    const std::size_t size = random.below(60);
    for (std::size_t i = 0; i < size; ++i) {
      const Rational root = base * Rational(100 + random.between(0, width), 100);
      squares.push_back(root * root);
    }
  }
  for (std::size_t zeros = random.below(3); zeros > 0; --zeros) squares.emplace_back(0);
  for (std::size_t i = squares.size(); i > 1; --i) std::swap(squares[i - 1], squares[random.below(i)]);
  return squares;
}

TEST(LogHistogram, BinsAndValleyAreThoseOfTheSpecification) {
  std::size_t valleys = 0, without = 0, coarse = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    PortableRandom random(seed);
    const std::vector<Rational> squares = drawn_squares(random);
    const Rational unit = random.coin() ? Rational(1) : Rational(random.between(1, 90), 7);
    const ValueOrder order = order_of(squares);
    const std::vector<HistogramBin> bins = morse::log_histogram(order, unit);
    const std::vector<HistogramBin> expected = flowcert_tests::exact_histogram(squares, unit);
    ASSERT_EQ(bins.size(), expected.size()) << "seed " << seed;
    for (std::size_t k = 0; k < bins.size(); ++k) {
      ASSERT_EQ(bins[k].from, expected[k].from) << "seed " << seed;
      ASSERT_EQ(bins[k].to, expected[k].to) << "seed " << seed;
      ASSERT_EQ(bins[k].count, expected[k].count) << "seed " << seed;
    }
    const auto found = morse::placed_valley(order, unit);
    const auto threshold = flowcert_tests::exact_threshold(squares, unit);
    ASSERT_EQ(found.has_value(), threshold.has_value()) << "seed " << seed;
    coarse += !bins.empty() && bins.front().to >= 10 * bins.front().from ? 1 : 0;
    ++(found ? valleys : without);
    if (!found) continue;
    EXPECT_EQ(order.square_from_above(found->last_below), threshold->first) << "seed " << seed;
    EXPECT_EQ(order.square_from_above(found->last_below + 1), threshold->second) << "seed " << seed;
    EXPECT_EQ(found->valley.below, found->last_below + 1) << "seed " << seed;
    EXPECT_EQ(found->valley.below + found->valley.beyond, squares.size()) << "seed " << seed;
    const auto valley_bin = flowcert_tests::exact_valley(expected);
    EXPECT_EQ(found->valley.bin.from, expected.at(valley_bin.value()).from) << "seed " << seed;
  }
  EXPECT_GT(valleys, 300U);
  EXPECT_GT(without, 300U);
  EXPECT_GT(coarse, 100U);
}

// By hand. One bin of ten steps holds 1 to 1.25, and the next ones end at 1.6 and 2.
std::vector<Rational> heaps_of(std::size_t first, std::size_t between, std::size_t second) {
  std::vector<Rational> squares(first, Rational(1));
  squares.insert(squares.end(), between, Rational(169, 100));  // 1.3^2
  squares.insert(squares.end(), second, Rational(3));
  return squares;
}

TEST(LogHistogram, AValleyNeedsASecondHeapThatIsNoChance) {
  const auto has_valley = [](std::size_t first, std::size_t between, std::size_t second) {
    return morse::placed_valley(order_of(heaps_of(first, between, second)), 1).has_value();
  };
  EXPECT_FALSE(has_valley(0, 0, 0));
  EXPECT_FALSE(has_valley(20, 0, 9));  // 9 * 9 = 9 * (9 + 0)
  EXPECT_TRUE(has_valley(20, 0, 10));
  EXPECT_FALSE(has_valley(20, 5, 18));  // 13 * 13 < 9 * 23
  EXPECT_TRUE(has_valley(30, 5, 21));
  EXPECT_FALSE(has_valley(900, 400, 799));  // less than twice as many
  EXPECT_TRUE(has_valley(900, 400, 800));
  EXPECT_FALSE(has_valley(30, 31, 300));  // the highest bin is the last one
}

}  // namespace
}  // namespace flowcert::log_histogram_test
