// Spheres whose centre and squared radius are known within bounds.
//
// Guarantees: the bounds are proven (src/flow/cascades.md); they are infinite where nothing is known, for example of a
// sphere through points that are nearly coplanar.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "flowcert/sphere.h"
#include "geometry/bounded_number.h"

namespace flowcert::geometry {

struct BoundedSphere {
  std::array<BoundedNumber, 3> center;
  BoundedNumber squared_radius;
};

// The smallest sphere through 1, 2, 3 or 4 affinely independent points.
[[nodiscard]] BoundedSphere bounded_sphere(std::span<const Point* const> points);
// exact_sphere(points, contact), within bounds.
[[nodiscard]] BoundedSphere bounded_sphere(const PointSet& points, std::span<const PointId> contact,
                                           std::size_t hull_dimension);

// The squared radius of the same sphere, which takes less time than the sphere. Its bounds are others.
[[nodiscard]] BoundedNumber bounded_squared_radius(std::span<const Point* const> points);
[[nodiscard]] BoundedNumber bounded_squared_radius(const PointSet& points, std::span<const PointId> contact,
                                                   std::size_t hull_dimension);

// Nothing if the bounds leave one of the doubles open.
[[nodiscard]] std::optional<RoundedSphere> decided_sphere(const BoundedSphere& sphere);

}  // namespace flowcert::geometry
