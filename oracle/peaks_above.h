// The maxima above each stationary point: those to which the flow can go on from it (FC-POCK-01).
//
// They are read from the λ-lists alone. Infinity counts as a maximum. Exact, for any finite point set of any dimension.
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// Maxima by their ordinal among the maxima, infinity behind all of them: the leaves of superlevel_tree().
using Peaks = std::set<std::size_t>;

struct PeaksAbove {
  // By place in the list of all. For samples, above which there is all that is beside them, nothing is listed.
  std::vector<Peaks> of;
  // For critical points of index 2, those above the limit of side 0 and of side 1; else empty.
  std::vector<std::array<Peaks, 2>> of_sides;
};

// `all` has all stationary points in the order of FC-OUT-02.
PeaksAbove peaks_above(const PointSet& set, const std::vector<StationaryPoint>& all);

}  // namespace oracle
