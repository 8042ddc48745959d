// Where the ray of a direction meets a bisector, and how far that is from the samples, within bounds.
//
// Guarantees: the bounds hold for every direction that is within its own bound (src/flow/cascades.md); they are
// infinite where the direction is not known, or where the ray is nearly parallel to the bisector.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "flow/kernels/direction.h"
#include "geometry/bounded_sphere.h"

namespace flowcert::flow {

using geometry::BoundedNumber;
using geometry::BoundedSphere;

// ---- Constants of the bounds, in units of the roundoff (src/flow/cascades.md, "Coordinates in doubles") ----

inline constexpr double kCutBound = 4;             // of what lies below doubled doubles: 2
inline constexpr double kCoordinateBound = 2;      // the midpoint and the sum, times their sizes
inline constexpr double kCrossingSquareBound = 8;  // 7.1, of the squared distance
// An error E of the way from the midpoint adds this times E times its length to the squared distance, and E^2: 2, with
// the rounding of the bound.
inline constexpr double kCrossingSquareShare = 2.5;

// As doubled doubles.
[[nodiscard]] inline const DoubleDouble& in_doubled(const DoubleDouble& value) { return value; }
[[nodiscard]] inline DoubleDouble in_doubled(const Extended& value) {
  const auto high = static_cast<double>(value);
  return std::isfinite(high) ? DoubleDouble::sum(high, static_cast<double>(Extended(value - Extended(high)))) : high;
}

// A bound is rounded. It may underflow, and so may what the value is cut to.
template <class Number>
[[nodiscard]] BoundedNumber bounded(const Number& value, const Number& error) {
  const DoubleDouble doubled = in_doubled(value);
  const double reach = in_doubled(error).high() + kCutBound * DoubleDouble::kRoundoff * std::fabs(doubled.high());
  return {doubled, reach * geometry::kBoundedSlack + 4 * std::numeric_limits<double>::denorm_min()};
}

// The direction is seen from the midpoint m of the facet that is left by the bisector of q. The point is
// x' = m + h U / A with A = <U,g>.
template <class Number>
[[nodiscard]] BoundedSphere sphere_at_crossing(const Direction<Number>& x, FacetEdge facet, const Point& q) {
  using std::abs;
  using std::sqrt;
  const Bisector<Number> seen = bisector<Number>(facet, q);
  if (!x.is_known() || !Precision<Number>::is_in_range(seen.squared_size)) return {};
  const Number roundoff(Precision<Number>::kRoundoff), size = sqrt(seen.squared_size), approach = dot(x.u, seen.g);
  const Number turn = x.error + Number(kExitBound) * roundoff;
  const Number approach_size = abs(approach), approach_bound = turn * size;
  if (!(approach_size > Number(2) * approach_bound)) return {};
  const Number height_bound = Number(kAngleFormBound) * roundoff * seen.squared_size;
  const Number spread = turn + approach_bound / (approach_size - approach_bound);
  const Number error = (height_bound + (abs(seen.h) + height_bound) * spread) / approach_size * Number(kCrossingSlack);

  const Vector3<Number> step = Number(seen.h / approach) * x.u;
  const auto coordinate = [&](double one, double other, const Number& part) {
    const Number middle = Number(one / 2) + Number(other / 2), value = middle + part;
    return bounded<Number>(value, error + Number(kCoordinateBound) * roundoff * (abs(middle) + abs(value)));
  };
  const auto [p0, p1] = facet;
  const Vector3<Number> e = difference<Number>(*p0, *p1);
  const Number from_middle = dot(step, step), square = Number(0.25) * Number(dot(e, e)) + from_middle;
  const Number square_error = Number(kCrossingSquareBound) * roundoff * square +
                              error * (Number(kCrossingSquareShare) * Number(sqrt(from_middle)) + error);
  return {{coordinate(p0->x, p1->x, step.x), coordinate(p0->y, p1->y, step.y), coordinate(p0->z, p1->z, step.z)},
          bounded<Number>(square, square_error)};
}

}  // namespace flowcert::flow
