// See contact_geometry.h.
#include "certify/contact_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/predicates.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

Sign orientation(const PointSet& points, std::span<const PointId> plane, PointId q) {
  FilterTally unused;
  return exact_sign(Orientation{sample(points, plane[0]), sample(points, plane[1]), sample(points, plane[2]),
                                sample(points, q)},
                    unused);
}

// The places of all points that may be nearest to x; `from` is x, rounded. For u = 2^-53: the computed
// distance differs from the true one by no more than 8 u times itself (three differences, squares, sums, a
// root), what rounding x moves it by (less than 2 u max|x|), and what underflow takes away (less than 1e-150
// in the root).
std::vector<std::size_t> candidates(const PointSet& points, const Point& from) {
  constexpr double kUnit = 0x1p-53;
  std::vector<double> squared(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double dx = points[k].x - from.x, dy = points[k].y - from.y, dz = points[k].z - from.z;
    squared[k] = dx * dx + dy * dy + dz * dz;
  }
  const double least = std::sqrt(*std::min_element(squared.begin(), squared.end()));
  const double largest = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
  const double bound = least * (1 + 32 * kUnit) + 8 * kUnit * largest + 1e-149;
  const double squared_bound = bound * bound * (1 + 8 * kUnit);
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    // Beyond 1e150 squares may overflow.
    if (squared[k] <= squared_bound || bound > 1e150) result.push_back(k);
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

const Point& sample(const PointSet& points, PointId name) { return points[points.position_of_row(name)]; }

bool all_on_sphere(const PointSet& points, std::span<const PointId> names, const ExactSphere& sphere) {
  return std::all_of(names.begin(), names.end(), [&](PointId name) {
    return squared_distance(sphere.center, sample(points, name)) == sphere.squared_radius;
  });
}

int affine_dimension(const PointSet& points, std::span<const PointId> names) {
  if (names.size() < 4) return static_cast<int>(names.size()) - 1;
  const bool is_flat = std::all_of(names.begin() + 3, names.end(), [&](PointId name) {
    return orientation(points, names, name) == Sign::kZero;
  });
  return is_flat ? 2 : 3;
}

std::vector<PointId> supported_face(const PointSet& points, std::span<const PointId> plane,
                                    std::span<const PointId> of) {
  std::vector<PointId> face;
  Sign side = Sign::kZero;
  for (const PointId name : of) {
    const Sign sign = orientation(points, plane, name);
    if (sign == Sign::kZero) {
      face.push_back(name);
    } else if (side == Sign::kZero) {
      side = sign;
    } else if (sign != side) {
      return {};
    }
  }
  return face;
}

NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x) {
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

}  // namespace flowcert::certify
