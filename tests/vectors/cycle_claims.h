// Claims of cycles for the vectors, right and wrong ones, and what a judge says of them (FC-CLAIM-25).
//
// Guarantees: loops and their reasons come from the Čech filtration, and voids and components from the oracle's merge
// trees. Which claims there are follows from the points alone.
#pragma once

#include <string>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle::vectors {

struct CycleClaim {
  std::vector<std::string> lines;    // FC-FILE-53
  std::vector<std::string> reasons;  // ascending, each once; none for a right claim
};
std::vector<CycleClaim> cycle_claims(const PointSet& set, const std::vector<StationaryPoint>& all);

}  // namespace oracle::vectors
