// A number that is known within a bound, and the double nearest to it.
//
// Guarantees: the double is the nearest one to every number within the bound, ties to even; so it is the nearest one
// to the number itself. Nothing is answered where the bound leaves it open, or where the double would overflow. The
// number may be zero only if the bound is zero, which says that the value is exact.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "geometry/double_double.h"
#include "geometry/value_range.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

// ---- Constants of the bounds ----

// Makes good for the rounding of bounds: some thousand operations, each of which is wrong by 2^-53 of itself at most.
inline constexpr double kBoundedShare = 0x1p-40;
inline constexpr double kBoundedSlack = 1 + kBoundedShare;
// A product and a quotient have a relative error of one roundoff each. The rest is for the rounding of the bound.
inline constexpr double kBoundedRoundoff = 8 * DoubleDouble::kRoundoff;
// What underflows is less than some of the smallest doubles, times numbers below 2^70.
inline constexpr double kBoundedUnderflow = 0x1p-1000;

struct BoundedNumber {
  DoubleDouble value;
  double error = HUGE_VAL;  // |value - number| is at most this
};

[[nodiscard]] inline BoundedNumber operator-(const BoundedNumber& x, const BoundedNumber& y) {
  const DoubleDouble value = x.value - y.value;
  const double rounding = DoubleDouble::kRoundoff * std::fabs(value.high());
  return {value, (x.error + y.error + rounding) * kBoundedSlack + std::numeric_limits<double>::denorm_min()};
}

// Sums of two doubles are rounded to nearest, so a greater sum never has a lesser double.
[[nodiscard]] inline std::optional<double> decided_double(const BoundedNumber& number) {
  const double high = number.value.high(), low = number.value.low();
  if (!std::isfinite(high) || !(number.error < HUGE_VAL)) return std::nullopt;
  if (number.error == 0) return high + low + 0.0;  // no negative zero: FC-IN-02
  // This also covers the rounding of the two sums with `low`.
  const double reach =
      number.error * kBoundedSlack + std::fabs(low) * kRoundingShare + std::numeric_limits<double>::denorm_min();
  const double least = high + (low - reach), greatest = high + (low + reach);
  if (!(least == greatest) || least == 0 || !std::isfinite(least)) return std::nullopt;
  return least;
}

// ---- Sums, products and quotients ----
//
// The bound of a result holds for all numbers within the bounds of what it is made of. It is infinite, or no number,
// where nothing is known: after an overflow, or a division by what may be zero. Numbers have to be below 2^480 for a
// product not to overflow. What underflows is less than 2^-1000, which every bound includes.

[[nodiscard]] inline double magnitude(const DoubleDouble& x) { return std::fabs(x.high()); }

[[nodiscard]] inline BoundedNumber operator*(const BoundedNumber& x, const BoundedNumber& y) {
  const DoubleDouble value = x.value * y.value;
  const double error = magnitude(x.value) * y.error + magnitude(y.value) * x.error + x.error * y.error +
                       kBoundedRoundoff * magnitude(value);
  return {value, error * kBoundedSlack + kBoundedUnderflow};
}
[[nodiscard]] inline BoundedNumber operator+(const BoundedNumber& x, const BoundedNumber& y) {
  return x - BoundedNumber{-y.value, y.error};
}
[[nodiscard]] inline BoundedNumber operator/(const BoundedNumber& x, const BoundedNumber& y) {
  const double least = magnitude(y.value) - y.error;
  if (!(least > y.error)) return {};
  const DoubleDouble value = x.value / y.value;
  const double error = (x.error + magnitude(value) * y.error) / least + kBoundedRoundoff * magnitude(value);
  return {value, error * kBoundedSlack + kBoundedUnderflow};
}
[[nodiscard]] inline BoundedNumber doubled(const BoundedNumber& x) { return {x.value + x.value, 2 * x.error}; }

[[nodiscard]] inline MaybeSign decided_sign(const BoundedNumber& x) { return sign_beyond(x.value.high(), 2 * x.error); }

}  // namespace flowcert::geometry
