#include <algorithm>
#include <cmath>
#include <optional>

#include "flowcert/stable_manifolds.h"
#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

namespace {

// A little less than 2^-40, for the roundings of the error itself.
constexpr double kShare = 0x1p-40 * (1 - 0x1p-10);
// A corner is rounded by at most 2^-53 of each coordinate, and its distance to the sample by 2^-52 of itself.
constexpr double kCornerShare = 0x1p-52;
// The cross product, its length and the sum are rounded by less than 8 units of the product of both lengths.
constexpr double kNormalShare = 0x1p-49;
// Squares of small or large numbers leave the range of doubles.
constexpr double kLeastArea = 1e-140, kGreatestArea = 1e140;

// Nothing if the bound is too large, or something is out of the range of doubles.
std::optional<double> rounded_area(const PointSet& points, const RoundedSegments& rounded) {
  double sum = 0, error = 0;
  for (const RoundedSegments::Segment& segment : rounded.segments) {
    const Point& p = points.at_row(segment.samples[0]);
    const Point& front = rounded.positions[segment.front].sphere.center;
    const Point& back = rounded.positions[segment.back].sphere.center;
    const Vector3<double> u = vector_between(p, front), v = vector_between(p, back);
    double greatest = 0;
    for (const Point& x : {p, front, back}) greatest = std::max(greatest, greatest_coordinate(x));
    const double length_u = std::sqrt(dot(u, u)), length_v = std::sqrt(dot(v, v));
    const Vector3<double> normal = cross(u, v);
    sum += std::sqrt(dot(normal, normal));
    const double of_corner = kCornerShare * greatest;
    error += of_corner * (length_u + length_v + of_corner) + kNormalShare * length_u * length_v;
  }
  const bool is_decided = error < kShare * sum && sum > kLeastArea && sum < kGreatestArea;
  return is_decided ? std::optional(sum) : std::nullopt;
}

double exact_area(const PointSet& points, const StableSet<>& set) {
  double sum = 0;
  for (const BackwardSegment<>& segment : set.segments) {
    const Point& p = points.at_row(segment.samples[0]);
    const RationalPoint normal = normal_of(exact_position(p), segment.front.position, segment.back.position);
    sum += geometry::nearest_difference_of_roots(dot(normal, normal), 0);
  }
  return sum;
}

}  // namespace

double surface_area(const PointSet& points, const StableManifolds& stable, std::size_t i) {
  const geometry::IeeeDoubles ieee;
  if (stable.segment_count(i) == 0) return 0;
  const auto rounded = rounded_area(points, stable.rounded_segments(i));
  return rounded ? *rounded : exact_area(points, stable.set(i));
}

}  // namespace flowcert
