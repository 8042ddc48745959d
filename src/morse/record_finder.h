// Finds stationary points in the list: by index or kind and contact set, or, for index 1, by the two samples.
//
// Guarantees: exact, for a list in the order of spec clause FC-OUT-02.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::morse {

// Each question takes a binary search.
class RecordFinder {
 public:
  // The list must outlive this.
  explicit RecordFinder(const StationaryPoints& list) : list_(list) {}

  // The records of one index or kind: first, and one beyond the last.
  [[nodiscard]] std::pair<std::size_t, std::size_t> range(StationaryIndex index) const;
  // contact: names, ascending.
  [[nodiscard]] std::optional<std::size_t> find(StationaryIndex index, std::span<const PointId> contact) const;

 private:
  const StationaryPoints& list_;
};

// The critical points of index 1. A question looks at the Gabriel edges of one sample, the one with the lower number;
// they lie side by side in memory.
class GabrielEdges {
 public:
  // vertex_of has the vertex of each ordinal in the point set. O(index-1 points + vertices).
  GabrielEdges(const PointSet& points, const StationaryPoints& stationary, std::span<const VertexIndex> vertex_of);

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
