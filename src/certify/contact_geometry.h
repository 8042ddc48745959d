// Questions about a few samples on one sphere, answered exactly.
//
// Guarantees: names are those of classes (PointSet::name), ascending.
#pragma once

#include <span>
#include <vector>

#include "certify/layer.h"
#include "flowcert/stationary_points.h"

namespace flowcert::certify {

[[nodiscard]] const Point& sample(const PointSet& points, PointId name);

[[nodiscard]] bool all_on_sphere(const PointSet& points, std::span<const PointId> names,
                                 const ExactSphere& sphere);

// Of the affine hull, 0 to 3, of at least one sample; all of them on a sphere, so that no three are on a
// line.
[[nodiscard]] int affine_dimension(const PointSet& points, std::span<const PointId> names);

// All of `of` that is in the plane of `plane`, whose first three samples span it; nothing where `of` has
// samples on both sides of it.
[[nodiscard]] std::vector<PointId> supported_face(const PointSet& points, std::span<const PointId> plane,
                                                  std::span<const PointId> of);

// The samples nearest to x, and how far they are: C(x) and d(x)^2 (FC-DIST-01). A scan in double precision,
// and exact arithmetic for those that it cannot tell apart.
struct NearestSamples {
  std::vector<PointId> names;
  Rational squared_distance;
};
[[nodiscard]] NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x);

}  // namespace flowcert::certify
