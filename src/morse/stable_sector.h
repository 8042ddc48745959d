// Parts of stable sets of dimension 3: what flows into an arc of a Voronoi edge, facet by facet (spec clause
// FC-STAB-05).
//
// Guarantees: exact. The signs are the flow operator's, with its filters; no point is constructed but those that it
// asks for.
#pragma once

#include <vector>

#include "morse/backward_walk.h"

namespace flowcert::morse {

// An open arc of a Voronoi edge, from a to b, in the sense from end 0 to end 1. A front may be at infinity.
struct Arc {
  PolygonRef polygon;
  FrontNumber a, b;
};

// The part of a facet between the rays from its midpoint to two directions, or to the ends of an arc.
struct SectorParts {
  // The corners of the sector's closure in cyclic order. If the facet contains its midpoint, that is one more. Two
  // neighbours may be at one place.
  std::vector<FrontNumber> corners;
  bool has_midpoint = false;
  // The sector's rays enter the facet through these.
  std::vector<Arc> arcs;
  std::vector<CellIndex> vertices;
};

// The sector in a facet that leads to the arc (h > 0 at the arc's polygon).
[[nodiscard]] SectorParts sector_of(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, const Arc& arc);
// The sector in a facet between two fronts at infinity, from a to b counterclockwise seen from v1.
[[nodiscard]] SectorParts sector_at_infinity(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, FrontNumber a,
                                             FrontNumber b, CellIndex hint);

}  // namespace flowcert::morse
