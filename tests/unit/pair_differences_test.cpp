// pair_differences() on pairs made by hand: exact values, decimals within the tolerance and beyond it, pairs that are
// as good as none, and near values that must not take each other's place.
#include "certify/pair_differences.h"

#include <gtest/gtest.h>

#include "tests/cites.h"

namespace flowcert::pair_differences_test {
namespace {

using Claimed = std::vector<ClaimedPair>;
using Truth = std::vector<ListedPair>;

ClaimedNumber decimal(const Rational& value) { return {value, false}; }
ClaimedNumber exact(const Rational& value) { return {value, true}; }
Rational parts(long count) { return Rational(count) / Rational(10000000000L); }  // of 10^-10

std::size_t wrong(const Claimed& claimed, const Truth& truth, double tolerance = 1e-9) {
  return pair_differences(claimed, truth, tolerance).size();
}

TEST(PairDifferences, WhatIsExactIsEqual) {
  CITES("FC-CLAIM-11");
  const Truth truth = {{1, 1, Rational(2)}, {1, 1, Rational(2)}, {0, 0, std::nullopt}};
  const ClaimedPair pair{1, exact(1), exact(2)}, lasts{0, exact(0), std::nullopt};
  EXPECT_EQ(wrong({lasts, pair, pair}, truth), 0U);
  EXPECT_EQ(wrong({pair, pair}, truth), 1U);
  EXPECT_EQ(wrong({lasts, pair}, truth), 1U);
  EXPECT_EQ(wrong({lasts, pair, pair, pair}, truth), 1U);
  EXPECT_EQ(wrong({lasts, pair, {1, exact(1), exact(2 + parts(1))}}, truth), 1U);
  EXPECT_EQ(wrong({lasts, pair, {2, exact(1), exact(2)}}, truth), 2U) << "one of each dimension";
  EXPECT_EQ(wrong({lasts, pair, {0, exact(1), exact(2)}}, truth), 2U) << "one of each dimension";
  EXPECT_EQ(wrong({lasts, pair, pair, {2, exact(3), exact(3)}}, truth), 0U) << "of length zero";
  EXPECT_EQ(wrong({lasts, pair, pair, {2, exact(3), exact(3 + parts(1))}}, truth), 1U);
  EXPECT_EQ(wrong({lasts, pair}, {{1, 1, Rational(2)}, {1, 5, 5 + parts(1)}, {0, 0, std::nullopt}}), 1U);
}

TEST(PairDifferences, DecimalsAreRightWithinTheTolerance) {
  CITES("FC-CLAIM-05", "FC-CLAIM-11");
  const Truth truth = {{1, 1, Rational(2)}, {0, 0, std::nullopt}};
  const auto with = [&](const Rational& birth, const Rational& death) {
    return wrong({{0, decimal(0), std::nullopt}, {1, decimal(birth), decimal(death)}}, truth);
  };
  EXPECT_EQ(with(1, 2), 0U);
  EXPECT_EQ(with(1 + parts(10), 2 - parts(20)), 0U);
  EXPECT_EQ(with(1 + parts(11), 2), 1U);
  EXPECT_EQ(with(1, 2 + parts(21)), 1U);
  // Infinity is for infinity alone, and for no large number.
  EXPECT_EQ(wrong({{0, decimal(0), decimal(Rational(1) / parts(1))}, {1, decimal(1), decimal(2)}}, truth), 1U);
  EXPECT_EQ(wrong({{0, decimal(0), std::nullopt}, {1, decimal(1), std::nullopt}}, truth), 1U);
  // Zero has no magnitude.
  EXPECT_EQ(wrong({{0, decimal(parts(1)), std::nullopt}, {1, decimal(1), decimal(2)}}, truth), 1U);
}

TEST(PairDifferences, ShortPairsAreAsGoodAsNone) {
  CITES("FC-CLAIM-11");
  const ClaimedPair lasts{0, decimal(0), std::nullopt};
  const Truth alone = {{0, 0, std::nullopt}}, with_short = {{0, 0, std::nullopt}, {1, 1, 1 + parts(20)}},
              with_long = {{0, 0, std::nullopt}, {1, 1, 1 + parts(21)}};
  EXPECT_EQ(wrong({lasts}, with_short), 0U);
  EXPECT_EQ(wrong({lasts}, with_long), 1U);
  EXPECT_EQ(wrong({lasts, {1, decimal(1), decimal(1 + parts(20))}}, alone), 0U);
  EXPECT_EQ(wrong({lasts, {1, decimal(1), decimal(1 + parts(21))}}, alone), 1U);
  EXPECT_EQ(wrong({lasts, {1, exact(1), exact(1 + parts(20))}}, alone), 1U) << "claimed exactly";
  EXPECT_EQ(wrong({lasts, {1, decimal(1 + parts(20)), decimal(1)}}, alone), 1U) << "dies before it is born";
}

// Two claimed values may be near one true value. One of them at most is its partner.
TEST(PairDifferences, NearValuesDoNotTakeEachOthersPlace) {
  CITES("FC-CLAIM-11");
  const auto of = [](const std::vector<long>& deaths) {
    Claimed pairs;
    for (const long death : deaths) pairs.push_back({1, decimal(Rational(1) / 2), decimal(1 + parts(death))});
    return pairs;
  };
  const Truth truth = {{1, Rational(1) / 2, Rational(1)}, {1, Rational(1) / 2, 1 + parts(15)}};
  EXPECT_EQ(wrong(of({8, 0}), truth), 0U);
  EXPECT_EQ(wrong(of({0, 8}), truth), 0U);
  EXPECT_EQ(wrong(of({8, 15}), truth), 0U);
  EXPECT_EQ(wrong(of({8, 8}), truth), 0U);
  EXPECT_EQ(wrong(of({0, 1}), truth), 1U) << "both are near the first alone";
  EXPECT_EQ(wrong(of({-10, 4}), truth), 1U) << "both are near the first alone";
  EXPECT_EQ(wrong(of({0, 15, 8}), truth), 1U);
  // A chain of values, each near two neighbours, in which all have to move by one.
  Truth chain;
  std::vector<long> deaths;
  for (long k = 0; k < 50; ++k) {
    chain.push_back({1, Rational(1) / 2, 1 + parts(15 * k)});
    deaths.push_back(15 * k - 8);
  }
  EXPECT_EQ(wrong(of(deaths), chain), 0U);
  deaths.front() = 15 * 50 - 8;
  EXPECT_EQ(wrong(of(deaths), chain), 0U);
  deaths.front() = 15 * 50 - 4;
  EXPECT_EQ(wrong(of(deaths), chain), 1U);
}

TEST(PairDifferences, TellRoundingApart) {
  CITES("FC-CLAIM-05", "FC-CLAIM-11");
  const Truth truth = {{1, 1, Rational(5)}};
  const Rational ulp = Rational(1) / Rational(1L << 50);
  const auto near = pair_differences({{1, decimal(1), decimal(5 + ulp)}}, truth, 0);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].reason, "rounding");
  EXPECT_EQ(near[0].claimed, "dimension 1, birth 1, death 5.000000000000001");
  EXPECT_EQ(near[0].truth, "dimension 1, birth 1, death 5");
  const auto far = pair_differences({{1, decimal(1), decimal(5 + parts(1))}}, truth, 0);
  ASSERT_EQ(far.size(), 1U);
  EXPECT_EQ(far[0].reason, "wrong-pair");
  EXPECT_EQ(pair_differences({}, truth, 1e-9)[0].claimed, "no such pair");
}

}  // namespace
}  // namespace flowcert::pair_differences_test
