// The smallest sphere through a cospherical set of points.
//
// Guarantees: exact. Source: spec clause FC-CRIT-02.
#pragma once

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

}  // namespace flowcert
