// The Delaunay neighbours of each sample, side by side in memory.
//
// Guarantees: exact. Dimension 3 only. Cospherical samples may be neighbours by one triangulation and not by another.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "morse/layer.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::morse {

// A Delaunay neighbour, and a cell that has both samples.
struct Neighbor {
  VertexIndex vertex;
  CellIndex cell;
};

// The Delaunay neighbours of each sample, side by side.
class Neighborhoods {
 public:
  explicit Neighborhoods(const VoronoiDiagram& diagram) : first_(diagram.delaunay().points.size() + 1, 0) {
    struct Ordered {
      VertexIndex from;
      Neighbor to;
    };
    std::vector<Ordered> all;
    const CompactDelaunay& delaunay = diagram.delaunay();
    for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
      for (const VertexIndex v : delaunay.vertices(cell)) {
        for (const VertexIndex w : delaunay.vertices(cell)) {
          if (v != w) all.push_back({v, {w, cell}});
        }
      }
    }
    const auto key = [](const Ordered& one) { return std::pair(one.from, one.to.vertex); };
    std::ranges::sort(all, {}, key);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > 0 && key(all[i - 1]) == key(all[i])) continue;
      ++first_[all[i].from + 1];
      neighbors_.push_back(all[i].to);
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  }

  [[nodiscard]] std::span<const Neighbor> of(VertexIndex v) const {
    return std::span(neighbors_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Neighbor> neighbors_;
};

}  // namespace flowcert::morse
