// The direction in which a moving point lies, seen from the midpoint m of the facet that it is about to cross, with a
// bound on its error (src/flow/cascades.md).
//
// Guarantees: the true direction lies within the bound, for doubles and for every longer floating-point type that
// rounds to nearest. No point is constructed. A direction whose error is not known to be small is not known at all.
// How it changes from facet to facet is in direction_across.h.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "flow/kernels/layer.h"
#include "flow/kernels/steering.h"
#include "geometry/double_double.h"
#include "geometry/vector3.h"

namespace flowcert::flow {

using geometry::DoubleDouble;

// The longest floating-point type. Its exponents have 32 bits, so that no power of doubles leaves its range.
using Extended = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

// What the bounds need to know of a floating-point type.
template <class Number>
struct Precision;

template <>
struct Precision<double> {
  static constexpr double kRoundoff = 0x1p-53;
  // Of the square of a length. All terms of degree 10 in such lengths are normal doubles, and so are their errors.
  static bool is_in_range(double square) { return square >= 1e-50 && square <= 1e50; }
};

template <>
struct Precision<DoubleDouble> {
  static constexpr double kRoundoff = DoubleDouble::kRoundoff;
  static bool is_in_range(const DoubleDouble& square) { return Precision<double>::is_in_range(square.high()); }
};

template <>
struct Precision<Extended> {
  static constexpr double kRoundoff = 0x1p-256;
  static bool is_in_range(const Extended& square) { return square > 0; }
};

// ---- Constants of the bounds, in units of the roundoff (src/flow/cascades.md derives them) ----

inline constexpr double kVertexStartBound = 24;   // times |a||b||c| (|a|+|b|+|c|+W)
inline constexpr double kCircleStartBound = 32;   // times |a|^2 |b|^2 (|a|+|b|+W)
inline constexpr double kSideStartBound = 24;     // times |e|^2 |c-p0|
inline constexpr double kGivenStartBound = 8;     // relative
inline constexpr double kCrossingBound = 40;      // times L^2
inline constexpr double kAngleFormBound = 2;      // an angle h at q, times G^2
inline constexpr double kHeightBound = 6;         // an angle at the corner that is left behind, times L^2
inline constexpr double kExitBound = 20;          // <U,g>, times G
inline constexpr double kOrderBound = 8;          // h_j <U,g_i> - h_i <U,g_j>, times G_i G_j (G_i + G_j)
inline constexpr double kNormalBound = 24;        // <U,n>, times |b-a||c-a|
inline constexpr double kCrossingSlack = 1.0625;  // on the error of a position, for terms of higher order

// The Delaunay edge of a facet.
struct FacetEdge {
  const Point* p0 = nullptr;
  const Point* p1 = nullptr;

  friend bool operator==(const FacetEdge&, const FacetEdge&) = default;
};

template <class Number>
struct Direction {
  Vector3<Number> u{};
  // The tangent of the angle between u and the true direction, in the facet's plane, is at most this. u is at most a
  // little longer than 1, and leaves the plane by rounding alone. A direction that is not known has an error of 1.
  Number error{1};

  [[nodiscard]] bool is_known() const { return error < 1; }
};

template <class Number>
[[nodiscard]] Vector3<Number> difference(const Point& from, const Point& to) {
  if constexpr (std::is_same_v<Number, double>) {
    return geometry::vector_between(from, to);
  } else if constexpr (std::is_same_v<Number, DoubleDouble>) {
    return {Number::sum(to.x, -from.x), Number::sum(to.y, -from.y), Number::sum(to.z, -from.z)};
  } else {
    return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y), Number(to.z) - Number(from.z)};
  }
}

