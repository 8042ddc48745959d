#include "geometry/nearest_samples.h"

#include <algorithm>
#include <cstddef>

#include "flowcert/sphere.h"
#include "geometry/contract.h"
#include "geometry/distance_filter.h"
#include "geometry/rational_point.h"

namespace flowcert::geometry {

DistanceOrder::DistanceOrder(const RationalPoint& x) : x_(x), rounded_(rounded_point(x)) {
  largest_ = greatest_coordinate(rounded_);
}

double DistanceOrder::rounded_distance(const Point& p) const { return geometry::rounded_distance(rounded_, p); }

double DistanceOrder::reach(double distance) const { return reach_of(distance, largest_); }

Sign DistanceOrder::compare(const Point& p, const Point& q) const {
  const double to_p = rounded_distance(p), to_q = rounded_distance(q);
  if (to_p > reach(to_q)) return Sign::kPositive;
  if (to_q > reach(to_p)) return Sign::kNegative;
  // |x - p|^2 - |x - q|^2 = <p - q, p + q - 2 x>
  const auto term = [](const Rational& x, double a, double b) {
    return a == b ? Rational(0) : Rational((Rational(a) - Rational(b)) * (Rational(a) + Rational(b) - 2 * x));
  };
  return sign_of(Rational(term(x_[0], p.x, q.x) + term(x_[1], p.y, q.y) + term(x_[2], p.z, q.z)));
}

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
