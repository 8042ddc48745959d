// How coarsely coordinates are rounded, by their digits.
#include "io/coordinate_rounding.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/cites.h"

namespace flowcert::coordinate_rounding_test {
namespace {

Rational unit_of(const std::vector<Point>& rows) { return io::coordinate_unit(PointSet(rows)); }

TEST(CoordinateRounding, IsThatOfTheLastPlace) {
  CITES("FC-NUM-01");
  EXPECT_EQ(unit_of({}), 0);
  EXPECT_EQ(unit_of({{0, -0.0, 1e300}, {-7, 1e22, 5}}), 0);
  EXPECT_EQ(unit_of({{6, 5.406, 2.2}, {1, 2, 3}}), Rational(1, 1000));
  EXPECT_EQ(unit_of({{-0.5, 0, 0}}), Rational(1, 10));
  EXPECT_EQ(unit_of({{1.5e-7, 0, 0}}), Rational(1, 100000000));
  EXPECT_EQ(unit_of({{123456.25, 1e-3, 0}}), Rational(1, 1000));
}

// The doubles of floats have many digits, of which the floats mean few.
TEST(CoordinateRounding, OfFloatsIsThatOfTheirDigits) {
  const double a = 0.1F, b = 2.718F;
  EXPECT_EQ(unit_of({{a, b, 1}}), Rational(1, 1000));
  const Rational fine = unit_of({{a, b, 0.1}});  // one coordinate is no float
  EXPECT_LT(fine, Rational(1, 1000000000));
}

TEST(CoordinateRounding, OfLengthsIsThreeAndAHalfUnits) {
  EXPECT_EQ(io::length_rounding(PointSet(std::vector<Point>{{0.25, 0, 0}})), Rational(7, 200));
  EXPECT_EQ(io::length_rounding(PointSet(std::vector<Point>{{4, 0, 0}})), 0);
}

}  // namespace
}  // namespace flowcert::coordinate_rounding_test
