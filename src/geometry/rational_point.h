// Exact points and vectors of R^3, and distances between them.
//
// Guarantees: nothing is rounded. It is for places where speed does not matter; the algorithms decide with
// predicates.h and steering.h. Templates over a number type have Vector3<Rational> instead (vector3.h).
#pragma once

#include <algorithm>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

[[nodiscard]] inline Vector3<Rational> exact_vector(const Point& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}
[[nodiscard]] inline Vector3<Rational> exact_vector(const RationalPoint& x) { return {x[0], x[1], x[2]}; }
[[nodiscard]] inline RationalPoint exact_position(const Point& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}
[[nodiscard]] inline RationalPoint exact_position(const Vector3<Rational>& v) { return {v.x, v.y, v.z}; }

[[nodiscard]] inline RationalPoint operator+(const RationalPoint& x, const RationalPoint& y) {
  return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}
[[nodiscard]] inline RationalPoint operator-(const RationalPoint& x, const RationalPoint& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
[[nodiscard]] inline RationalPoint operator-(const RationalPoint& x) { return {-x[0], -x[1], -x[2]}; }
[[nodiscard]] inline RationalPoint operator*(const Rational& factor, const RationalPoint& x) {
  return {factor * x[0], factor * x[1], factor * x[2]};
}
[[nodiscard]] inline Rational dot(const RationalPoint& x, const RationalPoint& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
[[nodiscard]] inline RationalPoint cross(const RationalPoint& x, const RationalPoint& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
[[nodiscard]] inline RationalPoint exact_midpoint(const Point& p, const Point& q) {
  return Rational(1, 2) * (exact_position(p) + exact_position(q));
}
[[nodiscard]] inline bool is_zero(const RationalPoint& x) { return x[0] == 0 && x[1] == 0 && x[2] == 0; }

// (b-a) x (c-a)
[[nodiscard]] inline RationalPoint normal_of(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return cross(b - a, c - a);
}

[[nodiscard]] inline Rational squared_distance(const RationalPoint& x, const RationalPoint& y) {
  const RationalPoint difference = y - x;
  return dot(difference, difference);
}
[[nodiscard]] inline Rational squared_distance(const RationalPoint& x, const Point& p) {
  return squared_distance(x, exact_position(p));
}

[[nodiscard]] inline Rational greatest_coordinate(const RationalPoint& x) {
  return std::max({Rational(abs(x[0])), Rational(abs(x[1])), Rational(abs(x[2]))});
}
// Scaled so that its greatest coordinate is 1 or -1, so that it depends on the direction alone. The vector must not be
// zero.
[[nodiscard]] inline RationalPoint as_direction(const RationalPoint& vector) {
  const Rational greatest = greatest_coordinate(vector);
  return {vector[0] / greatest, vector[1] / greatest, vector[2] / greatest};
}

}  // namespace flowcert::geometry
