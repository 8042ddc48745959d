// The stable set of a stationary point z: all that flows to z, from the definitions alone (FC-STAB-01 to 05).
//
// What is built is the skeleton, the part of it on Voronoi vertices, edges and facets, followed backwards
// from z: each point is asked what leads to it (FC-STAB-03), by trying all pairs and triples of its contact
// set, and each way back is cut off by one scan over all points. stable_pieces.h says what the skeleton
// stands for. Exact, for any finite point set and any dimension of it.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// A point of the skeleton that is z, or a Voronoi vertex, or one at which a backward segment meets a Voronoi
// edge. Contact sets are class names, ascending, here and below.
struct SkeletonPoint {
  Point position;
  std::vector<std::size_t> contact;

  friend bool operator==(const SkeletonPoint&, const SkeletonPoint&) = default;
  friend bool operator<(const SkeletonPoint& a, const SkeletonPoint& b) { return a.position < b.position; }
};

// What a backward segment ends at: the midpoint of its samples, critical of index 1 or regular stationary, or
// a point of the skeleton on a Voronoi edge or at a Voronoi vertex.
enum class BackKind { kCritical, kRegular, kEdge, kVertex };

// FC-STAB-04: the open segment from `front`, to which it flows, to `back`.
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

// How an open interval of a Voronoi edge flows to z: along the edge, from z(f) or from the edge's other
// Voronoi vertex at `back` to the Voronoi vertex at `front` (FC-STAB-05); or away from the edge, through the
// facet of the side at which its polygon is obtuse. Then it is one of those through which the rays of a
// sector leave, and `front` is the end with the lesser coordinates.
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

// FC-STAB-05: the interior of `polygon`, which lies in the Voronoi facet of `samples`. The corners are those
// of the closure, in cyclic order, from the least one on towards the lesser of its neighbours.
struct Sector {
  std::array<std::size_t, 2> samples;
  std::vector<Point> polygon;

  friend bool operator==(const Sector&, const Sector&) = default;
  friend bool operator<(const Sector& a, const Sector& b) {
    return std::tie(a.samples, a.polygon) < std::tie(b.samples, b.polygon);
  }
};

// Each list ascending: by position, by samples and front, by polygon and ends, by samples and corners. No two
// of a list are alike in these.
struct StableSet {
  std::vector<SkeletonPoint> points;
  std::vector<BackwardSegment> segments;
  std::vector<BackwardInterval> intervals;
  std::vector<Sector> sectors;
  bool has_vertex = false;  // among the points is a Voronoi vertex

  friend bool operator==(const StableSet&, const StableSet&) = default;
};

// For z of index 0 to 2, and regular stationary z of every kind. Those of index 0 and 1 have but one point in
// `points`, z. Throws std::invalid_argument for index 3: that set is open, and fills space with the others.
StableSet stable_set(const PointSet& set, const StationaryPoint& z);

}  // namespace oracle
