// Intervals of a line, with or without their ends, and unions of them.
//
// Exact. An end is a corner, so that it may be infinite. An interval whose ends are equal is a point, and has both.
#pragma once

#include <vector>

#include "oracle/pieces.h"

namespace oracle {

// The order of corners along their line: that of the coordinates, between its two ends at infinity.
bool is_before(const Corner& a, const Corner& b);

struct Interval {
  Corner from, to;
  bool has_from = false, has_to = false;

  [[nodiscard]] bool is_point() const { return from == to; }
};

// The interval between two corners, without these.
Interval open_interval(const Corner& a, const Corner& b);

// The connected components of a union, ascending.
std::vector<Interval> components(std::vector<Interval> intervals);

// Whether the open interval with these ends, or the point, is in one of the components.
bool covers(const std::vector<Interval>& components, const Interval& part);

// What is left of the components in the first list, as open intervals. Single points that are left are not listed.
std::vector<Interval> open_remainder(const std::vector<Interval>& of, const std::vector<Interval>& without);

}  // namespace oracle
