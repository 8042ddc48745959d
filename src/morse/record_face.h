// The Voronoi face in which a stationary point lies, as one number: its place in the triangulation.
//
// Guarantees: the number of a Voronoi edge is its packed PolygonRef, and that of a Voronoi vertex its packed cluster.
// The number of an index-1 point is that of a finite cell with its Delaunay edge. Index 0 has none.
#pragma once

#include <cstddef>
#include <cstdint>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::morse {

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

}  // namespace flowcert::morse
