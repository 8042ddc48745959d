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

// Nothing iff it is the right one. One that comes to the regular stationary point where the right one ends
// may go on from there, or come to it in another way: that is a permitted difference.
[[nodiscard]] std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth);

}  // namespace flowcert
