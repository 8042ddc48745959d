// What comes from infinity: where the skeleton of what flows there begins (spec clause FC-STAB-08).
//
// Guarantees: exact, in every dimension. Directions are exact vectors, scaled so that their largest coordinate is 1 or
// -1. So two of them are equal iff they point the same way. Signs of the diagram decide which of them lead to infinity.
#pragma once

#include <vector>

#include "flowcert/rational.h"
#include "morse/facet_sides.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::morse {

// Directions in which the edge of a facet leads to infinity.
struct UnboundedFacet {
  FacetName facet;
  CellIndex hint;                   // a cell that may have the facet's edge
  std::vector<RationalPoint> rays;  // single directions
  // Open arcs, shorter than a half circle: all directions from the first to the second one, counterclockwise seen from
  // v1. They cut what is a half circle or more, and the rays between them are in `rays`.
  std::vector<std::array<RationalPoint, 2>> arcs;
};

struct UnboundedFaces {
  // Ends at infinity. Their polygons contain their centres, and lead to infinity along their edges.
  std::vector<EdgeEnd> edges;
  std::vector<UnboundedFacet> facets;
};

// The time is in proportion to the diagram's cells, and to the facets of the unbounded Voronoi edges.
[[nodiscard]] UnboundedFaces unbounded_faces(VoronoiFaces& faces);

// Where an end at infinity lies.
[[nodiscard]] RationalPoint direction_of(const VoronoiDiagram& diagram, const EdgeEnd& at);

}  // namespace flowcert::morse
