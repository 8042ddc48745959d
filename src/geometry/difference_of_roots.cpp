#include "geometry/difference_of_roots.h"

#include <boost/multiprecision/integer.hpp>
#include <optional>

#include "flowcert/rounded_sphere.h"

namespace flowcert::geometry {

namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

constexpr unsigned kFirstDigits = 64;

std::optional<Integer> exact_root(const Integer& square) {
  const Integer root = sqrt(square);
  return root * root == square ? std::optional(root) : std::nullopt;
}

std::optional<Rational> exact_root(const Rational& square) {
  const auto top = exact_root(Integer(numerator(square)));
  if (!top) return std::nullopt;
  const auto bottom = exact_root(Integer(denominator(square)));
  return bottom ? std::optional(Rational(*top, *bottom)) : std::nullopt;
}

// floor(sqrt(value) 2^digits)
Integer scaled_root(const Rational& value, unsigned digits) {
  return sqrt(Integer((Integer(numerator(value)) << (2 * digits)) / Integer(denominator(value))));
}

}  // namespace

double nearest_difference_of_roots(const Rational& a, const Rational& b) {
  if (a == b) return 0;
  const auto root_a = exact_root(a), root_b = exact_root(b);
  if (root_a && root_b) return nearest_or_infinity(*root_a - *root_b);
  for (unsigned digits = kFirstDigits;; digits *= 2) {
    const Integer difference = scaled_root(a, digits) - scaled_root(b, digits);
    const Integer unit = Integer(1) << digits;
    const double low = nearest_or_infinity(Rational(difference - 1, unit)),
                 high = nearest_or_infinity(Rational(difference + 1, unit));
    if (low == high) return low;
  }
}

}  // namespace flowcert::geometry
