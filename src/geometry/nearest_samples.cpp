#include "geometry/nearest_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/contract.h"
#include "geometry/filter_bounds.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"

namespace flowcert::geometry {

namespace {

// The places of all points that may be nearest to x; `from` is x, rounded. filter_bounds.h says how far a computed
// distance is from the true one.
std::vector<std::size_t> candidates(const PointSet& points, const Point& from) {
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

std::vector<std::size_t> candidates(const PointSet& points, const RationalPoint& x) {
  std::array<double, 3> rounded{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double> nearest = nearest_double(x[axis]);
    if (!nearest) {
      std::vector<std::size_t> all(points.size());
      for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
      return all;
    }
    rounded[axis] = *nearest;
  }
  return candidates(points, Point{rounded[0], rounded[1], rounded[2]});
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
