// A regular stationary point lies on the side at which one of its polygons has a right angle.
#include "morse/record_facet.h"

#include <algorithm>

#include "flow/drivers.h"
#include "geometry/contract.h"
#include "morse/record_face.h"

namespace flowcert::morse {

FacetName facet_of_record(const VoronoiDiagram& diagram, const PointSet& points, std::span<const VertexIndex> vertex_of,
                          const StationaryPoints& stationary, std::size_t record) {
  const StationaryIndex index = stationary.index(record);
  FLOWCERT_REQUIRES(index.face_dimension == 1);
  if (index.is_critical()) {
    const auto contact = stationary.contact(record);
    const auto vertex = [&](PointId name) { return vertex_of[points.ordinal_of_row(name)]; };
    return facet_name(vertex(contact[0]), vertex(contact[1]));
  }
  const PolygonRef polygon = index.hull_dimension == 2
                                 ? edge_of_record(stationary, record)
                                 : polygons_through(diagram, cell_of_record(stationary, record)).front();
  const PolygonSides sides = diagram.sides(polygon);
  const auto side = std::ranges::find(sides, Sign::kZero, &PolygonSide::angle);
  return {side->v0, side->v1};
}

}  // namespace flowcert::morse
