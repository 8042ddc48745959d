#include "geometry/nearest_samples.h"

#include <algorithm>
#include <cstddef>

#include "geometry/contract.h"
#include "geometry/distance_order.h"
#include "geometry/rational_point.h"

namespace flowcert::geometry {

namespace {

// The places of all points that may be nearest to x.
std::vector<std::size_t> candidates(const PointSet& points, const DistanceOrder& order) {
  std::vector<double> distances(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) distances[k] = order.rounded_distance(points[k]);
  const double reach = order.reach(*std::min_element(distances.begin(), distances.end()));
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (distances[k] <= reach) result.push_back(k);
  }
  return result;
}

}  // namespace

NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x) {
  FLOWCERT_REQUIRES(!points.empty());
  NearestSamples nearest;
  for (const std::size_t k : candidates(points, DistanceOrder(x))) {
    const Rational distance = squared_distance(x, points[k]);
    if (!nearest.names.empty() && distance > nearest.squared_distance) continue;
    if (nearest.names.empty() || distance < nearest.squared_distance) nearest.names.clear();
    nearest.squared_distance = distance;
    nearest.names.push_back(points.name(k));
  }
  return nearest;
}

}  // namespace flowcert::geometry
