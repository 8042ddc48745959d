// The difference of two square roots of rationals: compared exactly, and in the nearest double.
//
// Guarantees: exact, on every input. Comparisons square sums of roots until no root is left, so that they need no
// digits. For the double, integer roots with more and more digits enclose the difference until both ends round to one
// number. Where both numbers are squares, the difference is rational and rounded as such; otherwise it is irrational or
// 0, so that this ends.
#pragma once

#include <compare>

#include "flowcert/rational.h"

namespace flowcert::geometry {

// The double nearest to the root of a less that of b, both not negative, ties to even. An infinity of the right sign
// where it would overflow.
[[nodiscard]] double nearest_difference_of_roots(const Rational& a, const Rational& b);

// The root of `square` less that of `less`, both not negative: a distance, or the difference of two.
struct RootDifference {
  Rational square, less = 0;

  // Of the numbers, not of their parts.
  friend std::strong_ordering operator<=>(const RootDifference& x, const RootDifference& y);
  friend bool operator==(const RootDifference& x, const RootDifference& y) { return (x <=> y) == 0; }
};

// The square of a number that is not less. Of a root it is the number under it; of any other difference, which must not
// be negative, that of the least number of 53 binary digits, so that it is the square of a double unless these end.
[[nodiscard]] Rational square_from_above(const RootDifference& number);

}  // namespace flowcert::geometry
