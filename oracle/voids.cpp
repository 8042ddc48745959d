// A part of a tree grows node by node, in the order of merging, as long as the nodes come before the level.
#include "oracle/voids.h"

#include <algorithm>

namespace oracle {

namespace {

// The leaves that have come together with one, by the nodes that are wanted.
template <typename IsWanted>
std::vector<std::size_t> joined_with(std::size_t leaf, const MergeTree& tree, const IsWanted& is_wanted) {
  std::size_t part = leaf;
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    const auto& parts = tree.nodes[k].parts;
    if (is_wanted(tree.nodes[k].value) && std::find(parts.begin(), parts.end(), part) != parts.end()) {
      part = tree.leaves + k;
    }
  }
  return leaves_of(tree, part);
}

}  // namespace

Void void_at(const std::vector<StationaryPoint>& all, const MergeTree& tree, const PeaksAbove& above,
             std::size_t maximum, const Rational& level) {
  const std::vector<std::size_t> maxima = maxima_places(all);
  const auto leaf = static_cast<std::size_t>(std::find(maxima.begin(), maxima.end(), maximum) - maxima.begin());
  const std::vector<std::size_t> leaves = joined_with(leaf, tree, [&](const Rational& value) { return value > level; });
  const auto is_inside = [&](std::size_t peak) { return std::binary_search(leaves.begin(), leaves.end(), peak); };
  Void found;
  for (const std::size_t inside : leaves) found.maxima.push_back(maxima[inside]);
  for (std::size_t place = 0; place < all.size(); ++place) {
    const Peaks& peaks = above.of[place];
    if (peaks.empty() || !std::any_of(peaks.begin(), peaks.end(), is_inside)) continue;
    if (std::all_of(peaks.begin(), peaks.end(), is_inside)) {
      found.cell.push_back(place);
    } else if (all[place].is_critical() && all[place].hull_dimension == 2) {
      found.walls.push_back(place);
    }
  }
  return found;
}

std::array<std::vector<std::size_t>, 2> components_at(const PointSet& set, const MergeTree& tree,
                                                      const StationaryPoint& saddle) {
  const std::vector<std::size_t> ends = places_of(set, saddle.contact);
  const auto is_before = [&](const Rational& value) { return value < saddle.squared_distance; };
  return {joined_with(ends[0], tree, is_before), joined_with(ends[1], tree, is_before)};
}

}  // namespace oracle
