// Geometry in rationals, written down from the definitions, with nothing of src/geometry. The tests compare
// the integer polynomials of the predicates with it.
//
// Guarantees: exact. Slow, and meant to be read: a circumcentre is the solution of three linear equations by
// Cramer's rule.
#pragma once

#include <array>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert_tests {

using flowcert::Point;
using flowcert::Rational;
using flowcert::RationalPoint;

inline RationalPoint exactly(const Point& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

inline RationalPoint minus(const RationalPoint& u, const RationalPoint& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

inline Rational inner(const RationalPoint& u, const RationalPoint& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline Rational squared_distance(const RationalPoint& u, const RationalPoint& v) {
  return inner(minus(u, v), minus(u, v));
}

// The determinant of the rows u, v, w, by the rule of Sarrus.
inline Rational determinant(const RationalPoint& u, const RationalPoint& v, const RationalPoint& w) {
  return u[0] * v[1] * w[2] + u[1] * v[2] * w[0] + u[2] * v[0] * w[1] - u[2] * v[1] * w[0] - u[0] * v[2] * w[1] -
         u[1] * v[0] * w[2];
}

// x with <rows[k], x> = right[k]; the rows are independent.
inline RationalPoint solution(const std::array<RationalPoint, 3>& rows, const RationalPoint& right) {
  const Rational whole = determinant(rows[0], rows[1], rows[2]);
  RationalPoint x;
  for (std::size_t column = 0; column < 3; ++column) {
    std::array<RationalPoint, 3> replaced = rows;
    for (std::size_t k = 0; k < 3; ++k) replaced[k][column] = right[k];
    x[column] = determinant(replaced[0], replaced[1], replaced[2]) / whole;
  }
  return x;
}

// The point at the same distance from four that are not coplanar: 2 <p_k - p_0, z> = |p_k|^2 - |p_0|^2.
inline RationalPoint circumcenter(const RationalPoint& p0, const RationalPoint& p1, const RationalPoint& p2,
                                  const RationalPoint& p3) {
  const auto right = [&p0](const RationalPoint& p) -> Rational { return (inner(p, p) - inner(p0, p0)) / 2; };
  return solution({minus(p1, p0), minus(p2, p0), minus(p3, p0)}, {right(p1), right(p2), right(p3)});
}

inline RationalPoint normal_of(const RationalPoint& p0, const RationalPoint& p1, const RationalPoint& p2) {
  const RationalPoint u = minus(p1, p0), v = minus(p2, p0);
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// The point of their plane at the same distance from three that are not collinear.
inline RationalPoint circle_center(const RationalPoint& p0, const RationalPoint& p1, const RationalPoint& p2) {
  const RationalPoint normal = normal_of(p0, p1, p2);
  const auto right = [&p0](const RationalPoint& p) -> Rational { return (inner(p, p) - inner(p0, p0)) / 2; };
  return solution({minus(p1, p0), minus(p2, p0), normal}, {right(p1), right(p2), inner(normal, p0)});
}

inline int sign_of(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

}  // namespace flowcert_tests
