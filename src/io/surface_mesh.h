// The triangles of stable manifolds S2, as one mesh with shared vertices.
//
// Guarantees: vertices are one iff their exact positions are equal, whatever their doubles; coordinates are
// the doubles nearest to the exact ones. Two triangles for each backward segment (spec clause FC-STAB-04),
// none for parts of dimension 3. Triangles have no common orientation: surfaces of several S2 are no
// manifold in general.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "io/layer.h"

namespace flowcert::io {

struct SurfaceMesh {
  std::vector<Point> vertices;
  // Of each vertex, to the samples nearest to it; none beyond the doubles.
  std::vector<std::optional<double>> squared_distances;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> set_of_triangle;  // its number in StableManifolds
};

// sets: critical points of index 2, by their numbers in StableManifolds, each once. Throws InvalidInput for a
// coordinate beyond the doubles. Flows once more.
[[nodiscard]] SurfaceMesh surface_mesh(const PointSet& points, StableManifolds& s2,
                                       std::span<const std::size_t> sets,
                                       const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace flowcert::io
