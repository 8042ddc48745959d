// The power diagram of balls that are all grown by one probe radius: a regular triangulation of space.
//
// Guarantees: exact. It is one of several where balls are equally far. Balls whose cells are empty are no corners, and
// nor are some whose cells are no more than a face of others'.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "flowcert/ball_set.h"

namespace flowcert {

// The tetrahedra of the triangulation, and behind each corner the number of the tetrahedron that has the others, or
// kNone. Empty where the centres of these balls span no more than a plane. Expected O(n log n) for atoms.
struct BallSlice {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Corners = std::array<std::uint32_t, 4>;

  // Of balls with different centres.
  BallSlice(const BallSet& balls, std::span<const std::uint32_t> ids, const Rational& probe);

  std::vector<Corners> tetrahedra, adjacent;
  // The balls that are no corners, each with the number of a tetrahedron that has its centre.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> others;
};

}  // namespace flowcert
