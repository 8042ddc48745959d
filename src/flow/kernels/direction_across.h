// The direction of a moving point after it has crossed a facet (src/flow/cascades.md).
//
// Guarantees: as direction.h. Crossing a facet is linear in the direction, so nothing is divided by and no point is
// constructed.
#pragma once

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
  const Number rounding(kAreaBound * Precision<Number>::kRoundoff);
  const Number here = length(cross(seen.a, seen.b)) + rounding * length(seen.a) * length(seen.b);
  const Number there = length(cross(to_0, to_1)) - rounding * length(to_0) * length(to_1);
  way.squared_area_ratio =
      select(condition(there > Number(0)), Number(here * here / (there * there)), Number(HUGE_VAL));
  return way;
}

// Whether <u,g> is certainly positive, or certainly negative. Its sign is that of h, because s in x' = m + s u is
// h / <u,g>, and positive. So it is enough that one of them is certain.
template <class Number>
struct SignOfWay {
  Condition<Number> is_positive, is_negative;
};
template <class Number>
[[nodiscard, gnu::always_inline]] inline SignOfWay<Number> sign_of_way(const Number& approach,
                                                                       const Number& approach_bound, const Number& h,
                                                                       const Number& h_bound) {
  return {condition(approach > approach_bound) | condition(h > h_bound),
          condition(approach < -approach_bound) | condition(h < -h_bound)};
}

// u' = A drop + 2 h u, with A = <u,g>; backward (A, h < 0) its opposite. The edges of the two facets are `e` and
// `next`. The lanes of direction_lanes.cpp share this, so there is no branch.
template <class Number>
[[nodiscard, gnu::always_inline]] inline MaybeDirection<Number> direction_behind(const Direction<Number>& x,
                                                                                 const Bisector<Number>& seen,
                                                                                 const Passage<Number>& way,
                                                                                 const Vector3<Number>& e,
                                                                                 const Vector3<Number>& next) {
  using std::sqrt;
  const Number ee = dot(e, e), next_ee = dot(next, next);
  const Number roundoff(Precision<Number>::kRoundoff);
  const Number size = sqrt(seen.squared_size), approach = dot(x.u, seen.g);
  const Number angle_bound = Number(kAngleFormBound) * roundoff * seen.squared_size;
  const SignOfWay<Number> sign =
      sign_of_way<Number>(approach, (x.error + Number(kExitBound) * roundoff) * size, seen.h, angle_bound);

  const Vector3<Number> y = approach * way.drop + Number(2) * seen.h * x.u;
  const Number inverse = Number(1) / Number(sqrt(Number(dot(y, y))));
  const Number rounding = Number(kCrossingBound) * roundoff * way.squared_size * inverse;
  // The map's determinant in the facets' planes is 4 |h||h'| f |e'|/|e|, and its norm 2 max(|h|, |h'| f |e'|/|e|).
  const Number scaling = sqrt(Number(way.squared_area_ratio * next_ee / ee));
  const Number height = (absolute(way.height) + Number(kHeightBound) * roundoff * way.squared_size) * scaling;
  const Number angle = absolute(seen.h) + angle_bound;
  const Number turn = Number(4) * angle * height * inverse * inverse;
  const Number norm = Number(2) * most<Number>(angle, height) * inverse;
  const Number slack = (turn + norm) * x.error + rounding;
  const Number factor = select(sign.is_positive, inverse, Number(-inverse));
  return {{factor * (y - Number(dot(y, next) / next_ee) * next),
           (turn * x.error + rounding) * (Number(1) + Number(kTangentBehind) * slack)},
          condition(x.is_known()) & Precision<Number>::is_in_range(seen.squared_size) &
              Precision<Number>::is_in_range(ee) & Precision<Number>::is_in_range(next_ee) &
              (sign.is_positive | sign.is_negative) & condition(inverse > Number(0)) &
              condition(slack < Number(kLargestError))};
}

template <class Number>
[[nodiscard, gnu::always_inline]] inline MaybeDirection<Number> step_across(const Direction<Number>& x, FacetEdge from,
                                                                            const Point& q, FacetEdge to) {
  const Bisector<Number> seen = bisector<Number>(from, q);
  return direction_behind<Number>(x, seen, passage(from, q, seen, to), difference<Number>(*from.p0, *from.p1),
                                  difference<Number>(*to.p0, *to.p1));
}
template <class Number>
[[nodiscard]] Direction<Number> direction_across(const Direction<Number>& x, FacetEdge from, const Point& q,
                                                 FacetEdge to) {
  if (!x.is_known()) return {};
  return step_across<Number>(x, from, q, to).direction();
}

}  // namespace flowcert::flow
