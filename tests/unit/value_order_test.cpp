// The order of distances, and of differences of two, by bounds in doubles: against sorted rationals.
//
// Guarantees: bounds are drawn that overlap often, are exact, or say nothing, and many numbers are equal, under one key
// or several. Numbers are drawn as rationals, and given as roots or as differences of roots of the same value.
#include "morse/value_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::value_order_test {
namespace {

using geometry::RootDifference;
using geometry::ValueRange;
using morse::ValueOrder;

struct Drawn {
  std::vector<Rational> values;
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> keys;
};

Drawn drawn(std::uint64_t seed) {
  flowcert_tests::PortableRandom random(seed);
  Drawn all;
  std::map<std::pair<Rational, bool>, std::uint64_t> key_of;
  const std::size_t count = random.below(60);
  for (std::size_t i = 0; i < count; ++i) {
    // Positive, often equal or nearly so.
    const Rational value =
        Rational(random.between(1, 12)) + Rational(random.between(0, 2)) / (Rational(1LL << 40) * 1048576);
    const double nearest = nearest_double(value).value();
    const double error = random.below(3) == 0 ? 4.0 : random.coin() ? 1e-9 : 1e-15 * nearest;
    all.values.push_back(value);
    all.ranges.push_back({std::max(0.0, nearest - error), random.below(20) == 0 ? HUGE_VAL : nearest + error});
    all.keys.push_back(key_of.try_emplace({value, random.below(4) == 0}, key_of.size()).first->second);
  }
  return all;
}

// The number as a difference of roots, or as one root.
RootDifference as_roots(const Rational& value, std::uint64_t key) {
  const Rational less(static_cast<long>(key % 3), 7);
  return {(value + less) * (value + less), less * less};
}
Rational square_of(const Rational& value) { return value * value; }

TEST(ValueOrder, IsThatOfTheExactNumbers) {
  CITES("FC-NUM-01");
  std::size_t equal = 0, gaps = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Drawn all = drawn(seed);
    const std::size_t size = all.values.size();
    const ValueOrder order(all.ranges, all.keys, [&](std::size_t i) { return as_roots(all.values[i], all.keys[i]); });
    ASSERT_EQ(order.size(), size);
    std::vector<std::size_t> expected(size);
    std::iota(expected.rbegin(), expected.rend(), std::size_t{0});
    std::ranges::stable_sort(expected, {}, [&](std::size_t i) { return all.values[i]; });
    for (std::size_t k = 0; k < size; ++k) {
      ASSERT_EQ(order.at(k), expected[k]) << "seed " << seed;
      EXPECT_EQ(order.exact(k), RootDifference{square_of(all.values[expected[k]])});
      equal += k > 0 && order.exact(k) == order.exact(k - 1) ? 1 : 0;
    }
    for (const Rational& bound : {Rational(0), Rational(5), Rational(13, 2), Rational(100)}) {
      const auto less = std::ranges::count_if(all.values, [&](const Rational& value) { return value < bound; });
      const auto not_greater = std::ranges::count_if(all.values, [&](const Rational& value) { return value <= bound; });
      EXPECT_EQ(order.count_below(square_of(bound)), static_cast<std::size_t>(less));
      EXPECT_EQ(order.count_up_to(square_of(bound)), static_cast<std::size_t>(not_greater));
    }
    if (size < 2) continue;
    std::optional<std::size_t> widest;
    for (std::size_t k = size / 3; k + 1 < size; ++k) {
      const auto ratio_at = [&](std::size_t at) {
        return Rational(order.square_from_above(at + 1) / order.square_from_above(at));
      };
      if (ratio_at(k) > (widest ? ratio_at(*widest) : Rational(1))) widest = k;
    }
    EXPECT_EQ(order.widest_gap(size / 3, size - 1), widest) << "seed " << seed;
    gaps += widest ? 1 : 0;
  }
  EXPECT_GT(equal, 3000U);
  EXPECT_GT(gaps, 300U);
}

TEST(ValueOrder, EqualNumbersHaveNoGap) {
  const std::vector<ValueRange> ranges(5, ValueRange{1, 3});
  const ValueOrder order(ranges, {0, 1, 2, 3, 4}, [](std::size_t) { return RootDifference{4}; });
  EXPECT_EQ(order.widest_gap(0, 4), std::nullopt);
  EXPECT_EQ(order.at(0), 4U);
  EXPECT_EQ(order.at(4), 0U);
}

// Of each key one is made, and none where the bounds decide.
TEST(ValueOrder, MakesOnlyWhatItNeeds) {
  std::vector<std::size_t> made;
  const auto exact = [&made](std::size_t i) {
    made.push_back(i);
    return RootDifference{Rational(static_cast<long>(i * i))};
  };
  const ValueOrder decided({{0, 0.5}, {1, 1.5}, {2, 2.5}}, {0, 1, 2}, exact);
  EXPECT_TRUE(made.empty());
  const ValueOrder open({{0, 2}, {0, 2}, {0, 2}, {5, 5}}, {7, 7, 8, 9}, exact);
  EXPECT_EQ(made.size(), 2U);
}

// From the least number up, each that is more than the width beyond the last one that was taken.
TEST(ValueOrder, CountsOnceWhatIsNear) {
  std::size_t taken = 0, dropped = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Drawn all = drawn(seed);
    const ValueOrder order(all.ranges, all.keys, [&](std::size_t i) { return as_roots(all.values[i], all.keys[i]); });
    for (const Rational& width : {Rational(0), Rational(1, 1LL << 50), Rational(1), Rational(5, 2)}) {
      std::vector<Rational> squares;
      for (std::size_t k = 0; k < order.size(); ++k) squares.push_back(order.square_from_above(k));
      std::ranges::sort(squares);
      std::vector<Rational> once;
      for (const Rational& square : squares) {
        if (once.empty() || RootDifference{square, once.back()} > RootDifference{width * width}) once.push_back(square);
      }
      const ValueOrder counted = order.from_above_once(width);
      ASSERT_EQ(counted.size(), once.size()) << "seed " << seed << ", width " << width;
      for (std::size_t k = 0; k < once.size(); ++k) EXPECT_EQ(counted.square_from_above(k), once[k]);
      taken += once.size();
      dropped += order.size() - once.size();
    }
  }
  EXPECT_GT(taken, 3000U);
  EXPECT_GT(dropped, 3000U);
}

}  // namespace
}  // namespace flowcert::value_order_test
