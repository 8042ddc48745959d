// Differences of square roots of rationals, which are lengths (FC-PERS-06), and whether a double stands for a sum of
// them (FC-POCK-11).
//
// No root is rounded: differences are decided by squaring, and sums by integer roots on both sides. Exact.
#pragma once

#include <vector>

#include "oracle/exact_geometry.h"

namespace oracle {

// Whether sqrt(a) - sqrt(b) is at most sqrt(c). None of them is negative.
bool is_root_difference_up_to(const Rational& a, const Rational& b, const Rational& c);

// Whether x is the sum of the roots of these numbers, which are not negative, but for a share of 2^-40 of it.
bool is_root_sum(double x, const std::vector<Rational>& squares);

}  // namespace oracle
