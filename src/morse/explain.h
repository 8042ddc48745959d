// Why a set of input points is, or is not, the contact set of a stationary point, and why a position is, or
// is not, stationary.
//
// Guarantees: exact. It scans all points, and takes the conditions of spec clause FC-CRIT-05 in their order. It
// depends on no triangulation of the whole input.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flowcert/stationary_points.h"

namespace flowcert {

struct Explanation {
  // Set where it is stationary.
  std::optional<StationaryIndex> index;
  // The centre asked about, with its distance to the points asked about. There is none if they lie on no common
  // sphere centred in their affine hull.
  std::optional<ExactSphere> sphere;
  // C(centre), by name: all points at the distance d(centre). It is empty where there is no centre.
  std::vector<PointId> contact;
  // d(centre)^2.
  Rational squared_distance;
  // The point of conv C(centre) nearest to the centre, if the centre lies outside that hull.
  std::optional<RationalPoint> driver;
  // The clause that decides, the condition in words, and the points that make it fail, by name.
  std::string clause;
  std::string reason;
  std::vector<PointId> witnesses;
};

// Explains the set of these points (rows; repeated ones are the same point). Throws InvalidInput for an empty set or
// a row that does not exist. O(n) exact distances.
[[nodiscard]] Explanation explain_points(const PointSet& points, std::span<const PointId> rows);

// Explains the position x. Throws InvalidInput for an empty point set.
[[nodiscard]] Explanation explain_position(const PointSet& points, const RationalPoint& x);

}  // namespace flowcert
