// Cycles as data sets for viewers (src/cli/manual/cycles.md): loops as closed lines, their surfaces as triangles, voids
// as cells and as closed surfaces.
//
// Guarantees: coordinates and values are the doubles nearest to the exact ones, and a value beyond the doubles throws
// InvalidInput. Of each pair, the boundary of the surface's triangles is the loop's edges, mod 2, and a void's surface
// is closed. The array `pair` has the places of cycles in their list; births, deaths and levels are squared.
#pragma once

#include <cstddef>
#include <vector>

#include "flowcert/surface.h"
#include "io/cell_surfaces.h"
#include "io/cycles.h"
#include "io/vtk_exports.h"

namespace flowcert {

// All cycles are of dimension 1. One line for each polygon; the first point comes again at its end. The point array
// `sample` has the row of each point.
[[nodiscard]] PolyData loop_data(const FlowComplex& complex, const std::vector<Cycle>& cycles);
// All cycles are of dimension 1. Surfaces of several pairs have no points in common. The point array `sample` is -1
// where a point is none. The cell array `saddle` has the index-2 points, by place in the list.
[[nodiscard]] PolyData loop_surface_data(const FlowComplex& complex, const std::vector<Cycle>& cycles);

// All cycles are of dimension 2. What is in several voids comes once for each. Makes limits and volumes.
[[nodiscard]] UnstructuredGrid void_data(const FlowComplex& complex, const std::vector<Cycle>& cycles);
// One for each. Makes limits.
[[nodiscard]] std::vector<CellSurface> void_surfaces(const FlowComplex& complex, const std::vector<Cycle>& cycles);

}  // namespace flowcert
