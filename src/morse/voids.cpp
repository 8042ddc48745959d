#include "flowcert/voids.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "morse/layer.h"
#include "morse/part_with.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

template <class LeavesOf>
Voids::ByLeaf Voids::by_leaf(const LeavesOf& leaves_of) const {
  ByLeaf found;
  found.first.resize(trees_->pockets().leaves + 1);
  const auto size = static_cast<std::uint32_t>(trees_->stationary().size());
  for (std::uint32_t record = 0; record < size; ++record) {
    for (const std::uint32_t leaf : leaves_of(record)) ++found.first[leaf + 1];
  }
  std::partial_sum(found.first.begin(), found.first.end(), found.first.begin());
  if (found.first.empty()) return found;
  found.records.resize(found.first.back());
  std::vector<std::size_t> next(found.first.begin(), found.first.end() - 1);
  for (std::uint32_t record = 0; record < size; ++record) {
    for (const std::uint32_t leaf : leaves_of(record)) found.records[next[leaf]++] = record;
  }
  return found;
}

Voids::Voids(const MergeTrees& trees) : trees_(&trees), parents_(trees.pockets().parents()) {
  of_least_leaf_ = by_leaf([&](std::uint32_t record) {
    std::vector<std::uint32_t> leaves = trees.peaks_above(record);
    if (leaves.size() > 1) leaves.erase(leaves.begin() + 1, leaves.end());
    return leaves;
  });
  saddles_between_ = by_leaf([&](std::uint32_t record) {
    if (trees.stationary().index(record) != StationaryIndex{2, 2}) return std::vector<std::uint32_t>{};
    std::vector<std::uint32_t> leaves = trees.peaks_above(record);
    if (leaves.size() < 2) leaves.clear();
    return leaves;
  });
}

Void Voids::at(std::uint32_t maximum, const SquaredLevel& level) const {
  const geometry::IeeeDoubles ieee;
  const std::size_t first = trees_->record_of(0);
  if (maximum < first || maximum - first >= trees_->maxima()) throw std::invalid_argument("a void without a maximum");
  const MergeTree& tree = trees_->pockets();
  const std::uint32_t part = part_with(
      maximum - static_cast<std::uint32_t>(first), tree, parents_,
      [&](const MergeNode& node) { return trees_->squared_distances().compare(node.points.front(), level) > 0; });
  const std::vector<std::uint32_t> leaves = tree.leaves_of(part);
  if (leaves.back() == trees_->maxima()) throw std::invalid_argument("a void that is unbounded");
  const auto is_inside = [&](std::uint32_t leaf) { return std::ranges::binary_search(leaves, leaf); };
  Void found;
  for (const std::uint32_t leaf : leaves) {
    found.maxima.push_back(static_cast<std::uint32_t>(trees_->record_of(leaf)));
    for (const std::uint32_t record : of_least_leaf_[leaf]) {
      if (std::ranges::all_of(trees_->peaks_above(record), is_inside)) found.cell.push_back(record);
    }
    for (const std::uint32_t saddle : saddles_between_[leaf]) {
      if (!std::ranges::all_of(trees_->peaks_above(saddle), is_inside)) found.walls.push_back(saddle);
    }
  }
  std::ranges::sort(found.cell);
  keep_unique(found.walls);
  return found;
}

std::array<std::vector<std::uint32_t>, 2> components_at(const MergeTrees& trees, std::uint32_t saddle) {
  const geometry::IeeeDoubles ieee;
  if (trees.stationary().index(saddle) != StationaryIndex{1, 1}) {
    throw std::invalid_argument("components at a point that is not of index 1");
  }
  const MergeTree& tree = trees.components();
  const std::vector<std::uint32_t> parents = tree.parents();
  const SquaredDistances& values = trees.squared_distances();
  const auto contact = trees.stationary().contact(saddle);
  const RecordFinder samples(trees.stationary());
  std::array<std::vector<std::uint32_t>, 2> found;
  for (const std::size_t side : {0U, 1U}) {
    const auto leaf = static_cast<std::uint32_t>(*samples.find({0, 0}, contact.subspan(side, 1)));
    const std::uint32_t part = part_with(leaf, tree, parents, [&](const MergeNode& node) {
      return values.rank(node.points.front()) < values.rank(saddle);
    });
    found[side] = tree.leaves_of(part);
  }
  return found;
}

}  // namespace flowcert
