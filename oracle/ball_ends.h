// The ends of index-2 points of the distance from balls (FC-BALL-09): where one comes to, from its two sides, on ways
// that never leave {d > d(w)}. So each end is in the component of {d > d(w)} at that side.
//
// The power diagram at a level s is that of the balls that have grown by s. A way goes from vertex to vertex of it at
// one level, or with a vertex to higher levels. It stops where d(x) = s. Exact, by brute force: all quadruples and
// triples of a contact set, and scans over all balls.
#pragma once

#include <array>
#include <optional>
#include <set>

#include "oracle/balls.h"

namespace oracle {

// Index-3 points, by their places in the list of all critical points; the outside has the list's length. More than one
// only where ways of equal merit lead on.
using Ends = std::set<std::size_t>;

// At the two sides of the index-2 point. `all` are the critical points of the balls.
std::array<Ends, 2> ends_of(const std::vector<Ball>& balls, const std::vector<BallPoint>& all, const BallPoint& w);

// Orthogonal to the edges, of which there are two at most, and independent.
Point normal_of(const std::vector<Point>& edges);

// A place foot + height * direction that these balls touch, and no others, when they have grown by s. The direction is
// orthogonal to the hull of the visible ones, and does not lead nearer to it; where this hull has dimension 3 it means
// nothing.
struct Start {
  Point foot;
  Quadratic height;
  Point direction;
  Places contacts;
};
// Nothing for a start with another direction.
std::vector<std::optional<Ends>> ends_from(const std::vector<Ball>& balls, const std::vector<BallPoint>& all,
                                           const std::vector<Start>& starts, const Rational& s);

}  // namespace oracle
