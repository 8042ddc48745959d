// Two squarings suffice for two roots: where a + b sqrt(d) and c sqrt(e) have different signs, the sum's sign is that
// of the one with the greater square, and the difference of the squares has one root alone.
#include "oracle/quadratic.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

namespace oracle {

namespace {

int sign_of(const Rational& x) { return x.sign(); }

// The sign of a + b sqrt(d).
int sign_of_sum(const Rational& a, const Rational& b, const Rational& d) {
  const int left = sign_of(a), right = d == 0 ? 0 : sign_of(b);
  if (left * right >= 0) return left != 0 ? left : right;
  return left * sign_of(a * a - b * b * d);
}

Rational common_radicand(const Quadratic& x, const Quadratic& y) {
  if (x.b == 0) return y.d;
  if (y.b == 0 || x.d == y.d) return x.d;
  throw std::logic_error("numbers of two fields");
}

std::optional<Integer> exact_root(const Integer& x) {
  const Integer root = sqrt(x);
  return root * root == x ? std::optional(root) : std::nullopt;
}

// Nothing iff it is not rational. A fraction in lowest terms is a square iff both of its parts are.
std::optional<Rational> exact_root(const Rational& x) {
  const auto top = exact_root(Integer(numerator(x))), bottom = exact_root(Integer(denominator(x)));
  return top && bottom ? std::optional(Rational(*top, *bottom)) : std::nullopt;
}

// a + b sqrt(d), with b = 0 where it is rational.
Quadratic reduced(const Rational& a, const Rational& b, const Rational& d) {
  const auto root = exact_root(d);
  return root ? Quadratic(a + b * *root) : Quadratic(a, b, d);
}

// The doubles from 0 to infinity have ascending bits. Infinity stands for the double that would follow the greatest.
Rational value_of(std::uint64_t bits) {
  const auto value = std::bit_cast<double>(bits);
  if (value <= std::numeric_limits<double>::max()) return value;
  return 2 * Rational(std::ldexp(1.0, 1023));
}

}  // namespace

int Quadratic::sign() const { return sign_of_sum(a, b, d); }

int sign_of_sum(const Rational& a, const Rational& b, const Rational& d, const Rational& c, const Rational& e) {
  const int left = sign_of_sum(a, b, d), right = e == 0 ? 0 : sign_of(c);
  if (left * right >= 0) return left != 0 ? left : right;
  return left * sign_of_sum(a * a + b * b * d - c * c * e, 2 * a * b, d);
}

Quadratic operator+(const Quadratic& x, const Quadratic& y) { return {x.a + y.a, x.b + y.b, common_radicand(x, y)}; }

Quadratic operator-(const Quadratic& x, const Quadratic& y) { return {x.a - y.a, x.b - y.b, common_radicand(x, y)}; }

Quadratic operator*(const Quadratic& x, const Quadratic& y) {
  const Rational d = common_radicand(x, y);
  return {x.a * y.a + x.b * y.b * d, x.a * y.b + x.b * y.a, d};
}

Quadratic operator/(const Quadratic& x, const Rational& y) { return {x.a / y, x.b / y, x.d}; }

std::strong_ordering operator<=>(const Quadratic& x, const Quadratic& y) {
  return sign_of_sum(x.a - y.a, x.b, x.d, -y.b, y.d) <=> 0;
}

std::vector<Quadratic> roots(const Rational& c2, const Rational& c1, const Rational& c0) {
  if (c2 == 0) return c1 == 0 ? std::vector<Quadratic>() : std::vector<Quadratic>{Quadratic(-c0 / (2 * c1))};
  const Rational d = c1 * c1 - c2 * c0;
  if (d < 0) return {};
  if (d == 0) return {Quadratic(-c1 / c2)};
  const Rational step = 1 / abs(c2);
  return {reduced(-c1 / c2, -step, d), reduced(-c1 / c2, step, d)};
}

QuadraticPoint moved(const Point& x, const Quadratic& time, const Point& direction) {
  return moved(QuadraticPoint{Quadratic(x[0]), Quadratic(x[1]), Quadratic(x[2])}, time, direction);
}

QuadraticPoint moved(const QuadraticPoint& x, const Quadratic& time, const Point& direction) {
  return {x[0] + time * direction[0], x[1] + time * direction[1], x[2] + time * direction[2]};
}

QuadraticPoint minus(QuadraticPoint a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Quadratic dot(const QuadraticPoint& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Quadratic dot(const QuadraticPoint& a, const QuadraticPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// x^2 - 2 a x + a^2 - b^2 d is 0 at a + b sqrt(d) and a - b sqrt(d).
PrimitivePolynomial primitive_polynomial(const Quadratic& number) {
  const Quadratic x = reduced(number.a, number.b, number.d);
  std::vector<Rational> monic = {1, -x.a};
  if (x.b != 0) monic = {1, -2 * x.a, x.a * x.a - x.b * x.b * x.d};
  Integer multiple = 1, divisor = 0;
  for (const Rational& c : monic) multiple = lcm(multiple, Integer(denominator(c)));
  PrimitivePolynomial result{{}, x.b.sign()};
  for (const Rational& c : monic) result.coefficients.push_back(Integer(numerator(c * multiple)));
  for (const Integer& c : result.coefficients) divisor = gcd(divisor, c);
  for (Integer& c : result.coefficients) c /= divisor;
  return result;
}

// The two doubles around x - y are found by halving what is between them.
double nearest_difference(const Quadratic& x, const Quadratic& y) {
  if (x < y) return -nearest_difference(y, x);
  const auto infinity = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  std::uint64_t below = 0, above = infinity;
  if (x >= y + value_of(infinity)) return std::bit_cast<double>(infinity);
  while (above - below > 1) {
    const std::uint64_t middle = below + (above - below) / 2;
    (x >= y + value_of(middle) ? below : above) = middle;
  }
  const auto order = x <=> y + (value_of(below) + value_of(above)) / 2;
  const bool is_above = order > 0 || (order == 0 && above % 2 == 0);
  return std::bit_cast<double>(is_above ? above : below);
}

}  // namespace oracle
