// The signs that steer the flow (paper, section 4.2), as polynomials over any number type, asked of a
// construction kernel.
//
// A construction kernel (LazyKernel, ExactKernel) has a type Point for points that were constructed, and
// decides the sign of a polynomial: Kernel::decide(primitive, f) calls f(in), where in(x) is the vector of a
// constructed or an input point in numbers of the kernel's choice. Guarantees: exact, for every kernel.
// Every polynomial is homogeneous in the coordinates, so that a common factor does not change its sign: a
// kernel may clear denominators. Midpoints m of p0 and p1 appear doubled. With p0 = p1 = p the facet is a
// cell, and m is p.
#pragma once

#include "flowcert/kernel_tally.h"
#include "flowcert/point_set.h"
#include "geometry/sign.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

// 2 (x - m)
template <class Number>
[[nodiscard]] Vector3<Number> from_midpoint(const Vector3<Number>& x, const Vector3<Number>& p0,
                                            const Vector3<Number>& p1) {
  return Number(2) * x - (p0 + p1);
}

// <(x-m) ^ (c-m), p0p1>: positive where c lies counterclockwise of the ray from m through x, seen from p1
// (Eq. 2, 3).
template <class Kernel>
[[nodiscard]] Sign side_of_ray(Kernel& kernel, const typename Kernel::Point& x, const Point& p0,
                               const Point& p1, const typename Kernel::Point& c) {
  return kernel.decide(FlowPrimitive::kSideOfRay, [&](const auto& in) {
    const auto v0 = in(p0), v1 = in(p1);
    return dot(cross(from_midpoint(in(x), v0, v1), from_midpoint(in(c), v0, v1)), v1 - v0);
  });
}

// <x-m, q-m>: whether the ray from m through x approaches the bisector of q. That is the sign of Eq. 5, for
// the Voronoi ray of p0 p1 q: its direction is +-(p1-p0) x (q-p0), and <d x (e x g), e> = <d,g> <e,e> for d
// orthogonal to e.
template <class Kernel>
[[nodiscard]] Sign ray_at_infinity(Kernel& kernel, const typename Kernel::Point& x, const Point& p0,
                                   const Point& p1, const Point& q) {
  return kernel.decide(FlowPrimitive::kRayAtInfinity, [&](const auto& in) {
    const auto v0 = in(p0), v1 = in(p1);
    return dot(from_midpoint(in(x), v0, v1), from_midpoint(in(q), v0, v1));
  });
}

// <(b-x) ^ (c-x), p0p1>: positive where c lies less than half a turn counterclockwise of b, seen from x.
template <class Kernel>
[[nodiscard]] Sign around_start(Kernel& kernel, const typename Kernel::Point& x, const Point& p0,
                                const Point& p1, const typename Kernel::Point& b,
                                const typename Kernel::Point& c) {
  return kernel.decide(FlowPrimitive::kAroundStart, [&](const auto& in) {
    const auto& start = in(x);
    return dot(cross(in(b)-start, in(c)-start), in(p1)-in(p0));
  });
}

// <b-x, q-m>: the same for the direction of the Voronoi ray of p0 p1 q in place of c (see above).
template <class Kernel>
[[nodiscard]] Sign ray_around_start(Kernel& kernel, const typename Kernel::Point& x, const Point& p0,
                                    const Point& p1, const typename Kernel::Point& b, const Point& q) {
  return kernel.decide(FlowPrimitive::kAroundStart, [&](const auto& in) {
    return dot(in(b)-in(x), from_midpoint(in(q), in(p0), in(p1)));
  });
}

// <x-m, c-x>: whether c, on the line from m through x, lies beyond x.
template <class Kernel>
[[nodiscard]] Sign beyond_start(Kernel& kernel, const typename Kernel::Point& x, const Point& p0,
                                const Point& p1, const typename Kernel::Point& c) {
  return kernel.decide(FlowPrimitive::kAroundStart, [&](const auto& in) {
    const auto& start = in(x);
    return dot(from_midpoint(start, in(p0), in(p1)), in(c)-start);
  });
}

// <x-a, (b-a) x (c-a)>: for x on the Voronoi edge of a polygon with corners a, b, c, the side of the
// polygon's plane, and so of its centre, on which x lies.
template <class Kernel>
[[nodiscard]] Sign along_edge(Kernel& kernel, const typename Kernel::Point& x, const Point& a, const Point& b,
                              const Point& c) {
  return kernel.decide(FlowPrimitive::kAlongEdge, [&](const auto& in) {
    const auto origin = in(a);
    return dot(in(x)-origin, cross(in(b)-origin, in(c)-origin));
  });
}

// The ray from p through x meets the bisector of q at p + s (x-p), s = |q-p|^2 / (2 <x-p, q-p>). The sign of
// s(q) - s(r), for q and r that it approaches.
template <class Kernel>
[[nodiscard]] Sign compare_exits(Kernel& kernel, const typename Kernel::Point& x, const Point& p,
                                 const Point& q, const Point& r) {
  return kernel.decide(FlowPrimitive::kNearerExit, [&](const auto& in) {
    const auto origin = in(p);
    const auto way = in(x)-origin, to_q = in(q)-origin, to_r = in(r)-origin;
    using Number = decltype(dot(way, to_q));
    return Number(dot(to_q, to_q) * dot(way, to_r) - dot(to_r, to_r) * dot(way, to_q));
  });
}

// Where the ray from m through x meets the bisector of p0 (or p1) and q, which it approaches: m + s (x-m), s
// = <q-p0, q-p1> / (2 <x-m, q-m>).
template <class Number>
[[nodiscard]] Vector3<Number> crossing(const Vector3<Number>& x, const Vector3<Number>& p0,
                                       const Vector3<Number>& p1, const Vector3<Number>& q) {
  const Vector3<Number> way = from_midpoint(x, p0, p1);
  const Number height = dot(q - p0, q - p1);
  const Number approach = dot(way, from_midpoint(q, p0, p1));
  const Number stretch = Number(2) * height / approach;
  const Number half = Number(1) / Number(2);
  return half * (p0 + p1 + stretch * way);
}

// The same in integers: x is given times `weight`, and the point returned as numerator / denominator. What x
// is divided by cancels, so that the numbers grow by those of the samples alone.
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

}  // namespace flowcert::geometry
