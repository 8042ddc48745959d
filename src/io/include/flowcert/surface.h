// Stable manifolds S2 as one surface: which of them, their triangles with shared vertices, and the files.
//
// Guarantees: two triangles share a vertex iff the exact positions are equal, whatever the doubles. Coordinates are
// the doubles nearest to the exact ones. Each backward segment gives two triangles (spec clause FC-STAB-04); parts of
// dimension 3 give none. Neighbours have one orientation where that is possible; a surface of several S2 is no
// manifold in general.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/progress.h"

namespace flowcert {

// The critical points of index 2 that make a surface, by number in StableManifolds, ascending. All conditions have to
// hold (src/cli/manual/surfaces.md): "index2-radius<R" (its distance, not squared), "persistence>X" (the length of the
// pair that it is in, a difference of distances), "largest-gaps=N" (the N most persistent ones; of equal ones the first
// in the list). R and X may also be "3spacing" (a multiple of the samples' spacing), "q0.9" (a quantile of all) or
// "auto" (the valley of their histogram). Decided exactly. Throws InvalidInput for anything else. Conditions on
// persistence make the whole complex.
[[nodiscard]] std::vector<std::size_t> selected_sets(const FlowComplex& complex,
                                                     const std::vector<std::string>& conditions);

using Triangle = std::array<std::uint32_t, 3>;  // of numbers of vertices

// An edge of exactly two triangles is manifold. Manifold edges join triangles to components.
struct TriangleEdges {
  std::size_t boundary = 0;             // edges of one triangle
  std::size_t manifold = 0;             // of two
  std::size_t non_manifold = 0;         // of more
  std::size_t components = 0;           // of triangles
  std::size_t without_orientation = 0;  // of these components, those that have none
};

struct SurfaceMesh {
  std::vector<Point> vertices;
  // From each vertex to its nearest samples. A value beyond the doubles is left out.
  std::vector<std::optional<double>> squared_distances;
  std::vector<std::optional<PointId>> samples;  // the vertices that are samples, by name
  std::vector<Triangle> triangles;
  std::vector<std::size_t> set_of_triangle;  // its number in StableManifolds
  TriangleEdges edges;
};

// sets: critical points of index 2, by their numbers in StableManifolds, each once. The stable sets are computed once
// more. Throws InvalidInput for a coordinate beyond the doubles.
[[nodiscard]] SurfaceMesh surface_mesh(const FlowComplex& complex, std::span<const std::size_t> sets,
                                       const Progress& progress = {});

// The surface of a loop (loops.h), which are index-2 points by place in the list. Mod 2, the boundary of its triangles
// is the edges of the loop: below a tie it has the paths alone that the chain's boundary takes (FC-CHAIN-02). Throws
// InvalidInput for a coordinate beyond the doubles.
[[nodiscard]] SurfaceMesh loop_surface_mesh(const FlowComplex& complex, std::span<const std::uint32_t> surface);

// PLY (binary, little endian, double coordinates) and OFF (text). Coordinates read back to the same doubles;
// triangles keep their order. comment: one line.
void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);
void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);

}  // namespace flowcert
