// Which critical points of index 1 and 2 make a medial axis: by persistence, by angle, or by both (FC-MED-01 to 03).
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
#include "flowcert/length_bound.h"

namespace flowcert {

struct MedialChoice {
  // Only points whose persistence pairs are longer (LengthBound), of the lengths of all pairs that have such points.
  std::optional<LengthBound> persistence_above;
  // Only points that see two of their contacts under a greater angle, in degrees, 0 to 180.
  std::optional<Rational> angle_above;
};

// Places in the list of stationary points, ascending. Persistence needs the whole complex.
[[nodiscard]] std::vector<std::size_t> medial_points(const FlowComplex& complex, const MedialChoice& choice);

// Whether an angle with this cosine is greater than so many degrees. Throws InvalidInput unless the degrees are from 0
// to 180.
[[nodiscard]] bool is_above_angle(const Rational& cosine, const Rational& degrees);

}  // namespace flowcert
