#include "geometry/nearest_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/contract.h"
#include "geometry/filter_bounds.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"

namespace flowcert::geometry {

namespace {

// The places of all points that may be nearest to x. filter_bounds.h says how far a computed distance is from the true
// one. A coordinate of x without a nearest double becomes infinite, and then all points are candidates.
std::vector<std::size_t> candidates(const PointSet& points, const RationalPoint& x) {
  const auto rounded = [](const Rational& value) { return nearest_double(value).value_or(HUGE_VAL); };
  const Point from{rounded(x[0]), rounded(x[1]), rounded(x[2])};
  std::vector<double> squared(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double dx = points[k].x - from.x, dy = points[k].y - from.y, dz = points[k].z - from.z;
    squared[k] = dx * dx + dy * dy + dz * dz;
  }
  const double least = std::sqrt(*std::min_element(squared.begin(), squared.end()));
  const double largest = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
  const double bound =
      least * (1 + kDistanceBound * kUnitRoundoff) + kPositionBound * kUnitRoundoff * largest + kDistanceUnderflow;
  const double squared_bound = bound * bound * (1 + kSquareBound * kUnitRoundoff);
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (squared[k] <= squared_bound || bound > kLargestDistance) result.push_back(k);
  }
  return result;
}

}  // namespace

NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x) {
  FLOWCERT_REQUIRES(!points.empty());
  require_ieee_doubles();
  NearestSamples nearest;
  for (const std::size_t k : candidates(points, x)) {
    const Rational distance = squared_distance(x, points[k]);
    if (!nearest.names.empty() && distance > nearest.squared_distance) continue;
    if (nearest.names.empty() || distance < nearest.squared_distance) nearest.names.clear();
    nearest.squared_distance = distance;
    nearest.names.push_back(points.name(k));
  }
  return nearest;
}

}  // namespace flowcert::geometry
