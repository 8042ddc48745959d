// Signs of exact numbers, vectors of R^3 over any number type, and the polynomials in them that all predicates are
// made of.
//
// Guarantees: nothing is rounded here beyond what the number type itself rounds; the error bounds for double are in
// filter_bounds.h. A filter that does not decide a sign answers std::nullopt, never a guess (spec clause FC-NUM-01).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "flowcert/point_set.h"

namespace flowcert::geometry {

enum class Sign : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1 };

// What a filter rung answers: a sign that is certain, or nothing.
using MaybeSign = std::optional<Sign>;

template <class Number>
[[nodiscard]] Sign sign_of(const Number& value) {
  if (value > 0) return Sign::kPositive;
  return value < 0 ? Sign::kNegative : Sign::kZero;
}

// The sign of a number known up to an absolute error; nothing where that leaves it open, or where either is NaN.
template <class Number>
[[nodiscard]] MaybeSign sign_beyond(const Number& value, const Number& error) {
  if (value > error) return Sign::kPositive;
  if (value < -error) return Sign::kNegative;
  return std::nullopt;
}

template <class Number>
[[nodiscard]] Number absolute(const Number& value) {
  return value < 0 ? Number(-value) : value;
}
[[nodiscard]] inline double absolute(double value) { return std::fabs(value); }

template <class Number>
struct Vector3 {
  Number x, y, z;
};

template <class Number>
[[nodiscard]] Vector3<Number> operator-(const Vector3<Number>& u, const Vector3<Number>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}

template <class Number>
[[nodiscard]] Vector3<Number> operator+(const Vector3<Number>& u, const Vector3<Number>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}

template <class Number>
[[nodiscard]] Vector3<Number> operator*(const Number& factor, const Vector3<Number>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

template <class Number>
[[nodiscard]] Number dot(const Vector3<Number>& u, const Vector3<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class Number>
[[nodiscard]] Vector3<Number> cross(const Vector3<Number>& u, const Vector3<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// Without its sign.
[[nodiscard]] inline double greatest_coordinate(const Point& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

template <class Position>
[[nodiscard]] Vector3<decltype(Position::x)> vector_between(const Position& from, const Position& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

// The type in which products of products are formed; integer_grid.h widens the machine's integers.
template <class Number>
struct Promoted {
  using Type = Number;
};

template <class Number>
[[nodiscard]] Vector3<typename Promoted<Number>::Type> promote(const Vector3<Number>& v) {
  using Wide = typename Promoted<Number>::Type;
  return {Wide(v.x), Wide(v.y), Wide(v.z)};
}

// The circumsphere of the tetrahedron 0, a, b, c, without a division. Its centre is numerator / (2 determinant). For
// a point v, |v|^2 determinant - <numerator, v> has the determinant's sign outside, is zero on the sphere, and has
// the other sign inside.
template <class Number>
struct Circumsphere {
  using Wide = typename Promoted<Number>::Type;
  Vector3<Wide> ab, bc, ca;  // cross products
  Vector3<Wide> numerator;   // |a|^2 bc + |b|^2 ca + |c|^2 ab
  Wide determinant;          // <a, bc>
};

template <class Number>
[[nodiscard]] Circumsphere<Number> circumsphere(const Vector3<Number>& a, const Vector3<Number>& b,
                                                const Vector3<Number>& c) {
  using Wide = typename Promoted<Number>::Type;
  Circumsphere<Number> sphere;
  sphere.ab = promote(cross(a, b));
  sphere.bc = promote(cross(b, c));
  sphere.ca = promote(cross(c, a));
  sphere.numerator = Wide(dot(a, a)) * sphere.bc + Wide(dot(b, b)) * sphere.ca + Wide(dot(c, c)) * sphere.ab;
  sphere.determinant = dot(promote(a), sphere.bc);
  return sphere;
}

}  // namespace flowcert::geometry
