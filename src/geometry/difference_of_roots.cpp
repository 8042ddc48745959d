#include "geometry/difference_of_roots.h"

#include <boost/multiprecision/integer.hpp>
#include <cstdlib>
#include <optional>

#include "flowcert/sphere.h"
#include "geometry/exact_root.h"

namespace flowcert::geometry {

namespace {

using Integer = BigInteger;

constexpr unsigned kFirstDigits = 64;

// The sign of sqrt(p) - sqrt(q) - k.
int sign_of(const Rational& p, const Rational& q, const Rational& k) {
  if (k < 0) return -sign_of(q, p, -k);
  // Both sides of sqrt(p) = k + sqrt(q) are squared, and then what is left of them.
  const Rational rest = p - k * k - q;
  if (rest < 0) return -1;
  return (rest * rest).compare(4 * k * k * q);
}

// The least multiple of 2^shift that is not less, in units of it.
Integer ceiling(const Rational& number, int shift) {
  Integer top(numerator(number)), bottom(denominator(number));
  (shift < 0 ? top : bottom) <<= static_cast<unsigned>(std::abs(shift));
  return (top + bottom - 1) / bottom;
}

// The least number of 53 binary digits that is not less than the positive one.
Rational rounded_up(const Rational& number) {
  constexpr int kDigits = 53;
  // The number has one binary digit more than this says, or as many.
  int shift =
      static_cast<int>(msb(Integer(numerator(number)))) - static_cast<int>(msb(Integer(denominator(number)))) - kDigits;
  if (msb(ceiling(number, shift)) >= kDigits) ++shift;
  const Integer units = ceiling(number, shift);
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(shift));
  return shift < 0 ? Rational(units, power) : Rational(units * power);
}

// What `round` makes of sqrt(a) - sqrt(b), which must not be 0. Both ends of an interval around it come to one number.
auto rounded_difference(const Rational& a, const Rational& b, const auto& round) {
  const auto root_a = exact_root(a), root_b = exact_root(b);
  if (root_a && root_b) return round(Rational(*root_a - *root_b));
  for (unsigned digits = kFirstDigits;; digits *= 2) {
    const Integer difference = scaled_root(a, digits) - scaled_root(b, digits);
    if (abs(difference) <= 1) continue;
    const Integer unit = Integer(1) << digits;
    const auto low = round(Rational(difference - 1, unit)), high = round(Rational(difference + 1, unit));
    if (low == high) return low;
  }
}

}  // namespace

double nearest_difference_of_roots(const Rational& a, const Rational& b) {
  return a == b ? 0 : rounded_difference(a, b, nearest_or_infinity);
}

std::strong_ordering operator<=>(const RootDifference& x, const RootDifference& y) {
  if (x.less == y.less) return x.square.compare(y.square) <=> 0;
  if (x.square == y.square) return y.less.compare(x.less) <=> 0;
  // The sums sqrt(x.square) + sqrt(y.less) and sqrt(y.square) + sqrt(x.less) are squared.
  const Rational k = (y.square + x.less - x.square - y.less) / 2;
  return sign_of(x.square * y.less, y.square * x.less, k) <=> 0;
}

Rational square_from_above(const RootDifference& number) {
  if (number.less == 0) return number.square;
  if (number.square <= number.less) return 0;
  const Rational root = rounded_difference(number.square, number.less, rounded_up);
  return root * root;
}

}  // namespace flowcert::geometry
