// Exact positions of samples, and exact vectors and distances between positions.
//
// Guarantees: nothing is rounded. It is for places where speed does not matter; the algorithms decide with
// predicates.h and steering.h.
#pragma once

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

[[nodiscard]] inline RationalPoint exact_position(const Point& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

[[nodiscard]] inline Vector3<Rational> vector_between(const RationalPoint& from, const RationalPoint& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

[[nodiscard]] inline Rational squared_distance(const RationalPoint& x, const RationalPoint& y) {
  const Vector3<Rational> difference = vector_between(x, y);
  return dot(difference, difference);
}
[[nodiscard]] inline Rational squared_distance(const RationalPoint& x, const Point& p) {
  return squared_distance(x, exact_position(p));
}

}  // namespace flowcert::geometry
