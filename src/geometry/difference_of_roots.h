// The difference of two square roots of rationals, in the nearest double.
//
// Guarantees: exact but for the one rounding, on every input. Integer roots with more and more digits enclose the
// difference until both ends have one nearest double. Where both numbers are squares, the difference is rational and
// rounded as such; otherwise it is irrational or 0, so that this ends.
#pragma once

#include "flowcert/rational.h"

namespace flowcert::geometry {

// The double nearest to the root of a less that of b, both not negative, ties to even. An infinity of the right sign
// where it would overflow.
[[nodiscard]] double nearest_difference_of_roots(const Rational& a, const Rational& b);

}  // namespace flowcert::geometry
