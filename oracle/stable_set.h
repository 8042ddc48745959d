// The stable set of a stationary point, or of infinity: all that flows there, from the definitions alone (FC-STAB-01 to
// 05, 08).
//
// This builds the skeleton, which is the part of the set on Voronoi vertices, edges and facets. It is followed
// backwards. All pairs and triples of a point's contact set are tried to find what leads to it (FC-STAB-03). One scan
// over all points finds the end of each way back. stable_pieces.h says what the skeleton stands for. Exact, for any
// finite point set of any dimension.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/pieces.h"
#include "oracle/stationary_points.h"

namespace oracle {

// A point of the skeleton: what everything flows to, or a Voronoi vertex, or a point at which a backward segment meets
// a Voronoi edge. Contact sets are class names, ascending, here and below.
struct SkeletonPoint {
  Point position;
  std::vector<std::size_t> contact;

  friend auto operator<=>(const SkeletonPoint&, const SkeletonPoint&) = default;
};

// What a backward segment ends at. It may be the midpoint of its samples, which is critical of index 1 or regular
// stationary. Or it is a point of the skeleton on a Voronoi edge or at a Voronoi vertex.
enum class BackKind { kCritical, kRegular, kEdge, kVertex };

// FC-STAB-04.
struct BackwardSegment : Crossing {
  std::vector<std::size_t> front_contact;  // empty at infinity
  std::vector<std::size_t> back_contact;
  BackKind back_kind;

  friend auto operator<=>(const BackwardSegment&, const BackwardSegment&) = default;
};

// Each list is ascending. No two members of a list have the same position, samples and front, polygon and ends, or
// samples and corners. For infinity, pieces may be unbounded: the front of a segment or an interval, the greater end of
// what is crossed, and one corner of a sector or two that are neighbours.
struct StableSet {
  std::vector<SkeletonPoint> points;
  std::vector<BackwardSegment> segments;
  std::vector<EdgePart> intervals;  // FC-STAB-05: they flow along the edge, from z(f) or from a Voronoi vertex
  std::vector<EdgePart> crossed;    // other intervals that sectors begin at; the front is the lesser end
  std::vector<Region> sectors;      // FC-STAB-05: open
  bool has_vertex = false;          // one of the points is a Voronoi vertex

  friend bool operator==(const StableSet&, const StableSet&) = default;
};

// All that flows to y, a point on a Voronoi vertex, edge or facet, or a sample. For a sample, `points` has only this.
StableSet stable_set(const PointSet& set, const Point& y);
inline StableSet stable_set(const PointSet& set, const StationaryPoint& z) { return stable_set(set, z.center); }

// If P does not span space, the directions in which a facet is unbounded may be all of its plane, or half of it. Then
// they are cut into quarters of a circle, by rays from the midpoint: the list of segments has these rays.
StableSet stable_set_of_infinity(const PointSet& set);

}  // namespace oracle
