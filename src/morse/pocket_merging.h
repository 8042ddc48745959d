// Merges maxima into pockets, from the greatest value of an index-2 point down (FC-POCK-02).
//
// Guarantees: exact. Bounds decide most comparisons with the persistence, exact values the others.
#pragma once

#include <cstdint>
#include <vector>

#include "flowcert/merge_trees.h"
#include "morse/layer.h"

namespace flowcert::morse {

// By leaf of the tree of pockets: the number of its pocket. Pockets are numbered by their first leaves, but the one of
// infinity is the last. O(n log n) but for sets of maxima.
[[nodiscard]] std::vector<std::uint32_t> pocket_numbers(const MergeTrees& trees, const Rational& squared_persistence);

}  // namespace flowcert::morse
