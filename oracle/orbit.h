// The orbit of a point under the flow of the distance function, from the definitions alone (FC-FLOW-01 to 07), and its
// location (FC-LOC-01).
//
// Each segment of an orbit costs two scans over all points. One finds the first point that the way meets, the other
// the contact set there. Exact, for any start and any finite point set of any dimension.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
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

// The places of C(x + t * direction) for all small t > 0. `contact` has the places of C(x) (FC-FLOW-01).
Places crossed_places(const PointSet& set, const Places& contact, const Point& direction);

// Nothing iff x is stationary. The point set must not be empty.
std::optional<FlowSegment> flow_segment(const PointSet& set, const Point& x);

Orbit orbit(const PointSet& set, const Point& start);

// Where a point of space flows to, and the samples that are nearest to it, by class names, ascending.
struct Location {
  std::optional<StationaryPoint> limit;  // nothing: infinity
  std::vector<std::size_t> nearest;

  friend bool operator==(const Location&, const Location&) = default;
};

// Throws std::invalid_argument for the empty set (FC-LOC-02).
Location locate(const PointSet& set, const Point& x);

// One of the two orbits of U2 of a critical point x of index 2 (FC-FLOW-07). x itself does not move. The orbit leaves
// it along the line of all points equally far from C(x), and has contact set C(x) for all small t > 0. Its first
// segment starts in x, and x is its driver. With the contact points a < b < c < ... by name, (b - a) x (c - a) points
// to side 1, and side 0 is the other. Throws std::invalid_argument for another kind of stationary point or another
// side.
Orbit unstable_orbit(const PointSet& set, const StationaryPoint& saddle, int side);

// Only the first segment of that orbit.
FlowSegment unstable_segment(const PointSet& set, const StationaryPoint& saddle, int side);

// Both orbits, side 0 first.
std::array<Orbit, 2> unstable_orbits(const PointSet& set, const StationaryPoint& saddle);

// 'V', 'E', 'F' or 'C': the Voronoi face whose points have this contact set, given by class names.
char face_letter(const PointSet& set, const std::vector<std::size_t>& contact_names);

// "E-F-V", "E-F-inf" (FC-FLOW-02).
std::string segment_type(const PointSet& set, const FlowSegment& segment);

}  // namespace oracle
