// A limit has a greater value than the point below it, so that maxima above points are found from the greatest value
// down. A union-find structure finds the component of a part, and its latest part.
#include "flowcert/merge_trees.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::uint32_t kNoLeaf = MergeTree::kNone;

// A critical point with leaves at its two sides.
struct Join {
  std::uint32_t point, one, other;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(std::size_t leaves) : tree_{leaves, {}}, part_(leaves), sets_(leaves) {
    std::iota(part_.begin(), part_.end(), std::uint32_t{0});
    least_ = part_;
  }

  // Adds the nodes of one value. The joins are all of this value, in the order of their points.
  void merge(std::span<const Join> joins) {
    std::vector<std::array<std::uint32_t, 2>> sides;  // by join: the parts before this value
    for (const Join& join : joins) sides.push_back({sets_.find(join.one), sets_.find(join.other)});
    std::vector<std::uint32_t> joined;  // components before this value
    for (const auto& [one, other] : sides) {
      if (one != other) joined.insert(joined.end(), {one, other});
    }
    if (joined.empty()) return;
    keep_unique(joined);
    std::vector<std::uint32_t> parts, leasts;
    for (const std::uint32_t set : joined) parts.push_back(part_[set]), leasts.push_back(least_[set]);
    for (const auto& [one, other] : sides) {
      if (one != other) sets_.unite(one, other);
    }
    std::map<std::uint32_t, std::pair<std::uint32_t, MergeNode>> nodes;  // by component: its least leaf, and its node
    for (std::size_t k = 0; k < joined.size(); ++k) {
      auto& [least, node] = nodes.try_emplace(sets_.find(joined[k]), leasts[k], MergeNode{}).first->second;
      least = std::min(least, leasts[k]);
      node.parts.push_back(parts[k]);
    }
    for (std::size_t k = 0; k < joins.size(); ++k) {
      if (sides[k][0] != sides[k][1]) nodes.at(sets_.find(sides[k][0])).second.points.push_back(joins[k].point);
    }
    add(nodes);
  }

  MergeTree tree() && { return std::move(tree_); }

 private:
  void add(std::map<std::uint32_t, std::pair<std::uint32_t, MergeNode>>& nodes) {
    std::map<std::uint32_t, std::uint32_t> by_least;
    for (const auto& [set, node] : nodes) by_least[node.first] = set;
    for (const auto& [least, set] : by_least) {
      MergeNode& node = nodes.at(set).second;
      std::ranges::sort(node.parts);
      part_[set] = static_cast<std::uint32_t>(tree_.leaves + tree_.nodes.size());
      least_[set] = least;
      tree_.nodes.push_back(std::move(node));
    }
  }

  MergeTree tree_;
  std::vector<std::uint32_t> part_, least_;  // by the representative of a component
  DisjointSets sets_;
};

// Calls merge(joins) for each value. points come by value, and joins_of(point) is what is at its sides.
MergeTree tree_of(std::size_t leaves, std::span<const std::uint32_t> points, const SquaredDistances& distances,
                  const auto& join_of) {
  TreeBuilder builder(leaves);
  std::vector<Join> joins;
  for (std::size_t k = 0; k < points.size(); ++k) {
    joins.push_back(join_of(points[k]));
    if (k + 1 < points.size() && distances.rank(points[k + 1]) == distances.rank(points[k])) continue;
    builder.merge(joins);
    joins.clear();
  }
  return std::move(builder).tree();
}

}  // namespace

std::vector<std::uint32_t> MergeTree::parents() const {
  std::vector<std::uint32_t> result(leaves + nodes.size(), kNoLeaf);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    for (const std::uint32_t part : nodes[k].parts) result[part] = static_cast<std::uint32_t>(leaves + k);
  }
  return result;
}

std::vector<std::uint32_t> MergeTree::leaves_of(std::uint32_t part) const {
  std::vector<std::uint32_t> found, left{part};
  while (!left.empty()) {
    const std::uint32_t next = left.back();
    left.pop_back();
    if (next < leaves) {
      found.push_back(next);
    } else {
      const std::vector<std::uint32_t>& parts = nodes[next - leaves].parts;
      left.insert(left.end(), parts.begin(), parts.end());
    }
  }
  std::ranges::sort(found);
  return found;
}

