// A point of the cascade kernel: what it was made of, and what each precision knows of its direction. And how each
// precision beyond the doubles makes the directions of a recipe, keeps them, and hands them down to the lower ones.
//
// Guarantees: a recipe refers to samples and to the point before it. It has no coordinates, unless the point was given.
// A direction that is handed down is rounded, and its bound covers that. Integers are exact.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "flow/kernels/direction_across.h"
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

template <class Number>
[[nodiscard]] Number nearest_number(const Extended& value) {
  if constexpr (std::is_same_v<Number, DoubleDouble>) {
    const auto high = static_cast<double>(value);
    return Number::sum(high, static_cast<double>(Extended(value - high)));
  } else {
    return static_cast<Number>(value);
  }
}
// The components are rounded once more.
template <class Number>
[[nodiscard]] Direction<Number> rounded_direction(const Direction<Extended>& x) {
  if (!x.is_known()) return {};
  const Extended error = x.error + Extended(kGivenStartBound * Precision<Number>::kRoundoff);
  return {{nearest_number<Number>(x.u.x), nearest_number<Number>(x.u.y), nearest_number<Number>(x.u.z)},
          nearest_number<Number>(error)};
}
// An integer direction in floating point. Dropping what lies 300 bits below the longest component changes it by far
// less than the bound.
[[nodiscard]] inline Direction<Extended> rounded_direction(const IntegerDirection& u) {
  std::size_t bits = 0;
  for (const BigInteger* part : {&u.x, &u.y, &u.z}) {
    if (*part != 0) bits = std::max(bits, mpz_sizeinbase(part->backend().data(), 2));
  }
  if (bits == 0) return {};
  constexpr std::size_t kKeptBits = 300;
  const std::size_t shift = bits > kKeptBits ? bits - kKeptBits : 0;
  const auto part = [shift](const BigInteger& value) { return Extended(BigInteger(value >> shift)); };
  const Vector3<Extended> v{part(u.x), part(u.y), part(u.z)};
  return rounded_direction<Extended>(Direction<Extended>{Extended(1 / length(v)) * v, 0});
}

// For a point that is not a crossing, and for a crossing whose arrival is known in this precision.
template <class Number>
[[nodiscard]] Direction<Number> first_direction(const CascadePoint& x, FacetEdge facet) {
  switch (x.kind) {
    case CascadePoint::Kind::kGiven:
      break;  // it begins as integers
    case CascadePoint::Kind::kCircle:
      return direction_from_circle<Number>(x.circle(), facet);
    case CascadePoint::Kind::kSphere:
      return direction_from_vertex<Number>(x.samples, facet);
    case CascadePoint::Kind::kCrossing:
      break;
  }
  if constexpr (std::is_same_v<Number, double>) {
    return direction_across(x.arrival, x.crossed(), *x.samples[2], facet);
  }
  return {};
}

// ---- Rungs ----
// `start` and `across` make directions, `cached` is what a point has, and `keep` stores it there,
// for the lower precisions too, and returns it in doubles.

template <class Number>
struct InFloat {
  static constexpr bool kIsLong = false;
  using Value = Direction<Number>;
  static Value start(const CascadePoint& x, FacetEdge facet) { return first_direction<Number>(x, facet); }
  static Value across(const Value& u, FacetEdge from, const Point& q, FacetEdge to) {
    return direction_across(u, from, q, to);
  }
  static const Value* cached(const CascadePoint& x, FacetEdge facet) {
    if (!x.refined) return nullptr;
    const SeenDirection<Number>& seen = x.refined->template seen<Number>();
    return seen.facing == facet ? &seen.direction : nullptr;
  }
  static Direction<double> keep(RefinedDirections& refined, FacetEdge facet, const Value& value) {
    refined.template seen<Number>() = {facet, value};
    if constexpr (std::is_same_v<Number, Extended>) {
      refined.doubled = {facet, rounded_direction<DoubleDouble>(value)};
      return rounded_direction<double>(value);
    } else {
      if (!value.is_known()) return {};
      return {{value.u.x.high(), value.u.y.high(), value.u.z.high()},
              value.error.high() + kGivenStartBound * Precision<double>::kRoundoff};
    }
  }
};
struct InIntegers {
  static constexpr bool kIsLong = true;
  using Value = IntegerDirection;
  static Value start(const CascadePoint& x, FacetEdge facet) {
    if (x.kind == CascadePoint::Kind::kGiven) return exact_direction_from_position(x.refined->given, facet);
    if (x.kind == CascadePoint::Kind::kSphere) return exact_direction_from_vertex(x.samples, facet);
    return exact_direction_from_circle(x.circle(), facet);
  }
  static Value across(const Value& u, FacetEdge from, const Point& q, FacetEdge to) {
    return exact_direction_across(u, from, q, to);
  }
  static const Value* cached(const CascadePoint& x, FacetEdge facet) {
    const bool is_there = x.refined && x.refined->has_integers && x.refined->integer_facing == facet;
    return is_there ? &x.refined->integers : nullptr;
  }
  static Direction<double> keep(RefinedDirections& refined, FacetEdge facet, const Value& value) {
    refined.integers = value;
    refined.integer_facing = facet;
    refined.has_integers = true;
    return InFloat<Extended>::keep(refined, facet, rounded_direction(value));
  }
};

}  // namespace flowcert::flow
