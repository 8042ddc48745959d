// Guarantees: which part of a merge tree a leaf is in, below or above a value.
#pragma once

#include <cstdint>
#include <vector>

#include "flowcert/merge_trees.h"

namespace flowcert::morse {

// The last part of a tree that has the leaf, through nodes that join it before a level. parents: of the tree.
template <class IsBefore>
[[nodiscard]] std::uint32_t part_with(std::uint32_t leaf, const MergeTree& tree,
                                      const std::vector<std::uint32_t>& parents, const IsBefore& is_before) {
  std::uint32_t part = leaf;
  while (parents[part] != MergeTree::kNone && is_before(tree.nodes[parents[part] - tree.leaves])) part = parents[part];
  return part;
}

}  // namespace flowcert::morse
