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

namespace flowcert::geometry {

struct BoundedNumber {
  DoubleDouble value;
  double error = HUGE_VAL;  // |value - number| is at most this
};

[[nodiscard]] inline BoundedNumber operator-(const BoundedNumber& x, const BoundedNumber& y) {
  const DoubleDouble value = x.value - y.value;
  const double rounding = DoubleDouble::kRoundoff * std::fabs(value.high());
  return {value, (x.error + y.error + rounding) * (1 + 0x1p-50) + std::numeric_limits<double>::denorm_min()};
}

// Sums of two doubles are rounded to nearest, so a greater sum never has a lesser double.
[[nodiscard]] inline std::optional<double> decided_double(const BoundedNumber& number) {
  const double high = number.value.high(), low = number.value.low();
  if (!std::isfinite(high) || !(number.error < HUGE_VAL)) return std::nullopt;
  if (number.error == 0) return high + low + 0.0;  // no negative zero: FC-IN-02
  // This also covers the rounding of the two sums with `low`.
  const double reach =
      number.error * (1 + 0x1p-50) + std::fabs(low) * 0x1p-51 + std::numeric_limits<double>::denorm_min();
  const double least = high + (low - reach), greatest = high + (low + reach);
  if (!(least == greatest) || least == 0 || !std::isfinite(least)) return std::nullopt;
  return least;
}

}  // namespace flowcert::geometry
