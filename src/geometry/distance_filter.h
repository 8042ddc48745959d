// What doubles tell of the distances of samples from a position: the filter of nearest_samples.h.
//
// Guarantees: a sample is farther from the position than another one if its rounded distance is more than the reach of
// the other's. Nothing is told where a value is infinite or NaN. Source: bounds in filter_bounds.h.
#pragma once

#include <cmath>

#include "geometry/condition.h"
#include "geometry/filter_bounds.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

template <class Position>
[[nodiscard]] auto rounded_distance(const Position& from, const Position& to) {
  using std::sqrt;
  const auto v = vector_between(from, to);
  return sqrt(dot(v, v));
}

// largest: the greatest coordinate of the rounded position, without its sign. The reach is infinite, or NaN, where
// doubles decide nothing.
template <class Number>
[[nodiscard]] Number reach_of(const Number& distance, const Number& largest) {
  const Number bound =
      distance * (1 + kDistanceBound * kUnitRoundoff) + kPositionBound * kUnitRoundoff * largest + kDistanceUnderflow;
  return select(condition(bound > kLargestDistance), Number(HUGE_VAL), bound);
}

}  // namespace flowcert::geometry
