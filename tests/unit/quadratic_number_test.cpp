// Numbers a + b sqrt(d): signs, order, text, and the nearest double.
#include "flowcert/quadratic_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/cites.h"

namespace flowcert::quadratic_number_test {
namespace {

QuadraticNumber root_of(int square) { return {0, 1, square}; }

TEST(QuadraticNumber, HasTheSignOfItsValue) {
  CITES("FC-BALL-08");
  EXPECT_EQ(QuadraticNumber(Rational(-3, 2), 1, 2).sign(), -1);  // 1.414 - 1.5
  EXPECT_EQ(QuadraticNumber(Rational(-7, 5), 1, 2).sign(), 1);
  EXPECT_EQ(QuadraticNumber(-2, 1, 4).sign(), 0);
  EXPECT_EQ(QuadraticNumber(3, -1, 9).sign(), 0);
  EXPECT_EQ(QuadraticNumber(0, -1, 5).sign(), -1);
}

TEST(QuadraticNumber, ComparesNumbersOfDifferentFields) {
  CITES("FC-BALL-08");
  EXPECT_LT(root_of(2), root_of(3));
  EXPECT_EQ(root_of(8), QuadraticNumber(0, 2, 2));
  EXPECT_LT(QuadraticNumber(1, 1, 2), QuadraticNumber(0, 1, 6));  // 2.414, 2.449
  // sqrt(2) + 10^-30 and sqrt(2 + 2 sqrt(2) 10^-30) are the same up to 10^-60.
  const Rational tiny(1, boost::multiprecision::pow(boost::multiprecision::mpz_int(10), 30).convert_to<Rational>());
  EXPECT_GT(QuadraticNumber(tiny, 1, 2), root_of(2));
  EXPECT_LT(QuadraticNumber(tiny, -1, 2), QuadraticNumber(2 * tiny, -1, 2));
}

// The order of doubles, where these are apart.
TEST(QuadraticNumber, AgreesWithDoublesWhereTheyAreApart) {
  CITES("FC-BALL-08");
  std::mt19937 random(3);
  const auto small = [&] { return static_cast<int>(random() % 21) - 10; };
  for (int k = 0; k < 2000; ++k) {
    const QuadraticNumber x(small(), small(), std::abs(small())), y(small(), small(), std::abs(small()));
    const double near_x = x.a.convert_to<double>() + x.b.convert_to<double>() * std::sqrt(x.d.convert_to<double>());
    const double near_y = y.a.convert_to<double>() + y.b.convert_to<double>() * std::sqrt(y.d.convert_to<double>());
    if (std::fabs(near_x - near_y) > 1e-9) {
      EXPECT_EQ(x < y, near_x < near_y);
    }
    EXPECT_NEAR(nearest_or_infinity(x), near_x, 1e-12);
    EXPECT_NEAR(nearest_difference(x, y), near_x - near_y, 1e-12);
    if (y.sign() != 0 && x.d == y.d) {
      EXPECT_EQ(x / y * y, x);
    }
  }
}

TEST(QuadraticNumber, IsWrittenAsThePrimitivePolynomial) {
  CITES("FC-BALL-08");
  using Text = std::vector<std::string>;
  EXPECT_EQ(primitive_polynomial(Rational(-3, 2)).coefficients, (Text{"2", "3"}));
  EXPECT_EQ(primitive_polynomial(Rational(-3, 2)).root, 0);
  EXPECT_EQ(primitive_polynomial(Rational(0)).coefficients, (Text{"1", "0"}));
  // The cage's peak and gate: 2 sqrt(3) - 1 and 4 sqrt(6) / 3 - 1.
  EXPECT_EQ(primitive_polynomial({-1, 2, 3}).coefficients, (Text{"1", "2", "-11"}));
  EXPECT_EQ(primitive_polynomial({-1, 2, 3}).root, 1);
  EXPECT_EQ(primitive_polynomial({-1, Rational(4, 3), 6}).coefficients, (Text{"3", "6", "-29"}));
  EXPECT_EQ(primitive_polynomial({-1, -2, 3}).root, -1);
  EXPECT_EQ(primitive_polynomial({-1, 1, 12}).coefficients, (Text{"1", "2", "-11"}));
  EXPECT_EQ(primitive_polynomial({1, 3, 4}).coefficients, (Text{"1", "-7"}));
}

TEST(QuadraticNumber, HasTheNearestDouble) {
  CITES("FC-BALL-08");
  EXPECT_EQ(nearest_or_infinity(root_of(2)), std::sqrt(2.0));
  EXPECT_EQ(nearest_or_infinity(QuadraticNumber(0, 1, 4)), 2);
  // Half way between 1 and the next double, and a root that is just above it.
  const Rational half = Rational(1) + Rational(0x1p-53);
  EXPECT_EQ(nearest_or_infinity(QuadraticNumber(half)), 1);
  EXPECT_EQ(nearest_or_infinity(QuadraticNumber(half, Rational(0x1p-900), 2)), 1 + 0x1p-52);
  EXPECT_EQ(nearest_or_infinity(QuadraticNumber(half, Rational(-0x1p-900), 2)), 1);
  // The difference of two irrational numbers is half way between two doubles.
  EXPECT_EQ(nearest_difference(QuadraticNumber(half, 1, 2), root_of(2)), 1);
  EXPECT_EQ(nearest_difference(root_of(2), root_of(8)), -std::sqrt(2.0));
  EXPECT_EQ(nearest_difference(root_of(8), QuadraticNumber(0, 2, 2)), 0);
}

TEST(QuadraticNumber, IsTheRootOfItsEquation) {
  CITES("FC-BALL-08");
  EXPECT_TRUE(roots_of({0, 0, 1}).empty());
  EXPECT_TRUE(roots_of({1, 0, 1}).empty());
  EXPECT_EQ(roots_of({0, 1, -3}).size(), 1u);
  EXPECT_EQ(roots_of({0, 1, -3})[0], QuadraticNumber(Rational(3, 2)));
  EXPECT_EQ(roots_of({1, -2, 4}).size(), 1u);
  const auto two = roots_of({-1, 1, 2});
  ASSERT_EQ(two.size(), 2u);
  for (const QuadraticNumber& x : two) {
    EXPECT_EQ((QuadraticNumber(Rational(-1)) * x * x + QuadraticNumber(Rational(2)) * x + QuadraticNumber(Rational(2)))
                  .sign(),
              0);
  }
}

}  // namespace
}  // namespace flowcert::quadratic_number_test
