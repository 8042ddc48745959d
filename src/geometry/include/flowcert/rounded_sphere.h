// The doubles nearest to exact numbers, and to the centre and the squared radius of a sphere.
//
// Guarantees: each is the double nearest to the exact number, ties to even, or an infinity of its sign where that would
// overflow. Doubled doubles with proven bounds decide most of those of spheres, exact numbers the others.
#pragma once

#include <cstddef>
#include <span>

#include "flowcert/exact_sphere.h"

namespace flowcert {

[[nodiscard]] double nearest_or_infinity(const Rational& value);
[[nodiscard]] Point rounded_point(const RationalPoint& x);

struct RoundedSphere {
  Point center;
  double squared_radius = 0;
};

[[nodiscard]] RoundedSphere rounded_sphere(const ExactSphere& sphere);

// rounded_sphere(exact_sphere(points, contact)). hull_dimension: that of the contact set's affine hull.
[[nodiscard]] RoundedSphere rounded_sphere(const PointSet& points, std::span<const PointId> contact,
                                           std::size_t hull_dimension);

}  // namespace flowcert
