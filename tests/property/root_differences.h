// Differences of square roots of rationals, compared exactly: whether a double is the one nearest to a depth
// (FC-POCK-11).
//
// sqrt(a) is compared with x + sqrt(b) by the squares of both, if these have one sign. No root is rounded.
#pragma once

#include <cmath>
#include <limits>

#include "oracle/exact_geometry.h"

namespace oracle {

// The sign of x + y sqrt(b).
inline int sign_with_root(const Rational& x, const Rational& y, const Rational& b) {
  const int of_root = b > 0 ? y.sign() : 0;
  if (x.sign() * of_root >= 0) return x.sign() != 0 ? x.sign() : of_root;
  return x.sign() * Rational(x * x - y * y * b).sign();
}

// The sign of sqrt(a) - sqrt(b) - x. a and b are not negative.
inline int compare_root_difference(const Rational& a, const Rational& b, const Rational& x) {
  const int right = sign_with_root(x, 1, b);  // of x + sqrt(b)
  if (right < 0) return 1;
  if (right == 0) return a.sign();
  return sign_with_root(a - x * x - b, -2 * x, b);
}

// Whether x is the double nearest to sqrt(a) - sqrt(b); of two that are equally near, either is.
inline bool is_nearest_root_difference(double x, const Rational& a, const Rational& b) {
  const auto middle = [&](double end) { return (Rational(x) + Rational(std::nextafter(x, end))) / 2; };
  const double infinity = std::numeric_limits<double>::infinity();
  return std::isfinite(x) && compare_root_difference(a, b, middle(-infinity)) >= 0 &&
         compare_root_difference(a, b, middle(infinity)) <= 0;
}

}  // namespace oracle
