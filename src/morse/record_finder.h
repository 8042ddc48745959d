// Finds stationary points in the list: by index or kind and contact set, or, for index 1, by the two samples. And
// finds where in the diagram a stationary point of the list lies.
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
#include "voronoi/voronoi_diagram.h"

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
  // O(index-1 points + vertices).
  GabrielEdges(const VoronoiDiagram& diagram, const StationaryPoints& stationary);

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

// ---- Faces ----

// The Voronoi face in which a stationary point lies, as one number: its place in the triangulation. That of a Voronoi
// edge is its packed PolygonRef, and that of a Voronoi vertex its packed cluster. The number of an index-1 point is
// that of a finite cell with its Delaunay edge. Index 0 has none.
[[nodiscard]] inline std::uint32_t face_number(FacetRef facet) { return facet.packed(); }
[[nodiscard]] inline std::uint32_t face_number(CellIndex cell) { return FacetRef{cell, 0}.packed(); }

[[nodiscard]] inline PolygonRef edge_of_record(const StationaryPoints& list, std::size_t record) {
  return PolygonRef::unpacked(list.face(record));
}
[[nodiscard]] inline CellIndex cell_of_record(const StationaryPoints& list, std::size_t record) {
  return edge_of_record(list, record).cell;
}

// For index 2 and 3 and all kinds.
[[nodiscard]] inline Place place_of_record(const StationaryPoints& list, std::size_t record) {
  return list.index(record).hull_dimension == 3 ? Place::at_vertex(cell_of_record(list, record))
                                                : Place::on_edge(edge_of_record(list, record));
}

// The samples of a stationary point with a face of dimension 1: its midpoint is theirs (FC-UNST-01). The time is in
// proportion to the samples of its contact set, or to the facets of its cluster.
[[nodiscard]] FacetName facet_of_record(const VoronoiDiagram& diagram, const StationaryPoints& list,
                                        std::size_t record);

}  // namespace flowcert::morse
