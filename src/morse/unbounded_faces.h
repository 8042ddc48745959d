// What comes from infinity: where the skeleton of what flows there begins (spec clause FC-STAB-08).
//
// Guarantees: exact, in every dimension. Directions are exact vectors, scaled so that their largest coordinate is 1 or
// -1. So two of them are equal iff they point the same way. Signs of the diagram tell which of them lead to infinity.
#pragma once

#include <vector>

#include "flowcert/rational.h"
#include "morse/layer.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::morse {

// The unbounded end 0 or 1 of a Voronoi edge. Its polygon contains its centre, and leads to infinity along the edge.
struct UnboundedEdge {
  PolygonRef polygon;
  std::size_t end;
};

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
  std::vector<UnboundedEdge> edges;
  std::vector<UnboundedFacet> facets;
};

// The time is in proportion to the diagram's cells, and to the facets of the unbounded Voronoi edges.
[[nodiscard]] UnboundedFaces unbounded_faces(VoronoiFaces& faces);

// Where the unbounded end 0 or 1 of a Voronoi edge lies.
[[nodiscard]] RationalPoint direction_of_end(const Diagram& diagram, PolygonRef polygon, std::size_t end);

// The direction of an element of a ring that is none of a Voronoi vertex. Such an element ends a Voronoi edge.
[[nodiscard]] RationalPoint direction_of_element(const Diagram& diagram, const FacetRing& ring, std::size_t element);

}  // namespace flowcert::morse
