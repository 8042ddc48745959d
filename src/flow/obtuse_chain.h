// The Voronoi edges of a facet through which the flow enters it: those whose polygon is obtuse at the facet's
// Delaunay edge.
//
// Guarantees: exact. Seen from the facet's midpoint m, which they separate from the facet, they are its near
// side: they follow one another in its ring, and rays from m meet them in clockwise order, seen from v1. None
// are obtuse iff m lies in the closed facet; then those at right angles pass through m: one inside which it
// lies, or two that meet in it (spec clause FC-SIGN-04).
#pragma once

#include <cstddef>
#include <cstdint>

#include "flow/layer.h"
#include "flowcert/filter_tally.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::flow {

struct ObtuseChain {
  std::uint32_t first = 0, count = 0;  // of the ring's pieces
  // Where none is obtuse: of the pieces at right angles, the last one in the ring's order, and how many.
  std::uint32_t right = 0, right_count = 0;
};

// O(n) for n pieces.
[[nodiscard]] ObtuseChain obtuse_chain(const VoronoiFaces& faces, FacetName facet, const FacetRing& ring,
                                       FilterTally& tally);

}  // namespace flowcert::flow
