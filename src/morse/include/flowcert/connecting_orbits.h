// The connecting orbits of a stable set: how its stationary point and the critical points of index 1 are
// joined (FC-STAB-06; paper, section 6: their lengths are n_S2).
//
// Guarantees: exact, as the set is. Every point flows one way only, so there is one orbit for each back that
// is critical.
#pragma once

#include <cstddef>
#include <vector>

#include "flowcert/stable_manifolds.h"

namespace flowcert {

// Each as places of its segments in set.segments, against the flow: from the stationary point down to the
// critical point of index 1. In the order of their last segments. Of a set with intervals, through which
// orbits come as well, those that come through segments alone. O(n log n) for n segments, with the lengths.
[[nodiscard]] std::vector<std::vector<std::size_t>> connecting_orbits(const StableSet& set,
                                                                      const RationalPoint& stationary);

}  // namespace flowcert
