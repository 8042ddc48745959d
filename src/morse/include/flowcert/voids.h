// The voids that stand for persistence pairs of dimension 2, and the components that stand for those of dimension 0.
//
// Guarantees: exact, on every input. A void at a level is a component of {d^2 > level} that is bounded, by its maxima,
// with the cell of these as a pocket has one. A component is told by its samples. Numbers of stationary points are
// places in the list. Source: spec section 18 (clauses FC-CYC).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/merge_trees.h"
#include "flowcert/rational.h"

namespace flowcert {

struct Void {
  std::vector<std::uint32_t> maxima;  // ascending, here and below
  std::vector<std::uint32_t> cell;    // the stationary points whose stable sets make the void (FC-POCK-03)
  std::vector<std::uint32_t> walls;   // index-2 points above which there are maxima of it, and others (FC-POCK-04)

  friend bool operator==(const Void&, const Void&) = default;
};

// Const access is safe from several threads.
class Voids {
 public:
  // The trees must outlive this. O(n), but for the sets of maxima above one point (MergeTrees).
  explicit Voids(const MergeTrees& trees);

  // The component of {d^2 > level} that has the maximum. The level is a squared distance, at least that of the birth of
  // the maximum's pair and less than that of the maximum. Throws std::invalid_argument for a point that is no maximum,
  // and where the component is unbounded. O(k log k), for the points above which maxima of it are.
  [[nodiscard]] Void at(std::uint32_t maximum, const SquaredLevel& level) const;

 private:
  // Stationary points by the leaves above them.
  struct ByLeaf {
    std::vector<std::size_t> first;
    std::vector<std::uint32_t> records;

    [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t leaf) const {
      return std::span(records).subspan(first[leaf], first[leaf + 1] - first[leaf]);
    }
  };
  template <class LeavesOf>
  [[nodiscard]] ByLeaf by_leaf(const LeavesOf& leaves_of) const;

  const MergeTrees* trees_;
  std::vector<std::uint32_t> parents_;
  ByLeaf of_least_leaf_;    // all that are no samples, by the least leaf above each
  ByLeaf saddles_between_;  // index-2 points with several leaves above, by each of these
};

// The samples of the two components of {d^2 < s} that an index-1 point of value s has at its ends, as places in the
// list. Both ascend, and the first has the lesser one of the two samples. Throws std::invalid_argument for another
// point. O(samples of both, and nodes of the tree).
[[nodiscard]] std::array<std::vector<std::uint32_t>, 2> components_at(const MergeTrees& trees, std::uint32_t saddle);

}  // namespace flowcert
