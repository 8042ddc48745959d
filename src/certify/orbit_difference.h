// Whether a claimed orbit is the right one (spec/formats/orbit.md). It is compared exactly.
#pragma once

#include <optional>
#include <string>

#include "certify/orbit_claim.h"
#include "certify/truth.h"
#include "flowcert/point_set.h"

namespace flowcert {

// The first place where a claimed orbit differs.
struct PathDifference {
  bool is_permitted = false;
  std::string claimed;  // in words
  std::string truth;
};

// Nothing iff the claimed orbit is the right one. If the right orbit ends at a regular stationary point, the claimed
// one may come there in a segment of another last letter or contact set, or go on from there as FC-CLAIM-08 says. That
// is a permitted difference. The points and their flow are asked for what comes after such a point.
[[nodiscard]] std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth,
                                                            const PointSet& points, Truth& flow);

}  // namespace flowcert
