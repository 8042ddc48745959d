// Whether a claimed orbit is the right one (spec/formats/orbit.md). It is compared exactly.
#pragma once

#include <optional>
#include <string>

#include "flowcert/orbit_claim.h"

namespace flowcert {

// The first place where a claimed orbit differs.
struct PathDifference {
  bool is_permitted = false;
  std::string claimed;  // in words
  std::string truth;
};

// Nothing iff the claimed orbit is the right one. If the right orbit ends at a regular stationary point, the claimed
// one may arrive there in another way, or go on from there. That is a permitted difference.
[[nodiscard]] std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth);

}  // namespace flowcert
