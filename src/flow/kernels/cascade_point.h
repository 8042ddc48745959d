// A point of the cascade kernel: what it was made of, and what each precision knows of its direction.
//
// Guarantees: a recipe refers to samples and to the point before it. It has no coordinates, unless the point was given.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "flow/kernels/direction.h"
#include "flow/kernels/exact_direction.h"

namespace flowcert::flow {

// What higher precisions know of a point. Few points have it.
template <class Number>
struct SeenDirection {
  FacetEdge facing;
  Direction<Number> direction;
};

struct RefinedDirections {
  RationalPoint given;  // kGiven
  SeenDirection<DoubleDouble> doubled;
  SeenDirection<Extended> extended;
  FacetEdge integer_facing;
  IntegerDirection integers;
  bool has_integers = false;

  template <class Number>
  [[nodiscard]] SeenDirection<Number>& seen() {
    if constexpr (std::is_same_v<Number, Extended>) {
      return extended;
    } else {
      return doubled;
    }
  }
};

struct CascadePoint {
  enum class Kind : std::uint8_t { kGiven, kCircle, kSphere, kCrossing };

  Kind kind = Kind::kGiven;
  std::uint32_t depth = 0;
  PointNumber from = kNoPoint;            // kCrossing
  std::array<const Point*, 4> samples{};  // of a crossing: p0, p1, q
  FacetEdge facing;                       // `direction` is seen from here
  Direction<double> direction;
  Direction<double> arrival;  // of a crossing: the direction before it
  std::unique_ptr<RefinedDirections> refined;

  [[nodiscard]] FacetEdge crossed() const { return {samples[0], samples[1]}; }
  [[nodiscard]] std::array<const Point*, 3> circle() const { return {samples[0], samples[1], samples[2]}; }
};

}  // namespace flowcert::flow
