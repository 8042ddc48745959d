// The smallest sphere through a cospherical set of points.
//
// Guarantees: exact, or rounded as nearest_or_infinity() rounds. Doubled doubles with proven bounds decide most rounded
// numbers, exact numbers the others. Source: spec clause FC-CRIT-02.
#pragma once

#include <cstddef>
#include <span>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert {

// The centre and squared radius of the smallest sphere through a cospherical set (one point and more, by name). Any
// other set gets the sphere of its first affinely independent points; the caller finds others that are not on it.
struct ExactSphere {
  RationalPoint center;
  Rational squared_radius;
};
[[nodiscard]] ExactSphere exact_sphere(const PointSet& points, std::span<const PointId> contact);
// Its squared radius alone, which takes less time.
[[nodiscard]] Rational exact_squared_radius(const PointSet& points, std::span<const PointId> contact);

struct RoundedSphere {
  Point center;
  double squared_radius = 0;
};
[[nodiscard]] RoundedSphere rounded_sphere(const ExactSphere& sphere);
// rounded_sphere(exact_sphere(points, contact)). hull_dimension: that of the contact set's affine hull.
[[nodiscard]] RoundedSphere rounded_sphere(const PointSet& points, std::span<const PointId> contact,
                                           std::size_t hull_dimension);
// Its squared radius alone, which takes less time.
[[nodiscard]] double rounded_squared_radius(const PointSet& points, std::span<const PointId> contact,
                                            std::size_t hull_dimension);
[[nodiscard]] Point rounded_point(const RationalPoint& x);

}  // namespace flowcert
