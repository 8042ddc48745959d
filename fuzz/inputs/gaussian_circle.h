// All integer points of a large circle about the origin, as Gaussian integers: their products stay on such circles.
//
// Guarantees: exact and complete, by angle from the positive x axis. A norm is given by its prime factors, all of which
// are sums of two squares. Norms stay below 2^96, and coordinates below 2^48.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// x + iy
using Gaussian = std::array<Integer, 2>;

[[nodiscard]] Gaussian product(const Gaussian& a, const Gaussian& b);
[[nodiscard]] Gaussian power(const Gaussian& base, int exponent);

// The exponents of 5, 13, 17, 29, 37, 41, 53 and 61.
constexpr std::size_t kNormPrimes = 8;
using PrimeExponents = std::array<int, kNormPrimes>;

// The points with x² + y² = norm, four times as many as the norm has divisors.
[[nodiscard]] std::vector<Gaussian> integer_circle(const PrimeExponents& norm);

}  // namespace flowcert::fuzz
