// Parts of stable sets of dimension 3: what flows into an arc of a Voronoi edge, facet by facet (spec clause
// FC-STAB-05).
//
// Guarantees: exact, in rationals throughout, and not by the operator's kernel, because such parts come from ties alone
// and are few.
#pragma once

#include <vector>

#include "flow/flow_operator.h"
#include "morse/layer.h"

namespace flowcert::morse {

// An open arc of a Voronoi edge.
struct Arc {
  PolygonRef polygon;
  RationalPoint a, b;
};

struct SectorParts {
  // The corners of the sector's closure in cyclic order. The lexicographically least is first, the lesser of its
  // neighbours second.
  std::vector<RationalPoint> corners;
  // The sector's rays enter the facet through these.
  std::vector<Arc> arcs;
  std::vector<CellIndex> vertices;
};

// The sector in a facet that leads to the arc (h > 0 at the arc's polygon).
[[nodiscard]] SectorParts sector_of(VoronoiFaces& faces, FlowOperator& flow, FacetName facet, const Arc& arc);

}  // namespace flowcert::morse
