// A number that a double is near to, with a bound on the difference.
//
// Guarantees: the bound of a result holds for all numbers within the bounds of what it is made of. It is infinite, or
// no number, where nothing is known: after an overflow, or a division by what may be zero. Rounding is to nearest, so
// that no rounding mode is changed. BoundedNumber is its twin in doubled doubles, twenty times slower.
#pragma once

#include <cmath>
#include <limits>

#include "geometry/vector3.h"

namespace flowcert::geometry {

// An operation rounds by 2^-53 of its result at most. The rest is for the rounding of the bound.
inline constexpr double kBoundedDoubleRoundoff = 0x1.1p-53;
inline constexpr double kBoundedDoubleSlack = 1 + 0x1p-48;
inline constexpr double kBoundedDoubleUnderflow = 0x1p-1020;

struct BoundedDouble {
  double value = 0, error = 0;

  BoundedDouble() = default;
  BoundedDouble(double exact) : value(exact) {}  // NOLINT: a double is such a number
  BoundedDouble(double near, double bound) : value(near), error(bound) {}

  // 1 or -1 where the sign is certain, and 0 where it is not.
  [[nodiscard]] int certain_sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

// Of a number that is within `error` of one that was rounded to this double.
[[nodiscard]] inline BoundedDouble rounded(double value, double error = 0) {
  return {value, (error + kBoundedDoubleRoundoff * std::fabs(value)) * kBoundedDoubleSlack + kBoundedDoubleUnderflow};
}
[[nodiscard]] inline BoundedDouble operator-(const BoundedDouble& x) { return {-x.value, x.error}; }
[[nodiscard]] inline BoundedDouble operator+(const BoundedDouble& x, const BoundedDouble& y) {
  return rounded(x.value + y.value, x.error + y.error);
}
[[nodiscard]] inline BoundedDouble operator-(const BoundedDouble& x, const BoundedDouble& y) {
  return rounded(x.value - y.value, x.error + y.error);
}
[[nodiscard]] inline BoundedDouble operator*(const BoundedDouble& x, const BoundedDouble& y) {
  return rounded(x.value * y.value, std::fabs(x.value) * y.error + std::fabs(y.value) * x.error + x.error * y.error);
}
[[nodiscard]] inline BoundedDouble operator/(const BoundedDouble& x, const BoundedDouble& y) {
  const double least = std::fabs(y.value) - y.error;
  if (!(least > 0)) return {0, HUGE_VAL};
  const double value = x.value / y.value;
  return rounded(value, (x.error + std::fabs(value) * y.error) / least * kBoundedDoubleSlack);
}
// Of a number that is not negative.
[[nodiscard]] inline BoundedDouble sqrt(const BoundedDouble& x) {
  const double least = x.value - x.error;
  if (!(least > 0)) return {0, std::sqrt(std::fmax(x.value + x.error, 0)) * kBoundedDoubleSlack};
  return rounded(std::sqrt(x.value), x.error / (2 * std::sqrt(least)) * kBoundedDoubleSlack);
}

}  // namespace flowcert::geometry
