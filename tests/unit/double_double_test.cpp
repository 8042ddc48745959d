// Doubled doubles against rationals: each operation keeps the relative error that its header proves, and the one that
// it promises.
#include "geometry/double_double.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "flowcert/rational.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::geometry::double_double_test {
namespace {

using flowcert_tests::PortableRandom;

Rational exact(const DoubleDouble& x) { return Rational(x.high()) + Rational(x.low()); }

const Rational kSquaredRoundoff = Rational(0x1p-106);
const Rational kSumBound = 3 / (1 - 4 * Rational(0x1p-53));  // these are times kSquaredRoundoff
const Rational kProductBound = 7, kQuotientBound = 15, kRootBound = 5;

void expect_close(const DoubleDouble& computed, const Rational& truth, const Rational& times, double& worst) {
  const Rational error = abs(exact(computed) - truth), unit = kSquaredRoundoff * abs(truth);
  EXPECT_LE(error, times * unit);
  EXPECT_LE(error, Rational(DoubleDouble::kRoundoff) * abs(truth));
  EXPECT_EQ(computed.high(), computed.high() + computed.low()) << "the low part is below half a unit of the high one";
  if (truth != 0) worst = std::max(worst, static_cast<double>(Rational(error / unit)));
}

// A root is irrational, so squares are compared. The root's error is about half of its square's.
void expect_root(const DoubleDouble& computed, const Rational& square, double& worst) {
  const Rational root = exact(computed);
  for (const Rational& part : {Rational(kRootBound * kSquaredRoundoff), Rational(DoubleDouble::kRoundoff)}) {
    EXPECT_GE(root * root, square * (1 - part) * (1 - part));
    EXPECT_LE(root * root, square * (1 + part) * (1 + part));
  }
  EXPECT_GE(root, 0);
  if (square == 0) return;
  worst = std::max(worst, static_cast<double>(Rational(abs(root * root / square - 1) / kSquaredRoundoff / 2)));
}

// Draws a number of any size. Its low part has any size below its own.
DoubleDouble drawn(PortableRandom& random) {
  const double high = std::ldexp(random.coordinate(), static_cast<int>(random.between(-40, 40)));
  const double low = std::ldexp(high, -53 - static_cast<int>(random.below(6))) * random.coordinate() / 8;
  return DoubleDouble::sum(high, low);
}

TEST(DoubleDouble, OperationsKeepTheirBounds) {
  CITES("FC-NUM-01");
  PortableRandom random(11);
  double sum = 0, product = 0, quotient = 0, root = 0;
  for (int k = 0; k < 20000; ++k) {
    const DoubleDouble x = drawn(random);
    // Every other time nearly -x, so that most digits cancel.
    const DoubleDouble y = random.coin() ? drawn(random) : -x * DoubleDouble(1 + 0x1p-40 * random.coordinate());
    expect_close(x + y, exact(x) + exact(y), kSumBound, sum);
    expect_close(x - y, exact(x) - exact(y), kSumBound, sum);
    expect_close(x * y, exact(x) * exact(y), kProductBound, product);
    if (y.high() != 0) expect_close(x / y, exact(x) / exact(y), kQuotientBound, quotient);
    expect_root(sqrt(abs(x)), exact(abs(x)), root);
    EXPECT_EQ(x < y, exact(x) < exact(y));
    EXPECT_EQ(x > y, exact(x) > exact(y));
    EXPECT_EQ(x == y, exact(x) == exact(y));
  }
  // Otherwise doubles alone would have passed.
  EXPECT_GT(sum, 0.5);
  EXPECT_GT(product, 1);
  EXPECT_GT(quotient, 1);
  EXPECT_GT(root, 0.5);
}

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
  CITES("FC-NUM-01");
  PortableRandom random(12);
  for (int k = 0; k < 5000; ++k) {
    const double a = std::ldexp(random.coordinate(), static_cast<int>(random.between(-60, 60))),
                 b = random.coordinate();
    EXPECT_EQ(exact(DoubleDouble::sum(a, b)), Rational(a) + Rational(b));
    EXPECT_EQ(exact(DoubleDouble::product(a, b)), Rational(a) * Rational(b));
  }
}

TEST(DoubleDouble, WhatIsNoNumberIsNeitherLessNorMore) {
  CITES("FC-NUM-01");
  const DoubleDouble none(std::numeric_limits<double>::quiet_NaN()), one(1);
  // NOLINTNEXTLINE(misc-redundant-expression)
  for (const DoubleDouble& x : {none, DoubleDouble(HUGE_VAL) - DoubleDouble(HUGE_VAL), one / (one - one) * 0}) {
    EXPECT_FALSE(x < one || x > one || x == one);  // NOLINT(misc-redundant-expression)
  }
}

}  // namespace
}  // namespace flowcert::geometry::double_double_test
