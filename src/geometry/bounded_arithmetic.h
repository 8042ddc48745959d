// Sums, products and quotients of numbers that are known within bounds.
//
// Guarantees: the bound of a result holds for all numbers within the bounds of what it is made of. It is infinite, or
// no number, where nothing is known: after an overflow, or a division by what may be zero. Numbers have to be below
// 2^480 for a product not to overflow. What underflows is less than 2^-1000, which every bound includes.
#pragma once

#include <cmath>

#include "geometry/bounded_number.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

inline constexpr double kBoundedRoundoff = 8 * DoubleDouble::kRoundoff;
inline constexpr double kBoundedUnderflow = 0x1p-1000;
// Makes good for the rounding of bounds.
inline constexpr double kBoundedSlack = 1 + 0x1p-30;

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
