// Pieces of Voronoi faces, by their corners: parts of edges, segments through facets, and regions of facets.
//
// A corner may be at infinity, and a piece is unbounded iff one of its corners is. In homogeneous coordinates a corner
// is a vector with a weight, which is 0 at infinity. So one computation serves both sorts of corners. Pieces compare
// member by member. Exact.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <utility>
#include <vector>

#include "oracle/point_set.h"

namespace oracle {

// A vector, scaled so that its largest coordinate is 1 or -1.
using Direction = Point;

// The vector must not be zero.
Direction as_direction(const Point& vector);

// A point, or an end at infinity: then `position` is the Direction in which it lies. Points come before ends at
// infinity, and both are ordered by coordinates.
struct Corner {
  Corner(Point x, bool is_far = false) : at_infinity(is_far), position(std::move(x)) {}

  bool at_infinity;
  Point position;

  friend auto operator<=>(const Corner&, const Corner&) = default;
};

// An interval of the Voronoi edge whose contact set is the polygon, by class names, ascending.
struct EdgePart {
  std::vector<std::size_t> polygon;
  Corner front, back;

  friend auto operator<=>(const EdgePart&, const EdgePart&) = default;
};

// An open segment in the Voronoi facet of two samples, ascending. It flows from `back` to `front`.
struct Crossing {
  std::array<std::size_t, 2> samples;
  Corner front, back;

  friend auto operator<=>(const Crossing&, const Crossing&) = default;
};

// A convex region in the Voronoi facet of two samples, ascending. The corners of its closure are in cyclic order, from
// the least corner towards the lesser of its neighbours.
struct Region {
  std::array<std::size_t, 2> samples;
  std::vector<Corner> corners;

  friend auto operator<=>(const Region&, const Region&) = default;
};

bool is_unbounded(const Region& region);

// Each corner of a region with the next one, around it.
std::vector<std::pair<const Corner&, const Corner&>> sides_of(const std::vector<Corner>& corners);

// The direction from m to a corner.
Point way_to(const Corner& corner, const Point& m);

// Whether two corners are on one line through m.
bool in_line(const Corner& a, const Point& m, const Corner& b);

// A point between two corners. At most one of them is at infinity.
Point between(const Corner& a, const Corner& b);

// The part of a convex region that is in the closed Voronoi cell of the sample at this place. The corners stay in their
// order. If the region is in the plane between this sample and another one, that is its part in their closed facet.
std::vector<Corner> in_cell(const PointSet& set, std::size_t place, std::vector<Corner> region);

// The corners of a region in the order of Region.
std::vector<Corner> canonical(std::vector<Corner> region);

// Whether x is in a region, or on a side of it if these count. x is in its plane, and the axis is orthogonal to that.
bool is_in_region(const std::vector<Corner>& corners, const Point& axis, const Point& x, bool sides_count);

// Directions u orthogonal to p1 - p0 with <u, q - p0> <= 0 for some samples q. They are a part of a circle, which is
// cut into pieces of less than half of it: single directions, and open arcs with these at their ends. Arcs are listed
// counterclockwise, seen from p1.
struct Directions {
  std::vector<Direction> single;
  std::vector<std::pair<Direction, Direction>> arcs;
};
Directions free_directions(const std::vector<Point>& samples, const Point& p0, const Point& p1);

}  // namespace oracle
