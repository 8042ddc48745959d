// Where claimed persistence pairs are not the right ones (spec/formats/persistence.md).
//
// Guarantees: exact pairs are compared exactly, rounded ones by nearest doubles. Both are multisets, without
// the pairs of length zero.
#pragma once

#include <string>
#include <vector>

#include "flowcert/pair_claim.h"

namespace flowcert {

// A pair that only one of them has, or one that each of them has in place of the other's.
struct PairDifference {
  std::string claimed;  // in words
  std::string truth;
};

// None iff they are the same. If the claim is rounded, so is the truth before they are compared.
[[nodiscard]] std::vector<PairDifference> pair_differences(const PairList& claimed,
                                                           const std::vector<ListedPair>& truth);

}  // namespace flowcert
