// Where claimed persistence pairs are not the right ones (FC-CLAIM-11).
//
// Guarantees: what is claimed exactly is compared exactly. Decimals are matched within the tolerance by a matching that
// leaves over as few pairs as possible, so that near values cannot take each other's place. Both lists are multisets.
// Pairs of length zero do not count.
#pragma once

#include <string>
#include <vector>

#include "flowcert/pair_claim.h"

namespace flowcert {

class FlowComplex;

// The pairs of positive length and the class that lasts, as persistence() finds them. This computes them if need be.
[[nodiscard]] std::vector<ListedPair> listed_pairs(const FlowComplex& complex);

// A pair that only one of the lists has, or two such pairs, one of each list.
struct PairDifference {
  std::string claimed;  // in words
  std::string truth;
  bool by_rounding = false;  // wrong by no more than rounding explains (FC-CLAIM-05)
};

// None iff the claim is right. tolerance: as in CheckOptions. Takes time in proportion to the product of the numbers of
// different pairs, if there are decimals.
[[nodiscard]] std::vector<PairDifference> pair_differences(const std::vector<ClaimedPair>& claimed,
                                                           const std::vector<ListedPair>& truth, double tolerance);

}  // namespace flowcert
