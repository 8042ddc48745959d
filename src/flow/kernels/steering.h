// What steers the flow: the signs that a moving point x is asked for (paper, section 4.2), and the points that are
// constructed from it, as polynomials over any number type.
//
// Each query is a struct that exposes its polynomial as a linear form in x, <gradient, scale x - base>. A kernel
// evaluates it as it likes: in intervals, in integers, or pulled back through the maps that made x. Guarantees: all
// forms are homogeneous in the coordinates of all points. A common factor does not change a sign, so a kernel may
// clear denominators. Midpoints m of p0 and p1 appear doubled. With p0 = p1 = p the facet is a cell, and m is p.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include "flow/kernels/layer.h"
#include "flowcert/flow_statistics.h"
#include "flowcert/point_set.h"
#include "geometry/vector3.h"

namespace flowcert::flow {

// A point that a kernel keeps.
using PointNumber = std::uint32_t;
inline constexpr PointNumber kNoPoint = 0xffffffffu;
inline constexpr PointNumber kLasting = 0x80000000u;

template <class Number>
struct LinearForm {
  Vector3<Number> gradient;
  int scale;
  Vector3<Number> base;

  [[nodiscard]] Number operator()(const Vector3<Number>& x) const {
    return scale == 1 ? Number(dot(gradient, x - base)) : Number(dot(gradient, Number(scale) * x - base));
  }
};
template <class Number>
[[nodiscard]] LinearForm<Number> linear_form(Vector3<Number> gradient, int scale, Vector3<Number> base) {
  return {std::move(gradient), scale, std::move(base)};
}

// 2 (x - m)
template <class Number>
[[nodiscard]] Vector3<Number> from_midpoint(const Vector3<Number>& x, const Vector3<Number>& p0,
                                            const Vector3<Number>& p1) {
  return Number(2) * x - (p0 + p1);
}

// In each query, `at` gives the vector of an input point or of a kept one, in numbers of the kernel's choice.

// <(x-m) ^ (c-m), p0p1>: positive where c lies counterclockwise of the ray from m through x, seen from p1
// (Eq. 2, 3).
struct SideOfRay {
  static constexpr FlowPrimitive kPrimitive = FlowPrimitive::kSideOfRay;
  PointNumber x;
  const Point &p0, &p1;
  PointNumber c;

  [[nodiscard]] auto form(const auto& at) const {
    const auto v0 = at(p0), v1 = at(p1), sum = v0 + v1;
    return linear_form(cross(from_midpoint(at(c), v0, v1), v1 - v0), 2, sum);
  }
};

// h_j <x-m, g_i> - h_i <x-m, g_j>, with g = 2 (q-m) and h = <q-p0, q-p1>: the side of the ray from m through x on which
// the point lies that is equally far from p0, p1, qi and qj. It is SideOfRay of that point c if <g_i ^ g_j, p0p1> is
// positive, so if qj follows qi counterclockwise around the facet. (c-m solves <c-m, g> = h for both.)
struct OrderOfExits {
  static constexpr FlowPrimitive kPrimitive = FlowPrimitive::kSideOfRay;
  PointNumber x;
  const Point &p0, &p1, &qi, &qj;

  [[nodiscard]] auto form(const auto& at) const {
    const auto v0 = at(p0), v1 = at(p1), wi = at(qi), wj = at(qj);
    using Number = std::remove_cvref_t<decltype(v0.x)>;
    const Number hi = dot(wi - v0, wi - v1), hj = dot(wj - v0, wj - v1);
    return linear_form(hj * from_midpoint(wi, v0, v1) - hi * from_midpoint(wj, v0, v1), 2, v0 + v1);
  }
};

// <x-m, q-m>, for an input point or a kept one q.
template <FlowPrimitive primitive, class Target>
struct Towards {
  static constexpr FlowPrimitive kPrimitive = primitive;
  PointNumber x;
  const Point &p0, &p1;
  Target q;

  [[nodiscard]] auto form(const auto& at) const {
    const auto v0 = at(p0), v1 = at(p1);
    return linear_form(from_midpoint(at(q), v0, v1), 2, v0 + v1);
  }
};
// Whether the ray from m through x approaches the bisector of q. This is the sign of Eq. 5 for the Voronoi ray of
// p0 p1 q. The direction of that ray is +-(p1-p0) x (q-p0), and <d x (e x g), e> = <d,g> <e,e> for d orthogonal to e.
using RayAtInfinity = Towards<FlowPrimitive::kRayAtInfinity, const Point&>;
// For q on the line from m through x: positive where q and x lie on the same side of m.
using AlongRay = Towards<FlowPrimitive::kAroundStart, PointNumber>;

// <(b-x) ^ (c-x), p0p1>: positive where c lies less than half a turn counterclockwise of b, seen from x. It is
// <p0p1 ^ (c-b), x-b>.
struct AroundStart {
  static constexpr FlowPrimitive kPrimitive = FlowPrimitive::kAroundStart;
  PointNumber x;
  const Point &p0, &p1;
  PointNumber b, c;

