// What flows to infinity: the stable set of infinity, from the definitions alone (FC-STAB-08).
//
// This builds its skeleton by the same search against the flow as for a stationary point. The search begins with what
// goes on for ever: along unbounded Voronoi edges, and in unbounded Voronoi facets. So some pieces have ends at
// infinity. Such an end is given by a direction. Exact, for any finite point set of any dimension.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "oracle/corners.h"
#include "oracle/stable_set.h"

namespace oracle {

// The open ray from `back` in the direction `front`. It flows to infinity, away from the midpoint of the samples.
struct UnboundedSegment {
  std::array<std::size_t, 2> samples;  // of the Voronoi facet in which it lies, ascending
  Direction front;
  Point back;
  std::vector<std::size_t> back_contact;
  BackKind back_kind;

  friend bool operator==(const UnboundedSegment&, const UnboundedSegment&) = default;
  friend bool operator<(const UnboundedSegment& a, const UnboundedSegment& b) {
    return std::tie(a.samples, a.front) < std::tie(b.samples, b.front);
  }
};

// The open ray from `back` in the direction `front`, on a Voronoi edge. In the first two cases of IntervalKind it flows
// along the edge. In the third case, rays of an unbounded sector cross it.
struct UnboundedInterval {
  std::vector<std::size_t> polygon;  // the contact set of the Voronoi edge
  Direction front;
  Point back;
  IntervalKind kind;

  friend bool operator==(const UnboundedInterval&, const UnboundedInterval&) = default;
  friend bool operator<(const UnboundedInterval& a, const UnboundedInterval& b) {
    return std::tie(a.polygon, a.front, a.back) < std::tie(b.polygon, b.front, b.back);
  }
};

// The interior of a convex region of the Voronoi facet of `samples`. One of its corners is at infinity, or two that
// are neighbours. All rays between these two directions, from the other corners, lie in the region. The order of the
// corners is that of a Sector.
struct UnboundedSector {
  std::array<std::size_t, 2> samples;
  std::vector<Corner> corners;

  friend bool operator==(const UnboundedSector&, const UnboundedSector&) = default;
  friend bool operator<(const UnboundedSector& a, const UnboundedSector& b) {
    return std::tie(a.samples, a.corners) < std::tie(b.samples, b.corners);
  }
};

// Each list is ascending. `bounded` has all pieces without an end at infinity. In the facets of a bounded Voronoi cell
// there are no others, so that shares() of `bounded` are right for its sample (FC-VOL-02).
struct InfinitySet {
  StableSet bounded;
  std::vector<UnboundedSegment> segments;
  std::vector<UnboundedInterval> intervals;
  std::vector<UnboundedSector> sectors;

  friend bool operator==(const InfinitySet&, const InfinitySet&) = default;
};

// If P does not span space, the directions in which a facet is unbounded may be all of its plane, or half of it. Then
// they are cut into quarters of a circle, by rays from the midpoint: the list of segments has these rays.
InfinitySet stable_set_of_infinity(const PointSet& set);

// Whether the orbit of x goes to infinity, from the skeleton alone.
bool contains(const PointSet& set, const InfinitySet& infinity, const Point& x);

}  // namespace oracle
