// Starts of orbits for an input, most of them placed exactly where an orbit can go wrong: on Voronoi
// vertices, edges and facets, on drivers and stationary points, in the plane of some of the points.
//
// Guarantees: a start is a function of the point set and a choice, which drawn_start.h draws. A start is mostly where
// its kind says, but this is not promised (three points need not have a Voronoi edge). Only the oracle's geometry is
// used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "oracle/stationary_points.h"

namespace flowcert::property {

enum class StartKind : std::uint8_t {
  kNearby,      // a point of the input, plus a small rational offset
  kBox,         // in the bounding box
  kVertex,      // on a Voronoi vertex
  kEdge,        // inside a Voronoi edge
  kFacet,       // inside a Voronoi facet
  kDriver,      // the centre of two or three points
  kInputPoint,  // a point of the input
  kPlane,       // in the plane of three points, or straight above a point of it
  kSegment,     // between a point of the input and a midpoint
  kAimed,       // across a facet or through a cell, straight at a Voronoi vertex
};
inline constexpr std::size_t kStartKindCount = 10;
inline constexpr std::array<const char*, kStartKindCount> kStartKindNames = {
    "nearby", "box", "vertex", "edge", "facet", "driver", "input-point", "plane", "segment", "aimed"};

struct StartChoice {
  StartKind kind = StartKind::kNearby;
  std::vector<std::uint32_t> numbers;
};
std::ostream& operator<<(std::ostream& out, const StartChoice& choice);

// The point set must not be empty.
oracle::Point start_of(const oracle::PointSet& set, const StartChoice& choice);

}  // namespace flowcert::property
