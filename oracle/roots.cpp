// sqrt(a) is compared with x + sqrt(b) by the squares of both, if these have one sign.
#include "oracle/roots.h"

#include <cmath>
#include <limits>

namespace oracle {

namespace {

int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// The sign of x + y sqrt(b).
int sign_with_root(const Rational& x, const Rational& y, const Rational& b) {
  const int of_root = b > 0 ? sign(y) : 0;
  if (sign(x) * of_root >= 0) return sign(x) != 0 ? sign(x) : of_root;
  return sign(x) * sign(x * x - y * y * b);
}

// The middle between a double and the next one in a direction.
Rational middle(double x, double towards) { return (Rational(x) + Rational(std::nextafter(x, towards))) / 2; }

// The greatest multiple of the unit whose square is not greater.
Rational root_below(const Rational& square, const Rational& unit) {
  const Rational ratio = square / (unit * unit);
  const Integer whole = boost::multiprecision::numerator(ratio) / boost::multiprecision::denominator(ratio);
  return Rational(boost::multiprecision::sqrt(whole)) * unit;
}

}  // namespace

int compare_root_difference(const Rational& a, const Rational& b, const Rational& x) {
  const int right = sign_with_root(x, 1, b);  // of x + sqrt(b)
  if (right < 0) return 1;
  if (right == 0) return sign(a);
  return sign_with_root(a - x * x - b, -2 * x, b);
}

// sqrt(a) <= sqrt(b) + sqrt(c): the squares of both sides differ by a - b - c and twice the root of bc.
bool is_root_difference_up_to(const Rational& a, const Rational& b, const Rational& c) {
  const Rational rest = a - b - c;
  return rest <= 0 || rest * rest <= 4 * b * c;
}

bool is_nearest_root_difference(double x, const Rational& a, const Rational& b) {
  const double infinity = std::numeric_limits<double>::infinity();
  return std::isfinite(x) && compare_root_difference(a, b, middle(x, -infinity)) >= 0 &&
         compare_root_difference(a, b, middle(x, infinity)) <= 0;
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
