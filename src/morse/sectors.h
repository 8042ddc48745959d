// The parts of dimension 3 of a stable set: what flows into an arc of a Voronoi edge, facet by facet (spec
// clause FC-STAB-05).
//
// Guarantees: exact, in rationals throughout; no filter: such parts come from ties alone, and are few.
#pragma once

#include <vector>

#include "flow/flow_machine.h"
#include "morse/layer.h"

namespace flowcert::morse {

// An open arc of a Voronoi edge.
struct Arc {
  PolygonRef polygon;
  RationalPoint a, b;
};

struct SectorParts {
  // Of the sector's closure, in cyclic order: the lexicographically least first, the lesser of its neighbours
  // second.
  std::vector<RationalPoint> corners;
  // What the sector's rays come through, where they enter the facet.
  std::vector<Arc> arcs;
  std::vector<CellIndex> vertices;
};

// The sector in a facet that leads to the arc (h > 0 at the arc's polygon).
[[nodiscard]] SectorParts sector_of(VoronoiFaces& faces, FlowMachine& machine, FacetName facet,
                                    const Arc& arc);

}  // namespace flowcert::morse
