// How the pockets and the components of the distance function come together (spec clauses FC-TREE), and which maxima
// there are above each stationary point (FC-POCK-01).
//
// Guarantees: exact, on every input; any number of parts may come together at one value. Both trees are read from where
// directions of stationary points lead, and no persistence enters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/flow_limits.h"
#include "flowcert/squared_distances.h"

namespace flowcert {

// Parts that become one at one value, which is that of its points. A part is a leaf, by its number, or an earlier node:
// then its number is the number of leaves and the node's place in the list.
struct MergeNode {
  std::vector<std::uint32_t> parts;   // two at least, ascending
  std::vector<std::uint32_t> points;  // what joins them: places in the list of stationary points, ascending

  friend bool operator==(const MergeNode&, const MergeNode&) = default;
};

// Nodes come in the order of merging. Of one value, the node with the least leaf comes first (FC-TREE-07).
struct MergeTree {
  std::size_t leaves = 0;
  std::vector<MergeNode> nodes;

  // The node that a part goes into, by its number as a part; kNone for a part that goes into none. O(parts).
  static constexpr std::uint32_t kNone = 0xffffffffu;
  [[nodiscard]] std::vector<std::uint32_t> parents() const;
  // Those that come together in a part, ascending. O(k log k) for k of them.
  [[nodiscard]] std::vector<std::uint32_t> leaves_of(std::uint32_t part) const;

  friend bool operator==(const MergeTree&, const MergeTree&) = default;
};

// Const access is safe from several threads.
class MergeTrees {
 public:
  // All are of one diagram and must outlive this. O(n log n) but for the sets of maxima, which can be larger where
  // the flow from regular stationary points or from index-2 points ends at others than maxima.
  MergeTrees(const PointSet& points, const StationaryPoints& stationary, const FlowLimits& limits);

  // The leaves are the maxima, in the order of the list, and infinity as the last one. The empty set has no leaf.
  [[nodiscard]] const MergeTree& pockets() const { return pockets_; }
  // The leaves are the samples, in the order of the list.
  [[nodiscard]] const MergeTree& components() const { return components_; }

  [[nodiscard]] const SquaredDistances& squared_distances() const { return distances_; }
  [[nodiscard]] const StationaryPoints& stationary() const { return *stationary_; }

  // Leaves of the tree of pockets: maxima and infinity.
  [[nodiscard]] std::size_t maxima() const { return maxima_; }
  [[nodiscard]] std::size_t record_of(std::size_t leaf) const { return first_maximum_ + leaf; }

  // The leaves above a stationary point, ascending. There are none above a sample.
  [[nodiscard]] std::vector<std::uint32_t> peaks_above(std::size_t record) const;
  // The leaves above side 0 and side 1 of an index-2 point (FC-FLOW-07), ascending.
  [[nodiscard]] std::array<std::span<const std::uint32_t>, 2> peaks_above_sides(std::size_t record) const;
  // The limits above a record, without repetition: places in the list, or FlowLimits::Entry::kInfinity. None above
  // samples and maxima.
  [[nodiscard]] std::vector<std::uint32_t> limits_above(std::size_t record) const;

  // The critical points of index 2, from the greatest value down; of one value, in the order of the list.
  [[nodiscard]] std::span<const std::uint32_t> saddles_down() const { return saddles_down_; }
  // Stationary points other than samples and index-1 points, from the greatest value down.
  [[nodiscard]] std::span<const std::uint32_t> upper_points_down() const { return upper_points_down_; }

 private:
  [[nodiscard]] std::span<const std::uint32_t> peaks_of_limit(std::uint32_t limit) const;
  void find_peaks();
  void make_pockets();
  void make_components();

  const StationaryPoints* stationary_;
  const FlowLimits* limits_;
  SquaredDistances distances_;
  std::size_t first_maximum_ = 0, maxima_ = 0;
  std::vector<std::uint32_t> list_of_;  // by record: the number of its λ-list
  std::vector<std::uint32_t> saddles_down_, upper_points_down_;
  // Sets of leaves are kept once each. Set k < leaves has leaf k alone.
  std::vector<std::vector<std::uint32_t>> sets_;
  std::vector<std::uint32_t> set_of_;  // by record; kNone for samples and index-1 points
  MergeTree pockets_, components_;
};

}  // namespace flowcert
