// The power diagram of balls that are all grown by one probe radius: a regular triangulation of space.
//
// Guarantees: exact. It is one of several where balls are equally far. A ball is a corner iff its cell is not empty,
// also where that is a face of others' cells: CGAL perturbs weights, and so that a ball with its centre between others
// keeps its own.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "flowcert/ball_set.h"

namespace flowcert {

// The tetrahedra of the triangulation, and behind each corner the number of the tetrahedron that has the others, or
// kNone. Empty where the centres of these balls span no more than a plane. Expected O(n log n) for atoms.
struct BallSlice {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Corners = std::array<std::uint32_t, 4>;

  BallSlice(const BallSet& balls, std::span<const std::uint32_t> ids, const Rational& probe);

  std::vector<Corners> tetrahedra, adjacent;
};

}  // namespace flowcert
