// What a judge needs to know of a case to judge incidences (FC-CLAIM-06, 07, 09): where orbits end, and what bounds
// stable sets.
//
// Guarantees: exact, as the oracle finds it. All orbits and stable sets of index-2 points are computed once.
#pragma once

#include <vector>

#include "oracle/point_set.h"
#include "oracle/program/answer_fields.h"
#include "oracle/stationary_points.h"

namespace oracle::vectors {

// One value for each stationary point, in the order of the list. It is null for a point of which nothing is told.
// An object of an index-2 point has `limits`, `ends` and `boundary`.
// An object of an index-1 point to which no connecting orbit comes down has `limits` (spec/formats/vectors.md).
std::vector<Json> incidences(const PointSet& set, const std::vector<StationaryPoint>& all);

}  // namespace oracle::vectors
