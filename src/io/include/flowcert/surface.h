// Stable manifolds S2 as one surface: their triangles with shared vertices, and the files. Which of them is asked of
// surface_selection.h.
//
// Guarantees: two triangles share a vertex iff the exact positions are equal, whatever the doubles. Coordinates are
// the doubles nearest to the exact ones. Each backward segment gives two triangles (spec clause FC-STAB-04); parts of
// dimension 3 give none. Triangles have one orientation where they can (triangle_orientation.h); a surface of several
// S2 is no manifold in general.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/progress.h"
#include "flowcert/surface_selection.h"
#include "flowcert/triangle_orientation.h"

namespace flowcert {

struct SurfaceMesh {
  std::vector<Point> vertices;
  // From each vertex to its nearest samples. A value beyond the doubles is left out.
  std::vector<std::optional<double>> squared_distances;
  std::vector<Triangle> triangles;
  std::vector<std::size_t> set_of_triangle;  // its number in StableManifolds
  TriangleEdges edges;
};

// sets: critical points of index 2, by their numbers in StableManifolds, each once. The stable sets are computed once
// more. Throws InvalidInput for a coordinate beyond the doubles.
[[nodiscard]] SurfaceMesh surface_mesh(const FlowComplex& complex, std::span<const std::size_t> sets,
                                       const Progress& progress = {});

// PLY (binary, little endian, double coordinates) and OFF (text). Coordinates read back to the same doubles;
// triangles keep their order. comment: one line.
void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);
void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);

}  // namespace flowcert
