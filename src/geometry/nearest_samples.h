// Which of two samples is nearer to a position, and the samples nearest to it, by a scan of all of them.
//
// Guarantees: exact. Doubles decide where the distances differ by more than their rounding (filter_bounds.h), and
// rationals decide the rest.
#pragma once

#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "geometry/predicates.h"

namespace flowcert::geometry {

class DistanceOrder {
 public:
  // The position must outlive it. A coordinate without a nearest double is taken for infinite.
  explicit DistanceOrder(const RationalPoint& x);

  // The distance from the position to a sample, in doubles.
  [[nodiscard]] double rounded_distance(const Point& p) const;
  // A sample is farther than another one if its rounded distance is more than this, made of the other's. It is infinite
  // or no number where doubles decide nothing.
  [[nodiscard]] double reach(double distance) const;

  // The sign of |x - p| - |x - q|.
  [[nodiscard]] Sign compare(const Point& p, const Point& q) const;

 private:
  const RationalPoint& x_;
  Point rounded_;
  double largest_;
};

// C(x) by name, ascending, and d(x)^2 (FC-DIST-01).
struct NearestSamples {
  std::vector<PointId> names;
  Rational squared_distance;
};
// There must be at least one point.
[[nodiscard]] NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x);

}  // namespace flowcert::geometry
