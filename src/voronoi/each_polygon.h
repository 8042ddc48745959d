// All Voronoi edges of a diagram, one after the other.
//
// Guarantees: each polygon is visited once, by the facet that names it, in the order of cells. Inputs of dimension 1
// and less have none.
#pragma once

#include <cstdint>

#include "voronoi/voronoi_diagram.h"

namespace flowcert::voronoi {

// Calls use(polygon).
template <class Use>
void for_each_polygon(const VoronoiDiagram& diagram, const Use& use) {
  if (diagram.dimension() < 2) return;
  const VoronoiComplex* spatial = diagram.spatial();
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) {
    for (std::uint32_t i = spatial != nullptr ? 0 : 3; i < 4; ++i) {
      const FacetRef facet{cell, i};
      if (spatial != nullptr && spatial->role(facet) == VoronoiComplex::FacetRole::kInterior) continue;
      if (diagram.polygon(facet) == facet) use(PolygonRef(facet));
    }
  }
}

}  // namespace flowcert::voronoi
