// Exact numbers a + b sqrt(d): the critical values of balls, and the coordinates of the points where they are taken.
//
// Guarantees: exact. Comparisons square until no root is left. A number has one text alone: its primitive polynomial
// over the integers, and which of the polynomial's roots it is. Source: spec clause FC-BALL-08.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "flowcert/rational.h"

namespace flowcert {

struct QuadraticNumber {
  Rational a = 0, b = 0, d = 0;  // d is not negative

  QuadraticNumber() = default;
  QuadraticNumber(Rational rational) : a(std::move(rational)) {}  // NOLINT: a rational is such a number
  QuadraticNumber(Rational rational, Rational factor, Rational radicand)
      : a(std::move(rational)), b(std::move(factor)), d(std::move(radicand)) {}

  [[nodiscard]] int sign() const;
  [[nodiscard]] bool is_rational() const;

  // Both numbers have one d, or one of them has b = 0.
  friend QuadraticNumber operator+(const QuadraticNumber& x, const QuadraticNumber& y);
  friend QuadraticNumber operator-(const QuadraticNumber& x, const QuadraticNumber& y);
  friend QuadraticNumber operator*(const QuadraticNumber& x, const QuadraticNumber& y);
  friend QuadraticNumber operator/(const QuadraticNumber& x, const QuadraticNumber& y);  // y is not 0
  friend QuadraticNumber operator-(const QuadraticNumber& x) { return {-x.a, -x.b, x.d}; }

  // Of any two numbers.
  friend std::strong_ordering operator<=>(const QuadraticNumber& x, const QuadraticNumber& y);
  friend bool operator==(const QuadraticNumber& x, const QuadraticNumber& y) { return (x <=> y) == 0; }
};

// c2 x^2 + 2 c1 x + c0 = 0
struct Quadratic {
  Rational c2, c1, c0;
};
// (-c1 - sqrt(D)) / c2 and (-c1 + sqrt(D)) / c2 with D = c1^2 - c2 c0, each once; of a linear equation, its one root.
// Nothing where the equation has no real root, or all numbers are roots.
[[nodiscard]] std::vector<QuadraticNumber> roots_of(const Quadratic& equation);

// A polynomial with integer coefficients whose only common divisor is 1, the first of which is positive, of the least
// degree: (c2, c1, c0) for c2 x^2 + c1 x + c0, or (c1, c0) where the number is rational.
struct PrimitivePolynomial {
  std::vector<std::string> coefficients;
  int root = 0;  // 1 for the greater root, -1 for the smaller one, 0 for a rational number
};
[[nodiscard]] PrimitivePolynomial primitive_polynomial(const QuadraticNumber& x);

// The double nearest to the number, ties to even. An infinity of its sign where it would overflow.
[[nodiscard]] double nearest_or_infinity(const QuadraticNumber& x);
// The double nearest to x - y.
[[nodiscard]] double nearest_difference(const QuadraticNumber& x, const QuadraticNumber& y);

}  // namespace flowcert
