// An unstable set of dimension 2 (UnstableSurface) in the nearest doubles, for pictures: corners by number, and parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert {

struct RoundedUnstableSurface {
  // A coordinate that would overflow is an infinity. At infinity, the position is a vector in that direction, scaled so
  // that its largest coordinate is 1 or -1.
  struct Corner {
    Point position;
    bool at_infinity = false;
    std::optional<RationalPoint> exact;  // where a coordinate would overflow
  };
  enum class Kind : std::uint8_t { kTrace, kRun, kSegment, kSheet };
  struct Part {
    Kind kind;
    // Of a segment's or a sheet's facet both samples; of a trace's or a run's polygon the first three: ascending.
    std::vector<PointId> samples;
    // Numbers of corners. A sheet goes counterclockwise, seen from samples[1], from its least number on. At most two of
    // its corners are at infinity; two are neighbours, and not opposite. Any other part goes from the lesser number to
    // the greater one. A trace that is a point has one corner, and one that is a whole line has its middle, too.
    std::vector<std::uint32_t> corners;
  };

  // Two are one iff their exact positions are equal, or their exact directions. Those at infinity come last. The order
  // is lexicographic in the doubles, and then in the exact numbers.
  std::vector<Corner> corners;
  // By kind, samples and corners. If P does not span space, a sheet is a whole facet, and two parts here, or four of a
  // whole plane.
  std::vector<Part> parts;
};

}  // namespace flowcert
