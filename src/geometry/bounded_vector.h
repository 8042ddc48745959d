// Vectors of numbers that are known within bounds.
//
// Guarantees: those of bounded_arithmetic.h, for each number of a result.
#pragma once

#include <array>

#include "geometry/bounded_arithmetic.h"

namespace flowcert::geometry {

using BoundedVector = std::array<BoundedNumber, 3>;

// Inner product.
[[nodiscard]] inline BoundedNumber dot(const BoundedVector& a, const BoundedVector& b) {
  return sum(sum(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
}
[[nodiscard]] inline BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
  const auto part = [&](std::size_t i, std::size_t j) { return difference(product(a[i], b[j]), product(a[j], b[i])); };
  return {part(1, 2), part(2, 0), part(0, 1)};
}
[[nodiscard]] inline BoundedVector combined(const BoundedNumber& factor, const BoundedVector& a,
                                            const BoundedVector& minus) {
  BoundedVector all;
  for (std::size_t i = 0; i < 3; ++i) all[i] = difference(product(factor, a[i]), minus[i]);
  return all;
}
[[nodiscard]] inline BoundedVector halved(BoundedVector a) {
  for (BoundedNumber& x : a) x = {x.value * DoubleDouble(0.5), x.error};
  return a;
}

}  // namespace flowcert::geometry
