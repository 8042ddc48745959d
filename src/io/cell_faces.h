// The faces between the cells S3: what separates the parts of dimension 3 of stable sets.
//
// Guarantees: exact, but for the positions, which are the nearest doubles. The triangles between one cell and all
// others are closed: each edge is passed as often one way as the other way. No two triangles have the same corners,
// and two corners are one iff they are exactly equal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flowcert/flow_complex.h"
#include "io/layer.h"

namespace flowcert::io {

// What lies between two cells, or between one and what flows to infinity.
struct CellFace {
  static constexpr std::uint32_t kInfinity = 0xffffffffu;

  std::array<std::uint32_t, 2> limits;                  // places in the list of stationary points, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counterclockwise, seen from the second one's side
};

struct CellFaces {
  std::vector<CellFace> faces;  // sorted by their limits
  std::vector<Point> corners;
};

// Those of the cells that are wanted, by place in the list. The time and the memory are those of the facets of all
// cells.
[[nodiscard]] CellFaces cell_faces(const FlowComplex& complex, const std::vector<bool>& is_wanted);

}  // namespace flowcert::io
