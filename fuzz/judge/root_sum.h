// Whether a double stands for a sum of square roots of rationals, as areas are (FC-POCK-11).
//
// No root is rounded: the sum is enclosed by integer roots on both sides. Exact.
#pragma once

#include <cmath>
#include <vector>

#include "oracle/exact_geometry.h"

namespace flowcert::judge {

// The greatest multiple of the unit whose square is not greater.
inline oracle::Rational root_below(const oracle::Rational& square, const oracle::Rational& unit) {
  const oracle::Rational ratio = square / (unit * unit);
  const oracle::Integer whole = boost::multiprecision::numerator(ratio) / boost::multiprecision::denominator(ratio);
  return oracle::Rational(boost::multiprecision::sqrt(whole)) * unit;
}

// Whether x is the sum of the roots of these numbers, which are not negative, but for a share of 2^-40 of it. The unit
// is so small that its multiples below the roots lack less than 2^-42 of x in all.
inline bool is_root_sum(double x, const std::vector<oracle::Rational>& squares) {
  using oracle::Rational;
  Rational low = 0, count = 0;
  for (const Rational& square : squares) count += square > 0 ? 1 : 0;
  if (!std::isfinite(x) || x < 0 || (x == 0) != (count == 0)) return false;
  if (count == 0) return true;
  const Rational share = Rational(1) / Rational(oracle::Integer(1) << 40), unit = Rational(x) * share / (4 * count);
  for (const Rational& square : squares) low += root_below(square, unit);
  const Rational high = low + unit * count;
  return Rational(x) <= low * (1 + share) && Rational(x) >= high * (1 - share);
}

}  // namespace flowcert::judge
