// A difference is taken apart by two squarings, and a sum is enclosed by multiples of a small unit.
#include "oracle/roots.h"

#include <cmath>

namespace oracle {

namespace {

// The greatest multiple of the unit whose square is not greater.
Rational root_below(const Rational& square, const Rational& unit) {
  const Rational ratio = square / (unit * unit);
  const Integer whole = boost::multiprecision::numerator(ratio) / boost::multiprecision::denominator(ratio);
  return Rational(boost::multiprecision::sqrt(whole)) * unit;
}

}  // namespace

// sqrt(a) <= sqrt(b) + sqrt(c): the squares of both sides differ by a - b - c and twice the root of bc.
bool is_root_difference_up_to(const Rational& a, const Rational& b, const Rational& c) {
  const Rational rest = a - b - c;
  return rest <= 0 || rest * rest <= 4 * b * c;
}

// The unit is so small that its multiples below the roots lack less than 2^-42 of x in all.
bool is_root_sum(double x, const std::vector<Rational>& squares) {
  Rational low = 0, count = 0;
  for (const Rational& square : squares) count += square > 0 ? 1 : 0;
  if (!std::isfinite(x) || x < 0 || (x == 0) != (count == 0)) return false;
  if (count == 0) return true;
  const Rational share = Rational(1) / Rational(Integer(1) << 40), unit = Rational(x) * share / (4 * count);
  for (const Rational& square : squares) low += root_below(square, unit);
  const Rational high = low + unit * count;
  return Rational(x) <= low * (1 + share) && Rational(x) >= high * (1 - share);
}

}  // namespace oracle
