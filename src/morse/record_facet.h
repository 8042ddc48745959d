// The samples of a stationary point with a face of dimension 1: its midpoint is theirs (FC-UNST-01).
//
// Guarantees: exact.
#pragma once

#include <span>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::morse {

// vertex_of has the vertex of each ordinal in the point set. The time is in proportion to the samples of its contact
// set, or to the facets of its cluster.
[[nodiscard]] FacetName facet_of_record(const VoronoiDiagram& diagram, const PointSet& points,
                                        std::span<const VertexIndex> vertex_of, const StationaryPoints& stationary,
                                        std::size_t record);

}  // namespace flowcert::morse