template <class Number>
[[nodiscard]] Number length(const Vector3<Number>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

// Projects y to the plane orthogonal to e, and shortens it to 1. y has an error of at most `bound`. The angle of this
// error is what is known of the direction.
template <class Number>
[[nodiscard]] Direction<Number> direction_of_vector(const Vector3<Number>& y, const Number& bound,
                                                    const Vector3<Number>& e) {
  using std::sqrt;
  const Number yy = dot(y, y), ee = dot(e, e);
  if (!Precision<Number>::is_in_range(ee)) return {};
  const Number inverse = Number(1) / sqrt(yy);
  const Number error = bound * inverse;
  // Where the length is infinite, its inverse is zero, and so is the error.
  if (!(inverse > 0 && error < Number(0.0625))) return {};
  return {inverse * (y - Number(dot(y, e) / ee) * e), error * (Number(1) + Number(2) * error)};
}

// ---- Starts ----

// From the centre of the sphere through four points, positively oriented.
template <class Number>
[[nodiscard]] Direction<Number> direction_from_vertex(const std::array<const Point*, 4>& v, FacetEdge facet) {
  const Vector3<Number> a = difference<Number>(*v[0], *v[1]), b = difference<Number>(*v[0], *v[2]),
                        c = difference<Number>(*v[0], *v[3]);
  const Vector3<Number> w0 = difference<Number>(*facet.p0, *v[0]), w1 = difference<Number>(*facet.p1, *v[0]);
  const geometry::Circumsphere<Number> sphere = geometry::circumsphere(a, b, c);
  const Number na = length(a), nb = length(b), nc = length(c), product = na * nb * nc;
  const Number bound =
      Number(kVertexStartBound * Precision<Number>::kRoundoff) * product * (na + nb + nc + length(w0) + length(w1));
  if (!Precision<Number>::is_in_range(std::min({na, nb, nc}) * std::min({na, nb, nc})) ||
      !Precision<Number>::is_in_range(std::max({na, nb, nc}) * std::max({na, nb, nc}))) {
    return {};
  }
  return direction_of_vector<Number>(sphere.numerator + sphere.determinant * (w0 + w1), bound,
                                     difference<Number>(*facet.p0, *facet.p1));
}

// From the centre of the circle through the ends of the facet's edge and c.
template <class Number>
[[nodiscard]] Direction<Number> direction_from_side(const Point& c, FacetEdge facet) {
  const Vector3<Number> e = difference<Number>(*facet.p0, *facet.p1), a = difference<Number>(*facet.p0, c),
                        b = difference<Number>(*facet.p1, c);
  const Number ee = dot(e, e), aa = dot(a, a), h = dot(a, b);
  const Number uncertain = Number(2 * kAngleFormBound * Precision<Number>::kRoundoff) * (aa + dot(b, b));
  if (!Precision<Number>::is_in_range(aa) || !(h > uncertain || h < -uncertain)) return {};
  using std::sqrt;
  const Number bound = Number(kSideStartBound * Precision<Number>::kRoundoff) * ee * sqrt(aa);
  const Vector3<Number> y = ee * a - Number(dot(a, e)) * e;
  return direction_of_vector<Number>(h > 0 ? y : Number(-1) * y, bound, e);
}

// From the centre of the circle through three points.
template <class Number>
[[nodiscard]] Direction<Number> direction_from_circle(const std::array<const Point*, 3>& v, FacetEdge facet) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point *one = v[(k + 1) % 3], *other = v[(k + 2) % 3];
    if ((facet.p0 == one && facet.p1 == other) || (facet.p0 == other && facet.p1 == one)) {
      return direction_from_side<Number>(*v[k], facet);
    }
  }
  const Vector3<Number> a = difference<Number>(*v[0], *v[1]), b = difference<Number>(*v[0], *v[2]);
  const Vector3<Number> w0 = difference<Number>(*facet.p0, *v[0]), w1 = difference<Number>(*facet.p1, *v[0]);
  const Vector3<Number> n = cross(a, b);
  const Number aa = dot(a, a), bb = dot(b, b);
  if (!Precision<Number>::is_in_range(aa) || !Precision<Number>::is_in_range(bb)) return {};
  const Number bound = Number(kCircleStartBound * Precision<Number>::kRoundoff) * aa * bb *
                       (length(a) + length(b) + length(w0) + length(w1));
  const Vector3<Number> y = Number(dot(n, n)) * (w0 + w1) + cross(aa * b - bb * a, n);
  return direction_of_vector<Number>(y, bound, difference<Number>(*facet.p0, *facet.p1));
}

