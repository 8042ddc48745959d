// The direction in which a moving point lies, seen from the midpoint m of the facet that it is about to cross, with a
// bound on its error (src/flow/cascades.md).
//
// Guarantees: the true direction lies within the bound, for doubles and for every longer floating-point type that
// rounds to nearest. No point is constructed. A direction whose error is not known to be small is not known at all.
// How it changes from facet to facet is in direction_across.h.
#pragma once

#include <array>
#include <cmath>

#include "flow/kernels/direction_bounds.h"
#include "flow/kernels/layer.h"
#include "flow/kernels/steering.h"
#include "geometry/vector3.h"

namespace flowcert::flow {

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

  [[nodiscard]] auto is_known() const { return error < Number(1); }
};

// A direction that is known on a condition. There is no branch in what computes it, so that lanes share it.
template <class Number>
struct MaybeDirection {
  Direction<Number> if_known;
  Condition<Number> is_known;

  [[nodiscard, gnu::always_inline]] Direction<Number> direction() const {
    if (!is_known) return {};
    return if_known;
  }
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
[[nodiscard]] MaybeDirection<Number> direction_of_vector(const Vector3<Number>& y, const Number& bound,
                                                         const Vector3<Number>& e) {
  using std::sqrt;
  const Number yy = dot(y, y), ee = dot(e, e);
  const Number inverse = Number(1) / Number(sqrt(yy));
  const Number error = bound * inverse;
  // Where the length is infinite, its inverse is zero, and so is the error.
  return {
      {inverse * (y - Number(dot(y, e) / ee) * e), error * (Number(1) + Number(kTangentOfSine) * error)},
      Precision<Number>::is_in_range(ee) & condition(inverse > Number(0)) & condition(error < Number(kLargestError))};
}

// ---- Starts ----

// From the centre of the sphere through four points, positively oriented.
template <class Number>
[[nodiscard]] MaybeDirection<Number> start_at_vertex(const std::array<const Point*, 4>& v, FacetEdge facet) {
  const Vector3<Number> a = difference<Number>(*v[0], *v[1]), b = difference<Number>(*v[0], *v[2]),
                        c = difference<Number>(*v[0], *v[3]);
  const Vector3<Number> w0 = difference<Number>(*facet.p0, *v[0]), w1 = difference<Number>(*facet.p1, *v[0]);
  const geometry::Circumsphere<Number> sphere = geometry::circumsphere(a, b, c);
  const Number na = length(a), nb = length(b), nc = length(c), product = na * nb * nc;
  const Number bound =
      Number(kVertexStartBound * Precision<Number>::kRoundoff) * product * (na + nb + nc + length(w0) + length(w1));
  const Number shortest = least<Number>(least<Number>(na, nb), nc), longest = most<Number>(most<Number>(na, nb), nc);
  const MaybeDirection<Number> start = direction_of_vector<Number>(sphere.numerator + sphere.determinant * (w0 + w1),
                                                                   bound, difference<Number>(*facet.p0, *facet.p1));
  return {start.if_known, Precision<Number>::is_in_range(shortest * shortest) &
                              Precision<Number>::is_in_range(longest * longest) & start.is_known};
}
template <class Number>
[[nodiscard]] Direction<Number> direction_from_vertex(const std::array<const Point*, 4>& v, FacetEdge facet) {
  return start_at_vertex<Number>(v, facet).direction();
}

// From the centre of the circle through the ends of the facet's edge and c.
template <class Number>
[[nodiscard]] MaybeDirection<Number> start_at_side(const Point& c, FacetEdge facet) {
  const Vector3<Number> e = difference<Number>(*facet.p0, *facet.p1), a = difference<Number>(*facet.p0, c),
                        b = difference<Number>(*facet.p1, c);
  const Number ee = dot(e, e), aa = dot(a, a), h = dot(a, b);
  // The size of h is at most a quarter of G^2 = 2 (|a|^2 + |b|^2).
  const Number uncertain = Number(2 * kAngleFormBound * Precision<Number>::kRoundoff) * (aa + dot(b, b));
  using std::sqrt;
  const Number bound = Number(kSideStartBound * Precision<Number>::kRoundoff) * ee * sqrt(aa);
  const Number side = select(condition(h > Number(0)), Number(1), Number(-1));
  const MaybeDirection<Number> start = direction_of_vector<Number>(side * (ee * a - Number(dot(a, e)) * e), bound, e);
  return {start.if_known, Precision<Number>::is_in_range(aa) & condition(absolute(h) > uncertain) & start.is_known};
}
template <class Number>
[[nodiscard]] Direction<Number> direction_from_side(const Point& c, FacetEdge facet) {
  return start_at_side<Number>(c, facet).direction();
}

// From the centre of the circle through three points.
template <class Number>
[[nodiscard]] MaybeDirection<Number> start_at_circle(const std::array<const Point*, 3>& v, FacetEdge facet) {
  const Vector3<Number> a = difference<Number>(*v[0], *v[1]), b = difference<Number>(*v[0], *v[2]);
  const Vector3<Number> w0 = difference<Number>(*facet.p0, *v[0]), w1 = difference<Number>(*facet.p1, *v[0]);
  const Vector3<Number> n = cross(a, b);
  const Number aa = dot(a, a), bb = dot(b, b);
  const Number bound = Number(kCircleStartBound * Precision<Number>::kRoundoff) * aa * bb *
                       (length(a) + length(b) + length(w0) + length(w1));
  const Vector3<Number> y = Number(dot(n, n)) * (w0 + w1) + cross(aa * b - bb * a, n);
  const MaybeDirection<Number> start = direction_of_vector<Number>(y, bound, difference<Number>(*facet.p0, *facet.p1));
  return {start.if_known, Precision<Number>::is_in_range(aa) & Precision<Number>::is_in_range(bb) & start.is_known};
}
template <class Number>
[[nodiscard]] Direction<Number> direction_from_circle(const std::array<const Point*, 3>& v, FacetEdge facet) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point *one = v[(k + 1) % 3], *other = v[(k + 2) % 3];
    if ((facet.p0 == one && facet.p1 == other) || (facet.p0 == other && facet.p1 == one)) {
      return direction_from_side<Number>(*v[k], facet);
    }
  }
  return start_at_circle<Number>(v, facet).direction();
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
[[nodiscard, gnu::always_inline]] inline Bisector<Number> bisector(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a, b, a + b, dot(a, b), Number(2) * (dot(a, a) + dot(b, b))};
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline Bisector<Number> bisector(FacetEdge facet, const Point& q) {
  return bisector<Number>(difference<Number>(*facet.p0, q), difference<Number>(*facet.p1, q));
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
// order_factor(x) G_i^2 G_j^2 (G_i^2 + G_j^2).
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number order_factor(const Direction<Number>& x) {
  const Number part = Number(kOrderTurn) * x.error + Number(kOrderBound * Precision<Number>::kRoundoff);
  return Number(2) * part * part;
}
template <class Number>
struct OrderForm {
  Number value;
  Condition<Number> is_certain;
};
template <class Number>
[[nodiscard, gnu::always_inline]] inline OrderForm<Number> order_form(const Direction<Number>& x, const Number& factor,
                                                                      const Bisector<Number>& i,
                                                                      const Bisector<Number>& j) {
  const Number value = j.h * dot(x.u, i.g) - i.h * dot(x.u, j.g);
  const Number bound = factor * (i.squared_size * j.squared_size * (i.squared_size + j.squared_size));
  // Nothing of this is true of a NaN.
  return {value, condition(x.is_known()) & condition(value * value > bound) &
                     Precision<Number>::is_in_range(i.squared_size) & Precision<Number>::is_in_range(j.squared_size)};
}
template <class Number>
[[nodiscard]] geometry::MaybeSign order_sign(const Direction<Number>& x, const Number& factor, FacetEdge facet,
                                             const Point& qi, const Point& qj) {
  const OrderForm<Number> form =
      order_form<Number>(x, factor, bisector<Number>(facet, qi), bisector<Number>(facet, qj));
  if (!form.is_certain) return std::nullopt;
  return form.value > Number(0) ? Sign::kPositive : Sign::kNegative;
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
