// The direction of a moving point after it has crossed a facet (src/flow/cascades.md).
//
// Guarantees: as direction.h. Crossing a facet is linear in the direction, so nothing is divided by and no point is
// constructed.
#pragma once

#include <algorithm>
#include <cmath>

#include "flow/kernels/direction.h"

namespace flowcert::flow {

// The facet `from` is left through the polygon of q, and `to` belongs to another side of that polygon.
template <class Number>
struct Passage {
  Vector3<Number> drop;           // the sum of the ends of `from` less those of `to`
  Number height;                  // the angle under which a corner of the polygon sees `to`
  Number squared_size;            // L^2
  Number squared_area_ratio = 1;  // at most this: (area of q and `from` / area of that corner and `to`)^2
};

// The corner is an end of `from` that is none of `to`. If q is an end of `to`, the corner sees it by the same triangle
// by which q sees `from`.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Passage<Number> passage(FacetEdge from, const Point& q,
                                                                 const Bisector<Number>& seen, FacetEdge to) {
  using std::sqrt;
  const bool keeps_p0 = to.p0 == from.p0 || to.p1 == from.p0, keeps_p1 = to.p0 == from.p1 || to.p1 == from.p1;
  const Point& corner = keeps_p0 ? *from.p1 : *from.p0;
  const Vector3<Number> to_0 = difference<Number>(*to.p0, corner), to_1 = difference<Number>(*to.p1, corner);
  Passage<Number> way;
  way.height = dot(to_0, to_1);
  way.squared_size = seen.squared_size;
  Number drop_size(0);
  if (keeps_p0 || keeps_p1) {
    const bool keeps_first = to.p0 == (keeps_p0 ? from.p0 : from.p1);
    way.drop = keeps_first ? to_1 : to_0;
    if ((keeps_first ? to.p1 : to.p0) == &q) return way;
    drop_size = length(way.drop);
  } else {
    const Vector3<Number> other = difference<Number>(*to.p1, *from.p1);
    way.drop = to_0 + other;
    drop_size = length(to_0) + length(other);
  }
  const Number size = sqrt(seen.squared_size) + drop_size;
  way.squared_size = size * size;
  // Each cross product has an error of at most 6 roundoffs of the lengths' product.
  const Number rounding(6 * Precision<Number>::kRoundoff);
  const Number here = length(cross(seen.a, seen.b)) + rounding * length(seen.a) * length(seen.b);
  const Number there = length(cross(to_0, to_1)) - rounding * length(to_0) * length(to_1);
  way.squared_area_ratio = there > 0 ? Number(here * here / (there * there)) : Number(HUGE_VAL);
  return way;
}

// The sign of <u,g>, or 0 if it is not certain. It is that of h, because s in x' = m + s u is h / <u,g>, and positive.
template <class Number>
[[nodiscard]] int sign_of_way(const Number& approach, const Number& approach_bound, const Number& h,
                              const Number& h_bound) {
  if (approach > approach_bound || h > h_bound) return 1;
  if (approach < -approach_bound || h < -h_bound) return -1;
  return 0;
}

// u' = A drop + 2 h u, with A = <u,g>; backward (A, h < 0) its opposite. The edges of the two facets are `e`, of
// squared length ee, and `next`, of squared length next_ee.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Direction<Number> direction_behind(
    const Direction<Number>& x, const Number& approach, const Number& h, const Number& squared_size,
    const Passage<Number>& way, const Number& ee, const Vector3<Number>& next, const Number& next_ee) {
  using std::abs;
  using std::sqrt;
  if (!x.is_known() || !Precision<Number>::is_in_range(squared_size) || !Precision<Number>::is_in_range(ee) ||
      !Precision<Number>::is_in_range(next_ee)) {
    return {};
  }
  const Number roundoff(Precision<Number>::kRoundoff);
  const Number size = sqrt(squared_size);
  const Number angle_bound = Number(kAngleFormBound) * roundoff * squared_size;
  const int sign = sign_of_way<Number>(approach, (x.error + Number(kExitBound) * roundoff) * size, h, angle_bound);
  if (sign == 0) return {};

  const Vector3<Number> y = approach * way.drop + Number(2) * h * x.u;
  const Number inverse = Number(1) / sqrt(Number(dot(y, y)));
  const Number rounding = Number(kCrossingBound) * roundoff * way.squared_size * inverse;
  // The map's determinant in the facets' planes, and its norm.
  const Number scaling = sqrt(Number(way.squared_area_ratio * next_ee / ee));
  const Number height = (abs(way.height) + Number(kHeightBound) * roundoff * way.squared_size) * scaling;
  const Number angle = abs(h) + angle_bound;
  const Number turn = Number(4) * angle * height * inverse * inverse;
  const Number norm = Number(2) * std::max(angle, height) * inverse;
  const Number slack = (turn + norm) * x.error + rounding;
  if (!(inverse > 0 && slack < Number(0.0625))) return {};
  const Number factor = sign > 0 ? inverse : Number(-inverse);
  return {factor * (y - Number(dot(y, next) / next_ee) * next),
          (turn * x.error + rounding) * (Number(1) + Number(8) * slack)};
}

template <class Number>
[[nodiscard]] Direction<Number> direction_across(const Direction<Number>& x, FacetEdge from, const Point& q,
                                                 FacetEdge to) {
  const Bisector<Number> seen = bisector<Number>(from, q);
  const Vector3<Number> e = difference<Number>(*from.p0, *from.p1), next = difference<Number>(*to.p0, *to.p1);
  return direction_behind<Number>(x, dot(x.u, seen.g), seen.h, seen.squared_size, passage(from, q, seen, to), dot(e, e),
                                  next, dot(next, next));
}

}  // namespace flowcert::flow
