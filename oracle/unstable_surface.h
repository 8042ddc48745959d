// The unstable set W^u(y) of a stationary point y with dim F = 1, as a set (FC-UNST-04 to 06), from the definitions.
//
// The set lies on closed Voronoi facets. It is given by its parts: Voronoi vertices, intervals of Voronoi edges, and
// parts of Voronoi facets. No part counts twice, also if several families of rays cover it. All rays are followed
// forward from y, by scans over all points. Exact, for any finite point set of any dimension.
#pragma once

#include <vector>

#include "oracle/pieces.h"
#include "oracle/stationary_points.h"

namespace oracle {

// Each list is ascending, but that of segments, which is ordered by samples and back. In parts of edges, the front is
// the lesser end.
struct UnstableSurface {
  std::vector<Point> vertices;     // Voronoi vertices
  std::vector<EdgePart> traces;    // with those of their ends that are on the edge; front == back for a point
  std::vector<EdgePart> runs;      // without their ends
  std::vector<Region> sheets;      // with their sides; without corners, if P does not span space: all of the facet
  std::vector<Crossing> segments;  // in which single rays cross a facet

  friend bool operator==(const UnstableSurface&, const UnstableSurface&) = default;
};

// Throws std::invalid_argument if dim F is not 1, and std::logic_error if the set is not closed, which is a theorem.
UnstableSurface unstable_surface(const PointSet& set, const StationaryPoint& y);

// Whether x is in W^u(y), from the parts alone.
bool contains(const PointSet& set, const UnstableSurface& surface, const Point& x);

}  // namespace oracle
