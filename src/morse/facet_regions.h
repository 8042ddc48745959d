// The regions of one Voronoi facet, as corners of the diagram's faces.
//
// Guarantees: exact, by the division of the facet's edges alone. Nothing is constructed.
#pragma once

#include <vector>

#include "morse/limit_partition.h"
#include "morse/stable_regions.h"

namespace flowcert::morse {

struct FacetRegion {
  Limit limit;
  std::vector<RegionCorner> corners;  // counterclockwise seen from v1
};

// The regions of the facet of a ring, counterclockwise.
[[nodiscard]] std::vector<FacetRegion> regions_of(const VoronoiDiagram& diagram, const LimitPartition& partition,
                                                  const FacetRing& ring);

}  // namespace flowcert::morse
