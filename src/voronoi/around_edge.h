// A walk around a Delaunay edge v0 v1, from cell to cell, counterclockwise seen from v1. Dimension 3 only.
//
// Guarantees: exact. It passes all cells that have the edge, infinite ones as well, and compares no vertices on its
// way. From each it leaves by the facet that has `apex`.
#pragma once

#include <algorithm>

#include "voronoi/voronoi_complex.h"

namespace flowcert::voronoi {

struct AroundEdge {
  CellIndex cell = kNoCell;
  // Where the cell has its samples: v0, v1, the one behind the facet by which it is left, and the apex.
  unsigned v0 = 0, v1 = 0, behind = 0, apex = 0;
};

// In a positively oriented cell v0 v1 k l it goes from the facet that has k to the one that has l. The cell must have
// the edge.
[[nodiscard]] inline AroundEdge around_edge(const CompactDelaunay& delaunay, FacetName edge, CellIndex start) {
  const auto& v = delaunay.vertices(start);
  const unsigned i0 = place_among(v, edge.v0), i1 = place_among(v, edge.v1);
  // v0 v1 k l is positive iff v0 v1 l is the outward order of the facet opposite k.
  unsigned k = 0, l = 0;
  for (k = 0; k < 4; ++k) {
    if (k == i0 || k == i1) continue;
    l = 6 - i0 - i1 - k;
    const auto& order = kOutward[k];
    const auto at = static_cast<unsigned>(std::find(order, order + 3, l) - order);
    if (order[(at + 1) % 3] == i0) break;
  }
  return {start, i0, i1, k, l};
}

// Prefetches the cell behind that one.
[[nodiscard]] inline AroundEdge next_around(const VoronoiComplex& complex, const AroundEdge& at) {
  const CompactDelaunay& delaunay = complex.delaunay();
  const CellIndex next = delaunay.neighbors(at.cell)[at.behind];
  const PlacesBeyond beyond = complex.places_beyond({at.cell, at.behind});
  const AroundEdge there{next, beyond[at.v0], beyond[at.v1], beyond[at.apex], beyond[at.behind]};
  __builtin_prefetch(&delaunay.cells[delaunay.neighbors(next)[there.behind]]);
  return there;
}

}  // namespace flowcert::voronoi
