// Balls, and the critical points of the distance from them (FC-BALL-01 to FC-BALL-04).
//
// d(x) is the least |x - p| - r of the balls, and the contacts of x are the balls with it. Exact, by search over all
// subsets of the balls. This is meant for a dozen balls: the search takes time n^5. Balls are named by their ids, the
// places in the input.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "oracle/point_set.h"
#include "oracle/quadratic.h"

namespace oracle {

struct Ball {
  Point centre;
  Rational radius;  // positive
};

// The balls that are not hidden (FC-BALL-02), ascending.
Places visible_balls(const std::vector<Ball>& balls);

std::vector<Point> centres(const std::vector<Ball>& balls);

// |x - p|^2 - (r + s)^2, the power of x for a ball that has grown by s. Where r + s >= 0, it has the sign of
// |x - p| - r - s.
Quadratic power(const Ball& ball, const QuadraticPoint& x, const Quadratic& s);

// The point of the centres' affine hull that has one power for all of some balls that grow: start + s * velocity.
struct EquallyFar {
  std::vector<Ball> simplex;
  Point start, velocity;

  QuadraticPoint at(const Quadratic& s) const { return moved(start, s, velocity); }
  // The s for which the power is 0, ascending.
  std::vector<Quadratic> zeros() const;
};
// Nothing iff the centres are affinely dependent, or there are none.
std::optional<EquallyFar> equally_far(const std::vector<Ball>& simplex);

// A point that balls touch when they have grown by s.
struct Touching {
  QuadraticPoint position;
  Quadratic s;
};
// The point that all of the balls touch, if it is in the relative interior of the centres' simplex. No radius r + s is
// negative there. A single ball touches its centre when it has shrunk to it.
std::optional<Touching> touching_inside(const std::vector<Ball>& simplex);

struct BallPoint {
  int index = 0;
  Places contacts;
  Quadratic value;  // d(x)
  QuadraticPoint position;
};

// The list of points (FC-BALL-03).
std::vector<BallPoint> critical_points(const std::vector<Ball>& balls);
// Tries these subsets alone, in time n for each. They have to have every simplex of a point's contacts that the point
// is inside of.
std::vector<BallPoint> critical_points(const std::vector<Ball>& balls, const std::set<Places>& subsets);

}  // namespace oracle
