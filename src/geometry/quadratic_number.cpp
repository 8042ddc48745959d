#include "flowcert/quadratic_number.h"

#include <boost/multiprecision/integer.hpp>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/exact_root.h"
#include "geometry/floating_point.h"

namespace flowcert {

namespace {

using geometry::exact_root;
using Integer = geometry::BigInteger;

constexpr unsigned kFirstDigits = 64;

int sign_of(const Rational& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

// The sign of a + b sqrt(d).
int sign_of_sum(const Rational& a, const Rational& b, const Rational& d) {
  const int one = sign_of(a), other = d == 0 ? 0 : sign_of(b);
  if (other == 0) return one;
  if (one == 0 || one == other) return other;
  return one * sign_of(a * a - b * b * d);
}

// The sign of a + b sqrt(d) + c sqrt(e).
int sign_of_sum(const Rational& a, const Rational& b, const Rational& d, const Rational& c, const Rational& e) {
  const int one = sign_of_sum(a, b, d), other = e == 0 ? 0 : sign_of(c);
  if (one * other >= 0) return one != 0 ? one : other;
  return one * sign_of_sum(a * a + b * b * d - c * c * e, 2 * a * b, d);
}

// The number itself, where it is rational.
std::optional<Rational> rational_value(const QuadraticNumber& x) {
  if (x.b == 0 || x.d == 0) return x.a;
  const std::optional<Rational> root = exact_root(x.d);
  return root ? std::optional<Rational>(x.a + x.b * *root) : std::nullopt;
}

// Rationals that differ by 2^-digits at most.
std::pair<Rational, Rational> enclosure(const QuadraticNumber& x, unsigned digits) {
  if (const std::optional<Rational> value = rational_value(x)) return {*value, *value};
  const Integer root = geometry::scaled_root(x.b * x.b * x.d, digits), unit = Integer(1) << digits;
  const Rational low(root, unit), high(Integer(root + 1), unit);
  if (x.b > 0) return {x.a + low, x.a + high};
  return {x.a - high, x.a - low};
}

const Rational& radicand(const QuadraticNumber& x, const QuadraticNumber& y) { return x.b == 0 ? y.d : x.d; }

}  // namespace

int QuadraticNumber::sign() const { return sign_of_sum(a, b, d); }
bool QuadraticNumber::is_rational() const { return rational_value(*this).has_value(); }

QuadraticNumber operator+(const QuadraticNumber& x, const QuadraticNumber& y) {
  return {x.a + y.a, x.b + y.b, radicand(x, y)};
}
QuadraticNumber operator-(const QuadraticNumber& x, const QuadraticNumber& y) {
  return {x.a - y.a, x.b - y.b, radicand(x, y)};
}
QuadraticNumber operator*(const QuadraticNumber& x, const QuadraticNumber& y) {
  const Rational& d = radicand(x, y);
  if (x.b == 0) return {x.a * y.a, x.a * y.b, d};
  if (y.b == 0) return {x.a * y.a, x.b * y.a, d};
  return {x.a * y.a + x.b * y.b * d, x.a * y.b + x.b * y.a, d};
}
QuadraticNumber operator/(const QuadraticNumber& x, const QuadraticNumber& y) {
  if (y.b == 0) return {x.a / y.a, x.b / y.a, x.d};
  const Rational norm = y.a * y.a - y.b * y.b * y.d;
  if (norm == 0) return x / QuadraticNumber(*rational_value(y));  // y = 2 y.a
  return x * QuadraticNumber(y.a / norm, -y.b / norm, y.d);
}

std::strong_ordering operator<=>(const QuadraticNumber& x, const QuadraticNumber& y) {
  return sign_of_sum(x.a - y.a, x.b, x.d, -y.b, y.d) <=> 0;
}

std::vector<QuadraticNumber> roots_of(const Quadratic& equation) {
  const auto& [c2, c1, c0] = equation;
  if (c2 == 0) {
    if (c1 == 0) return {};
    return {Rational(-c0 / (2 * c1))};
  }
  const Rational discriminant = c1 * c1 - c2 * c0;
  if (discriminant < 0) return {};
  if (discriminant == 0) return {Rational(-c1 / c2)};
  const Rational middle = -c1 / c2, unit = 1 / c2;
  if (const std::optional<Rational> root = exact_root(discriminant)) {
    return {Rational(middle - *root * unit), Rational(middle + *root * unit)};
  }
  return {{middle, -unit, discriminant}, {middle, unit, discriminant}};
}

PrimitivePolynomial primitive_polynomial(const QuadraticNumber& x) {
  std::vector<Rational> coefficients;
  PrimitivePolynomial made;
  if (const std::optional<Rational> value = rational_value(x)) {
    coefficients = {1, -*value};
  } else {
    coefficients = {1, -2 * x.a, x.a * x.a - x.b * x.b * x.d};
    made.root = sign_of(x.b);
  }
  Integer multiple = 1, divisor = 0;
  for (const Rational& each : coefficients) multiple = lcm(multiple, Integer(denominator(each)));
  for (const Rational& each : coefficients) divisor = gcd(divisor, Integer(numerator(Rational(each * multiple))));
  for (const Rational& each : coefficients) {
    made.coefficients.push_back(Integer(numerator(Rational(each * multiple)) / divisor).str());
  }
  return made;
}

double nearest_or_infinity(const QuadraticNumber& x) { return nearest_difference(x, Rational(0)); }

// Of two doubles that follow each other the number is nearest to one, or is in the middle.
double nearest_difference(const QuadraticNumber& x, const QuadraticNumber& y) {
  const geometry::IeeeDoubles ieee;
  constexpr unsigned kLastDigits = 1024;
  for (unsigned digits = kFirstDigits;; digits *= 2) {
    const auto [x_low, x_high] = enclosure(x, digits);
    const auto [y_low, y_high] = enclosure(y, digits);
    const double low = nearest_or_infinity(Rational(x_low - y_high)),
                 high = nearest_or_infinity(Rational(x_high - y_low));
    if (low == high) return low;
    if (digits < kLastDigits || !std::isfinite(low) || !std::isfinite(high)) continue;
    const Rational middle = (Rational(low) + Rational(high)) / 2;
    const auto order = (x - middle) <=> y;
    if (order != 0) return order < 0 ? low : high;
    return nearest_or_infinity(middle);
  }
}

}  // namespace flowcert
