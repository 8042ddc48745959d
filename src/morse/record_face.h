// The Voronoi face in which a stationary point lies, as one number: its place in the triangulation.
//
// Guarantees: the number of a Voronoi edge tells its PolygonRef, that of a Voronoi vertex its cluster. The number of
// an index-1 point tells a finite cell that has its Delaunay edge. Index 0 has none.
#pragma once

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"
#include "voronoi/diagram.h"

namespace flowcert::morse {

// A cell's number has 30 bits (CompactDelaunay), and that of its facet two.
[[nodiscard]] inline std::uint32_t face_number(FacetRef facet) { return 4 * facet.cell + facet.index; }
[[nodiscard]] inline std::uint32_t face_number(CellIndex cell) { return 4 * cell; }

[[nodiscard]] inline PolygonRef edge_of_record(const StationaryPoints& list, std::size_t record) {
  return {list.face(record) / 4, list.face(record) % 4};
}
[[nodiscard]] inline CellIndex cell_of_record(const StationaryPoints& list, std::size_t record) {
  return list.face(record) / 4;
}

// For index 2 and 3 and all kinds.
[[nodiscard]] inline Place place_of_record(const StationaryPoints& list, std::size_t record) {
  return list.index(record).hull_dimension == 3 ? Place::at_vertex(cell_of_record(list, record))
                                                : Place::on_edge(edge_of_record(list, record));
}

// The numbers 0 to count - 1 in the order in which the faces of their records lie in space. Neighbours then share what
// is in the cache. record_of(i) is a place in the list.
template <class RecordOf>
[[nodiscard]] std::vector<std::uint32_t> along_the_curve(const StationaryPoints& list, std::size_t count,
                                                         const RecordOf& record_of) {
  // The key comes first, and then the number.
  std::vector<std::uint64_t> keyed(count);
  for (std::size_t i = 0; i < count; ++i) {
    keyed[i] = std::uint64_t{list.face(record_of(static_cast<std::uint32_t>(i)))} << 32 | i;
  }
  boost::sort::spreadsort::integer_sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(keyed[i]);
  return order;
}

}  // namespace flowcert::morse
