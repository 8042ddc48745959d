// Exact positions of samples, and exact distances between positions.
//
// Guarantees: nothing is rounded. It is for places where speed does not matter; the algorithms decide with
// predicates.h and steering.h.
#pragma once

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::geometry {

[[nodiscard]] inline RationalPoint exact_position(const Point& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

[[nodiscard]] inline Rational squared_distance(const RationalPoint& x, const RationalPoint& y) {
  const Rational dx = x[0] - y[0], dy = x[1] - y[1], dz = x[2] - y[2];
  return dx * dx + dy * dy + dz * dz;
}
[[nodiscard]] inline Rational squared_distance(const RationalPoint& x, const Point& p) {
  return squared_distance(x, exact_position(p));
}

}  // namespace flowcert::geometry
