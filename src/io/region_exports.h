// The regions of Voronoi facets as data sets for viewers: stable sets of dimension 3 as cells, and what the
// directions of index-1 points meet in their own facets (src/cli/manual/exports.md).
//
// Guarantees: coordinates and volumes are the doubles nearest to the exact ones, and a value beyond the doubles throws
// InvalidInput. Points are one iff their exact positions are equal. Cells have VTK's orientation, by exact positions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "io/clip_box.h"
#include "io/vtk_exports.h"

namespace flowcert {

// Makes limits and volumes.
[[nodiscard]] UnstructuredGrid stable_cell_data(const FlowComplex& complex);
// Cells of pockets or voids (FC-POCK-03), with the arrays `maximum`, where each pyramid flows to, and `sample`. What is
// in several cells comes once for each of them.
struct CellGrid {
  UnstructuredGrid grid;
  std::vector<std::int64_t> limits, numbers;  // of each pyramid: where it flows to, and which cell it is of
};
// Makes limits.
[[nodiscard]] CellGrid cell_grid(const FlowComplex& complex, const std::vector<std::span<const std::uint32_t>>& cells);
// An array that has a value for each of these numbers.
[[nodiscard]] VtpArray array_by_number(const std::string& name, const std::vector<std::int64_t>& numbers,
                                       const std::vector<double>& value_of);
// The cells of pockets, each with the number of its pocket, that pocket's volume, and its depth in squared distances.
// Makes limits and volumes.
[[nodiscard]] UnstructuredGrid pocket_cell_data(const FlowComplex& complex, const Pockets& pockets);
// The stable set of infinity in the box; without a box, those of its cells that are bounded. Points where the box cuts
// are one iff their doubles are equal. No cells if the points do not span space. Makes limits.
[[nodiscard]] UnstructuredGrid infinity_cell_data(const FlowComplex& complex, const std::optional<ClipBox>& box);
// Makes limits. Regions that reach to infinity are left out.
[[nodiscard]] PolyData unstable_fan_data(const FlowComplex& complex);

}  // namespace flowcert
