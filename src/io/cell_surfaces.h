// The surfaces of cells, of pockets and voids: what separates each from everything else, as closed meshes of triangles
// (src/cli/manual/exports.md).
//
// Guarantees: exact, but for the positions, which are the nearest doubles. Each mesh is closed, and its triangles are
// counterclockwise, seen from outside. Two corners are one iff they are exactly equal.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"

namespace flowcert {

struct CellSurface {
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A cell is the stationary points whose stable sets make it (FC-POCK-03), by place in the list. Cells may be parts of
// others. Makes limits. The time and the memory are those of the facets of all cells S3. Throws InvalidInput for a
// coordinate beyond the doubles.
[[nodiscard]] std::vector<CellSurface> cell_surfaces(const FlowComplex& complex,
                                                     const std::vector<std::span<const std::uint32_t>>& cells);

// PLY, binary, little endian, with double coordinates. comment: one line.
void write_ply(std::ostream& out, const CellSurface& surface, const std::string& comment);

}  // namespace flowcert
