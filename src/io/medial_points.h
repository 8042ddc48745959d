// Which critical points of index 1 and 2 make a medial axis: by persistence, by their distance to the points, by angle,
// or by several of these (FC-MED-01 to 03).
//
// Guarantees: exact. Angles are compared by their cosines, which are rational; that of the bound is enclosed as sharply
// as a comparison needs. Source: J. Giesen, E. A. Ramos, B. Sadri, Medial axis approximation and unstable flow complex,
// 2006.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "morse/length_bound.h"

namespace flowcert {

struct MedialChoice {
  // Only points whose persistence pairs are longer (LengthBound), of the lengths of all pairs that have such points.
  std::optional<LengthBound> persistence_above;
  // Only points that see two of their contacts under a greater angle, in degrees, 0 to 180.
  std::optional<Rational> angle_above;
  // Only points whose distance to their nearest points is greater: a bound on radii (LengthBound), of all such points.
  std::optional<LengthBound> radius_above;
};

struct MedialPoints {
  std::vector<std::size_t> records;  // places in the list of stationary points, ascending
  // What `auto` found, where it was asked for.
  std::optional<AutomaticThreshold> automatic_persistence, automatic_radius;
};

// Persistence needs the whole complex.
[[nodiscard]] MedialPoints medial_points(const FlowComplex& complex, const MedialChoice& choice);

// Whether an angle with this cosine is greater than so many degrees. Throws InvalidInput unless the degrees are from 0
// to 180.
[[nodiscard]] bool is_above_angle(const Rational& cosine, const Rational& degrees);

}  // namespace flowcert
