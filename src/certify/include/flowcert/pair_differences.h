// Where claimed persistence pairs are not the right ones (spec/formats/persistence.md).
//
// Guarantees: exact pairs are compared exactly, rounded pairs by nearest doubles. Both lists are multisets. Pairs of
// length zero do not count.
#pragma once

#include <string>
#include <vector>

#include "flowcert/pair_claim.h"

namespace flowcert {

// A pair that only one of the lists has, or two such pairs, one of each list.
struct PairDifference {
  std::string claimed;  // in words
  std::string truth;
};

// None iff the lists are the same. If the claim is rounded, the truth is rounded before the comparison.
[[nodiscard]] std::vector<PairDifference> pair_differences(const PairList& claimed,
                                                           const std::vector<ListedPair>& truth);

}  // namespace flowcert