// ---- Seen by a neighbour q of the facet ----

template <class Number>
struct Bisector {
  Vector3<Number> a, b, g;  // q-p0, q-p1, and their sum
  Number h;                 // <a,b>
  Number squared_size;      // G^2 = 2 (|a|^2 + |b|^2), which is |g|^2 + |p1-p0|^2
};

// Inlined by force: returned through memory it costs more than its arithmetic.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Bisector<Number> bisector(FacetEdge facet, const Point& q) {
  Bisector<Number> seen;
  seen.a = difference<Number>(*facet.p0, q);
  seen.b = difference<Number>(*facet.p1, q);
  seen.g = seen.a + seen.b;
  seen.h = dot(seen.a, seen.b);
  seen.squared_size = Number(2) * (dot(seen.a, seen.a) + dot(seen.b, seen.b));
  return seen;
}

// ---- Signs. They are linear forms in the direction. ----

// RayAtInfinity: <U,g>.
template <class Number>
[[nodiscard]] geometry::MaybeSign approach_sign(const Direction<Number>& x, FacetEdge facet, const Point& q) {
  using std::sqrt;
  const Bisector<Number> seen = bisector<Number>(facet, q);
  if (!x.is_known() || !Precision<Number>::is_in_range(seen.squared_size)) return std::nullopt;
  return geometry::sign_beyond<Number>(dot(x.u, seen.g), (x.error + Number(kExitBound * Precision<Number>::kRoundoff)) *
                                                             Number(sqrt(seen.squared_size)));
}

// OrderOfExits: h_j <U,g_i> - h_i <U,g_j>. Value and bound are compared by their squares, which spares two roots: with
// |h| <= G^2 / 4 and (G_i + G_j)^2 <= 2 (G_i^2 + G_j^2) the square of the error is at most
// order_factor(x) G_i^2 G_j^2 (G_i^2 + G_j^2). A direction that is not known has an infinite factor.
template <class Number>
[[nodiscard]] Number order_factor(const Direction<Number>& x) {
  if (!x.is_known()) return Number(HUGE_VAL);
  const Number part = Number(0.25) * x.error + Number(kOrderBound * Precision<Number>::kRoundoff);
  return Number(2) * part * part;
}
template <class Number>
[[nodiscard]] geometry::MaybeSign order_sign(const Direction<Number>& x, const Number& factor, FacetEdge facet,
                                             const Point& qi, const Point& qj) {
  const Bisector<Number> i = bisector<Number>(facet, qi), j = bisector<Number>(facet, qj);
  const Number value = j.h * dot(x.u, i.g) - i.h * dot(x.u, j.g);
  const Number bound = factor * (i.squared_size * j.squared_size * (i.squared_size + j.squared_size));
  // Nothing of this is true of a NaN.
  const bool is_certain = value * value > bound && Precision<Number>::is_in_range(i.squared_size) &&
                          Precision<Number>::is_in_range(j.squared_size);
  if (!is_certain) return std::nullopt;
  return value > 0 ? Sign::kPositive : Sign::kNegative;
}
template <class Number>
[[nodiscard]] geometry::MaybeSign order_sign(const Direction<Number>& x, FacetEdge facet, const Point& qi,
                                             const Point& qj) {
  return order_sign(x, order_factor(x), facet, qi, qj);
}

// AlongEdge: <U,n>, of the direction before the crossing.
template <class Number>
[[nodiscard]] geometry::MaybeSign normal_sign(const Direction<Number>& x, const Point& a, const Point& b,
                                              const Point& c) {
  const Vector3<Number> ab = difference<Number>(a, b), ac = difference<Number>(a, c);
  if (!x.is_known() || !Precision<Number>::is_in_range(dot(ab, ab)) || !Precision<Number>::is_in_range(dot(ac, ac))) {
    return std::nullopt;
  }
  return geometry::sign_beyond<Number>(
      dot(x.u, cross(ab, ac)),
      (x.error + Number(kNormalBound * Precision<Number>::kRoundoff)) * length(ab) * length(ac));
}

}  // namespace flowcert::flow
