// The unstable set W^u(y) of a stationary point y with dim F = 1, as a set (FC-UNST-04 to 06), from the definitions.
//
// The set lies on closed Voronoi facets. It is given by its parts: Voronoi vertices, intervals of Voronoi edges, and
// parts of Voronoi facets. No part counts twice, also if several families of rays cover it. All rays are followed
// forward from y, by scans over all points. Exact, for any finite point set of any dimension.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "oracle/corners.h"
#include "oracle/stationary_points.h"

namespace oracle {

// A part of a Voronoi edge. The lesser end comes first.
struct EdgePart {
  std::vector<std::size_t> polygon;  // the contact set of the Voronoi edge
  Corner from, to;

  friend bool operator==(const EdgePart&, const EdgePart&) = default;
  friend bool operator<(const EdgePart& a, const EdgePart& b) {
    return std::tie(a.polygon, a.from, a.to) < std::tie(b.polygon, b.from, b.to);
  }
};

// A part of dimension 2 of the Voronoi facet of two samples: what lies in the facet of the convex region with these
// corners, sides included. The order of the corners is that of a Sector. If P does not span space, there are no
// corners, and the sheet is all of the facet.
struct UnstableSheet {
  std::array<std::size_t, 2> samples;
  std::vector<Corner> corners;

  friend bool operator==(const UnstableSheet&, const UnstableSheet&) = default;
  friend bool operator<(const UnstableSheet& a, const UnstableSheet& b) {
    return std::tie(a.samples, a.corners) < std::tie(b.samples, b.corners);
  }
};

// The open segment in which a single ray crosses the Voronoi facet of two samples.
struct UnstableSegment {
  std::array<std::size_t, 2> samples;
  Point start;
  Corner end;

  friend bool operator==(const UnstableSegment&, const UnstableSegment&) = default;
  friend bool operator<(const UnstableSegment& a, const UnstableSegment& b) {
    return std::tie(a.samples, a.start) < std::tie(b.samples, b.start);
  }
};

// Each list is ascending.
struct UnstableSurface {
  std::vector<Point> vertices;   // Voronoi vertices
  std::vector<EdgePart> traces;  // with those of their ends that are on the edge; from == to for a point
  std::vector<EdgePart> runs;    // without their ends
  std::vector<UnstableSheet> sheets;
  std::vector<UnstableSegment> segments;

  friend bool operator==(const UnstableSurface&, const UnstableSurface&) = default;
};

// Throws std::invalid_argument if dim F is not 1, and std::logic_error if the set is not closed, which is a theorem.
UnstableSurface unstable_surface(const PointSet& set, const StationaryPoint& y);

// Whether x is in W^u(y), from the parts alone.
bool contains(const PointSet& set, const UnstableSurface& surface, const Point& x);

}  // namespace oracle
