// The orbit of a point under the flow of the distance function, from the definitions alone (FC-FLOW-01 to
// 06).
//
// Each segment costs a scan over all points for the contact set and another for the first point that the way
// meets. Exact, for any start, any finite point set and any dimension of it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// One flow segment (FC-FLOW-02). Contact sets by class names, ascending.
struct FlowSegment {
  Point start;
  Point driver;
  std::vector<std::size_t> start_contact;    // of the Voronoi face S
  std::vector<std::size_t> crossed_contact;  // of C
  std::optional<Point> end;                  // nothing: infinity
  std::vector<std::size_t> end_contact;      // of R; empty at infinity
};

// Where an orbit ends: a stationary point, or nothing for infinity.
struct Orbit {
  std::vector<FlowSegment> segments;  // none from a stationary point
  std::optional<StationaryPoint> limit;
};

// The point of conv C(x) nearest to x (FC-DIST-02), where `contact` is C(x).
Point driver(const std::vector<Point>& contact, const Point& x);

// Nothing iff x is stationary. The point set must not be empty.
std::optional<FlowSegment> flow_segment(const PointSet& set, const Point& x);

Orbit orbit(const PointSet& set, const Point& start);

// 'V', 'E', 'F' or 'C': the Voronoi face whose points have this contact set, given as places in the set's
// points.
char face_letter(const PointSet& set, const std::vector<std::size_t>& contact_names);

}  // namespace oracle
