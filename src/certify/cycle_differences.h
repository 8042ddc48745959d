// Where claimed cycles do not stand for their pairs, and which pairs of a whole claim have none (FC-CLAIM-25).
//
// Guarantees: exact, but for which pair is meant by decimals, which is decided within the tolerance. A claim is matched
// with a pair of which it is right, where there is one.
#pragma once

#include <vector>

#include "certify/cycle_claim.h"
#include "certify/pair_differences.h"

namespace flowcert {

// Whether no decimal is claimed.
[[nodiscard]] bool is_exact_claim(const CycleClaim& claim);

// None iff the claim is right. tolerance: as in CheckOptions. O(points) for each claimed edge that is no index-1 point,
// and a column of the reduction for each pair in a loop.
[[nodiscard]] std::vector<PairDifference> cycle_differences(const FlowComplex& complex, const CycleClaim& claim,
                                                            double tolerance);

}  // namespace flowcert
