// Intervals of a line, with or without their ends, and unions of them.
//
// Exact. An end may be infinite. An interval whose ends are equal is a point, and has both of them.
#pragma once

#include <compare>
#include <vector>

#include "oracle/exact_geometry.h"

namespace oracle {

// A rational, or an end of the line.
struct Coordinate {
  int infinite = 0;  // -1 or 1 at an end
  Rational value;    // 0 there

  friend bool operator==(const Coordinate&, const Coordinate&) = default;
  friend bool operator<(const Coordinate& a, const Coordinate& b) {
    return a.infinite != b.infinite ? a.infinite < b.infinite : a.value < b.value;
  }
};

struct Interval {
  Coordinate from, to;
  bool has_from = false, has_to = false;

  [[nodiscard]] bool is_point() const { return from == to; }
};

// The connected components of a union, ascending.
std::vector<Interval> components(std::vector<Interval> intervals);

// Whether the open interval with these ends, or the point, is in one of the components.
bool covers(const std::vector<Interval>& components, const Interval& part);

// What is left of the components in the first list, as open intervals. Single points that are left are not told.
std::vector<Interval> open_remainder(const std::vector<Interval>& of, const std::vector<Interval>& without);

}  // namespace oracle
