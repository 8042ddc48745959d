// The box at which lines to infinity are cut.
//
// Guarantees: exact, but for its sides and the points where lines leave it. Those are the nearest doubles.
#pragma once

#include <optional>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert {

class ClipBox {
 public:
  // The bounding box of the points, scaled about its centre by the factor, which is at least 1. A side of length 0
  // counts as long as the longest one. Each side lies at the nearest double, or at the largest double if it would be
  // beyond all of them. There must be a point. Throws InvalidInput for a lesser factor.
  ClipBox(const PointSet& points, const Rational& factor);

  [[nodiscard]] const Point& low() const { return low_; }
  [[nodiscard]] const Point& high() const { return high_; }
  // Closed. What has an infinite coordinate is not in the box.
  [[nodiscard]] bool contains(const Point& position) const;
  // Where the ray from a position in the box leaves it, in the nearest doubles; so it is in the box. The direction must
  // not be zero.
  [[nodiscard]] Point exit(const Point& from, const RationalPoint& direction) const;

 private:
  Point low_, high_;
};

}  // namespace flowcert
