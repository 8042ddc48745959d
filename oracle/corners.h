// Corners of convex regions in a plane, some of them at infinity, and what cuts such a region: bisectors.
//
// In homogeneous coordinates a corner is a vector with a weight, which is 0 at infinity. So one computation serves both
// sorts of corners. Exact.
#pragma once

#include <tuple>
#include <vector>

#include "oracle/unstable_set.h"

namespace oracle {

// A point, or an end at infinity: then `position` is the Direction in which it lies. Points come before ends at
// infinity, and both are ordered by coordinates.
struct Corner {
  Point position;
  bool at_infinity = false;

  friend bool operator==(const Corner&, const Corner&) = default;
  friend bool operator<(const Corner& a, const Corner& b) {
    return std::tie(a.at_infinity, a.position) < std::tie(b.at_infinity, b.position);
  }
};

// The direction from m to a corner.
Point way_to(const Corner& corner, const Point& m);

// Whether two corners are on one line through m.
bool in_line(const Corner& a, const Point& m, const Corner& b);

// A point between two corners. At most one of them is at infinity.
Point between(const Corner& a, const Corner& b);

// The part of a convex polygon that is not nearer to q than to p.
std::vector<Corner> clipped(const std::vector<Corner>& polygon, const Point& p, const Point& q);

// The corners of a polygon, from the least one towards the lesser of its neighbours.
std::vector<Corner> canonical(std::vector<Corner> polygon);

}  // namespace oracle