  [[nodiscard]] auto form(const auto& at) const {
    const auto from = at(b);  // NOLINT(performance-unnecessary-copy-initialization): most are doubles
    return linear_form(cross(at(p1) - at(p0), at(c) - from), 1, from);
  }
};

// <x-b, m-q>, for an input point or a kept one q.
template <class Target>
struct Away {
  static constexpr FlowPrimitive kPrimitive = FlowPrimitive::kAroundStart;
  PointNumber x;
  const Point &p0, &p1;
  PointNumber b;
  Target q;

  [[nodiscard]] auto form(const auto& at) const {
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): most are doubles
    const auto v0 = at(p0), v1 = at(p1), w = at(q);
    return linear_form((v0 + v1) - (w + w), 1, at(b));
  }
};
// AroundStart for the direction of the Voronoi ray of p0 p1 q in place of c (see RayAtInfinity).
using RayAroundStart = Away<const Point&>;
// For b = q on the line from m through x: positive where x lies before q, seen from m.
using BeforePoint = Away<PointNumber>;

// <x-a, (b-a) x (c-a)>, for x on the Voronoi edge of a polygon with corners a, b, c: the side of the polygon's plane
// on which x lies. It is also the side of the polygon's centre.
struct AlongEdge {
  static constexpr FlowPrimitive kPrimitive = FlowPrimitive::kAlongEdge;
  PointNumber x;
  const Point &a, &b, &c;

  [[nodiscard]] auto form(const auto& at) const {
    const auto origin = at(a);
    return linear_form(cross(at(b) - origin, at(c) - origin), 1, origin);
  }
};

// The ray from p through x meets the bisector of q at p + s(q) (x-p), with s(q) = |q-p|^2 / (2 <x-p, q-p>). For q and
// r that the ray approaches, s(q) - s(r) has the sign of <x-p, |q-p|^2 (r-p) - |r-p|^2 (q-p)>.
struct NearerExit {
  static constexpr FlowPrimitive kPrimitive = FlowPrimitive::kNearerExit;
  PointNumber x;
  const Point &p, &q, &r;

  [[nodiscard]] auto form(const auto& at) const {
    const auto origin = at(p), to_q = at(q) - origin, to_r = at(r) - origin;
    using Number = std::remove_cvref_t<decltype(origin.x)>;
    return linear_form(Number(dot(to_q, to_q)) * to_r - Number(dot(to_r, to_r)) * to_q, 1, origin);
  }
};

// A kernel answers each of these.
template <class... Query>
struct QueryList {};
using SteeringQueries = QueryList<SideOfRay, OrderOfExits, RayAtInfinity, AroundStart, RayAroundStart, AlongRay,
                                  BeforePoint, AlongEdge, NearerExit>;

// ---- Constructions ----

// The ray from m through x approaches the bisector of p0 (or p1) and q. It meets the bisector at m + s (x-m), with s
// = <q-p0, q-p1> / (2 <x-m, q-m>).
template <class Number>
[[nodiscard]] Vector3<Number> crossing(const Vector3<Number>& x, const Vector3<Number>& p0, const Vector3<Number>& p1,
                                       const Vector3<Number>& q) {
  const Vector3<Number> way = from_midpoint(x, p0, p1);
  const Number height = dot(q - p0, q - p1);
  const Number approach = dot(way, from_midpoint(q, p0, p1));
  const Number factor = Number(2) * height / approach;
  const Number half = Number(1) / Number(2);
  return half * (p0 + p1 + factor * way);
}

// The same in integers: x is given times `weight`, and the result is numerator / denominator. The denominator of x
// cancels, so the numbers grow by those of the samples alone.
template <class Integer>
struct WeightedPoint {
  Vector3<Integer> numerator;
  Integer denominator;
};
template <class Integer>
[[nodiscard]] WeightedPoint<Integer> weighted_crossing(const Vector3<Integer>& x, const Integer& weight,
                                                       const Vector3<Integer>& p0, const Vector3<Integer>& p1,
                                                       const Vector3<Integer>& q) {
  const Vector3<Integer> way = Integer(2) * x - weight * (p0 + p1);
  const Integer height = Integer(2) * dot(q - p0, q - p1);
  const Integer approach = dot(way, from_midpoint(q, p0, p1));
  return {approach * (p0 + p1) + height * way, Integer(2) * approach};
}

// The centre of the circle through three points.
template <class Number>
[[nodiscard]] Vector3<Number> circumcenter(const Vector3<Number>& p0, const Vector3<Number>& p1,
                                           const Vector3<Number>& p2) {
  const Vector3<Number> a = p1 - p0, b = p2 - p0;
  const Vector3<Number> n = cross(a, b);
  const Number factor = Number(1) / (Number(2) * dot(n, n));
  return p0 + factor * cross(dot(a, a) * b - dot(b, b) * a, n);
}

// The centre of the circumsphere of a tetrahedron.
template <class Number>
[[nodiscard]] Vector3<Number> circumcenter(const Vector3<Number>& p0, const Vector3<Number>& p1,
                                           const Vector3<Number>& p2, const Vector3<Number>& p3) {
  const Circumsphere<Number> sphere = circumsphere(p1 - p0, p2 - p0, p3 - p0);
  const Number factor = Number(1) / (Number(2) * sphere.determinant);
  return p0 + factor * sphere.numerator;
}

}  // namespace flowcert::flow
