// The critical points of index 1, found by their two samples.
//
// Guarantees: a question looks at the Gabriel edges of one sample, that with the lower number; they lie side
// by side in memory.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::morse {

class GabrielEdges {
 public:
  // vertex_of: of the positions in the point set. O(index-1 points + vertices).
  GabrielEdges(const PointSet& points, const StationaryPoints& stationary,
               std::span<const VertexIndex> vertex_of);

  // Where the midpoint is in the list; nothing where it is not critical.
  [[nodiscard]] std::optional<std::uint32_t> find(FacetName edge) const {
    for (std::size_t k = first_[edge.v0]; k < first_[edge.v0 + 1]; ++k) {
      if (edges_[k].other == edge.v1) return edges_[k].record;
    }
    return std::nullopt;
  }

 private:
  struct Edge {
    VertexIndex other;
    std::uint32_t record;
  };
  std::vector<std::size_t> first_;
  std::vector<Edge> edges_;
};

}  // namespace flowcert::morse
