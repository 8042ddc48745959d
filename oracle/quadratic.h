// Numbers a + b sqrt(d) with rational a, b and d: the values at critical points of balls, and their coordinates.
// FC-BALL-08 says how they are written.
//
// Exact. A sign is found by squaring until no root is left. No number is rounded, but where a double is asked for.
#pragma once

#include <compare>
#include <vector>

#include "oracle/exact_geometry.h"

namespace oracle {

struct Quadratic {
  Rational a, b, d;  // d >= 0

  Quadratic() = default;
  Quadratic(Rational rational) : a(std::move(rational)) {}  // NOLINT: every rational is such a number
  Quadratic(Rational rational, Rational factor, Rational radicand)
      : a(std::move(rational)), b(std::move(factor)), d(std::move(radicand)) {}

  int sign() const;

  // All numbers with one d are a field. Throws std::logic_error for two numbers that are not rational and whose d
  // differ.
  friend Quadratic operator+(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator-(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator*(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator/(const Quadratic& x, const Rational& y);

  // Whatever their d.
  friend std::strong_ordering operator<=>(const Quadratic& x, const Quadratic& y);
  friend bool operator==(const Quadratic& x, const Quadratic& y) { return (x <=> y) == 0; }
};

// The sign of a + b sqrt(d) + c sqrt(e).
int sign_of_sum(const Rational& a, const Rational& b, const Rational& d, const Rational& c, const Rational& e);

// The real numbers s with c2 s^2 + 2 c1 s + c0 = 0, each once, ascending. Empty as well where c2 = c1 = 0. One that is
// rational has b = 0.
std::vector<Quadratic> roots(const Rational& c2, const Rational& c1, const Rational& c0);

using QuadraticPoint = std::array<Quadratic, 3>;

QuadraticPoint moved(const Point& x, const Quadratic& time, const Point& direction);  // x + time * direction
QuadraticPoint moved(const QuadraticPoint& x, const Quadratic& time, const Point& direction);
QuadraticPoint minus(QuadraticPoint a, const Point& b);
Quadratic dot(const QuadraticPoint& a, const Point& b);
Quadratic dot(const QuadraticPoint& a, const QuadraticPoint& b);

// A number's one name: its integer polynomial of the least degree, whose coefficients have no common divisor and the
// first of which is positive. (c2, c1, c0) stands for c2 x^2 + c1 x + c0, and (c1, c0) for c1 x + c0.
struct PrimitivePolynomial {
  std::vector<Integer> coefficients;
  int root = 0;  // 1 for the greater root, -1 for the smaller one, 0 for the only one
};
PrimitivePolynomial primitive_polynomial(const Quadratic& x);

// The double nearest to x - y, ties to even. Infinity where that would overflow.
double nearest_difference(const Quadratic& x, const Quadratic& y);

}  // namespace oracle