MergeTrees::MergeTrees(const PointSet& points, const StationaryPoints& stationary, const FlowLimits& limits)
    : stationary_(&stationary), limits_(&limits), distances_(points, stationary) {
  const geometry::IeeeDoubles ieee;
  const RecordFinder finder(stationary);
  const auto [first, last] = finder.range({3, 3});
  first_maximum_ = first;
  maxima_ = last - first;
  list_of_.assign(stationary.size(), kNoLeaf);
  for (std::size_t i = 0; i < limits.size(); ++i) list_of_[limits.record(i)] = static_cast<std::uint32_t>(i);
  for (std::uint32_t record = 0; record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    if (index == StationaryIndex{2, 2}) saddles_down_.push_back(record);
    if (index.hull_dimension >= 2) upper_points_down_.push_back(record);
  }
  const auto downwards = [this](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t of_a = distances_.rank(a), of_b = distances_.rank(b);
    return of_a != of_b ? of_a > of_b : a < b;
  };
  std::ranges::sort(saddles_down_, downwards);
  std::ranges::sort(upper_points_down_, downwards);
  if (points.empty()) return;
  find_peaks();
  make_pockets();
  make_components();
}

std::vector<std::uint32_t> MergeTrees::limits_above(std::size_t record) const {
  std::vector<std::uint32_t> all;
  if (list_of_[record] == kNoLeaf) return all;
  for (const FlowLimits::Entry& entry : limits_->entries(list_of_[record])) all.push_back(entry.limit);
  keep_unique(all);
  return all;
}

std::span<const std::uint32_t> MergeTrees::peaks_of_limit(std::uint32_t limit) const {
  return sets_[limit == FlowLimits::Entry::kInfinity ? maxima_ : set_of_[limit]];
}

std::vector<std::uint32_t> MergeTrees::peaks_above(std::size_t record) const {
  if (set_of_[record] != kNoLeaf) return sets_[set_of_[record]];
  std::vector<std::uint32_t> all;
  for (const std::uint32_t limit : limits_above(record)) {
    const auto some = peaks_of_limit(limit);
    all.insert(all.end(), some.begin(), some.end());
  }
  keep_unique(all);
  return all;
}

std::array<std::span<const std::uint32_t>, 2> MergeTrees::peaks_above_sides(std::size_t record) const {
  const auto entries = limits_->entries(list_of_[record]);
  return {peaks_of_limit(entries[0].limit), peaks_of_limit(entries[1].limit)};
}

void MergeTrees::find_peaks() {
  set_of_.assign(stationary_->size(), kNoLeaf);
  std::map<std::vector<std::uint32_t>, std::uint32_t> number_of;
  for (std::uint32_t leaf = 0; leaf <= maxima_; ++leaf) sets_.push_back({leaf});
  const auto set_of = [&](std::vector<std::uint32_t> leaves) {
    if (leaves.size() == 1) return leaves.front();
    const auto [found, is_new] = number_of.try_emplace(leaves, static_cast<std::uint32_t>(sets_.size()));
    if (is_new) sets_.push_back(std::move(leaves));
    return found->second;
  };
  for (const std::uint32_t record : upper_points_down_) {
    const bool is_maximum = record >= first_maximum_ && record < first_maximum_ + maxima_;
    set_of_[record] = is_maximum ? static_cast<std::uint32_t>(record - first_maximum_) : set_of(peaks_above(record));
  }
}

void MergeTrees::make_pockets() {
  pockets_ = tree_of(maxima_ + 1, saddles_down_, distances_, [this](std::uint32_t saddle) {
    const auto sides = peaks_above_sides(saddle);
    return Join{saddle, sides[0].front(), sides[1].front()};
  });
}

// Samples are first in the list, in the order of their names.
void MergeTrees::make_components() {
  std::vector<std::uint32_t> midpoints;
  std::vector<PointId> names;
  for (std::uint32_t record = 0; record < stationary_->size(); ++record) {
    const StationaryIndex index = stationary_->index(record);
    if (index == StationaryIndex{0, 0}) names.push_back(stationary_->contact(record).front());
    if (index == StationaryIndex{1, 1}) midpoints.push_back(record);
  }
  std::ranges::sort(midpoints, {}, [this](std::uint32_t m) { return std::pair(distances_.rank(m), m); });
  const auto leaf_of = [&](PointId name) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(names, name) - names.begin());
  };
  components_ = tree_of(names.size(), midpoints, distances_, [&](std::uint32_t midpoint) {
    const auto contact = stationary_->contact(midpoint);
    return Join{midpoint, leaf_of(contact[0]), leaf_of(contact[1])};
  });
}

}  // namespace flowcert
