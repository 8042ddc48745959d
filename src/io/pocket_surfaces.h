// The surfaces of pockets: what separates the cell of each from everything else, as closed meshes of triangles
// (src/cli/manual/exports.md).
//
// Guarantees: exact, but for the positions, which are the nearest doubles. Each mesh is closed, and its triangles are
// counterclockwise, seen from outside. Two corners are one iff they are exactly equal.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"

namespace flowcert {

struct PocketSurface {
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// One for each pocket, in their order. Makes limits. The time and the memory are those of the facets of all cells.
// Throws InvalidInput for a coordinate beyond the doubles.
[[nodiscard]] std::vector<PocketSurface> pocket_surfaces(const FlowComplex& complex, const Pockets& pockets);

// PLY, binary, little endian, with double coordinates. comment: one line.
void write_ply(std::ostream& out, const PocketSurface& surface, const std::string& comment);

}  // namespace flowcert
