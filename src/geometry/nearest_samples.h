// The samples nearest to a position, by a scan of all of them.
//
// Guarantees: exact. One scan in double precision comes first. Exact arithmetic compares the samples that it cannot
// tell apart.
#pragma once

#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::geometry {

// C(x) by name, ascending, and d(x)^2 (FC-DIST-01).
struct NearestSamples {
  std::vector<PointId> names;
  Rational squared_distance;
};
// There must be at least one point.
[[nodiscard]] NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x);

}  // namespace flowcert::geometry
