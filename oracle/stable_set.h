// The stable set of a stationary point z: all that flows to z, from the definitions alone (FC-STAB-01 to 05).
//
// This builds the skeleton, which is the part of the set on Voronoi vertices, edges and facets. It is followed
// backwards from z. All pairs and triples of a point's contact set are tried to find what leads to it (FC-STAB-03).
// One scan over all points finds the end of each way back. stable_pieces.h says what the skeleton stands for. Exact,
// for any finite point set of any dimension.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// A point of the skeleton: z, or a Voronoi vertex, or a point at which a backward segment meets a Voronoi edge.
// Contact sets are class names, ascending, here and below.
struct SkeletonPoint {
  Point position;
  std::vector<std::size_t> contact;

  friend bool operator==(const SkeletonPoint&, const SkeletonPoint&) = default;
  friend bool operator<(const SkeletonPoint& a, const SkeletonPoint& b) { return a.position < b.position; }
};

// What a backward segment ends at. It may be the midpoint of its samples, which is critical of index 1 or regular
// stationary. Or it is a point of the skeleton on a Voronoi edge or at a Voronoi vertex.
enum class BackKind { kCritical, kRegular, kEdge, kVertex };

// FC-STAB-04: the open segment between `front` and `back`. It flows to `front`.
struct BackwardSegment {
  std::array<std::size_t, 2> samples;  // of the Voronoi facet that it crosses, ascending
  Point front;
  Point back;
  std::vector<std::size_t> front_contact;
  std::vector<std::size_t> back_contact;
  BackKind back_kind;

  friend bool operator==(const BackwardSegment&, const BackwardSegment&) = default;
  friend bool operator<(const BackwardSegment& a, const BackwardSegment& b) {
    return std::tie(a.samples, a.front) < std::tie(b.samples, b.front);
  }
};

// How an open interval of a Voronoi edge flows to z (FC-STAB-05). In the first two cases it flows along the edge to
// the Voronoi vertex at `front`. It comes from `back`, which is z(f) or the edge's other Voronoi vertex. In the third
// case it flows away from the edge, through the Voronoi facet of the side at which its polygon is obtuse. Rays of a
// sector cross it. Then `front` is the end with the lesser coordinates.
enum class IntervalKind { kFromCentre, kFromVertex, kCrossed };

struct BackwardInterval {
  std::vector<std::size_t> polygon;  // the contact set of the Voronoi edge
  Point front;
  Point back;
  IntervalKind kind;

  friend bool operator==(const BackwardInterval&, const BackwardInterval&) = default;
  friend bool operator<(const BackwardInterval& a, const BackwardInterval& b) {
    return std::tie(a.polygon, a.front, a.back) < std::tie(b.polygon, b.front, b.back);
  }
};

// FC-STAB-05: the interior of `polygon`, which lies in the Voronoi facet of `samples`. The corners of the closure are
// in cyclic order, from the least corner towards the lesser of its neighbours.
struct Sector {
  std::array<std::size_t, 2> samples;
  std::vector<Point> polygon;

  friend bool operator==(const Sector&, const Sector&) = default;
  friend bool operator<(const Sector& a, const Sector& b) {
    return std::tie(a.samples, a.polygon) < std::tie(b.samples, b.polygon);
  }
};

// Each list is ascending: by position, by samples and front, by polygon and ends, by samples and corners. No two
// members of a list are equal in these values.
struct StableSet {
  std::vector<SkeletonPoint> points;
  std::vector<BackwardSegment> segments;
  std::vector<BackwardInterval> intervals;
  std::vector<Sector> sectors;
  bool has_vertex = false;  // one of the points is a Voronoi vertex

  friend bool operator==(const StableSet&, const StableSet&) = default;
};

// For every stationary z. If the index is 0 or 1, `points` has only z.
StableSet stable_set(const PointSet& set, const StationaryPoint& z);

}  // namespace oracle
