// Voids, and components that come together: what persistence pairs of dimension 2 and 0 stand for (FC-CYC-06, 07). They
// are read from the merge trees. Points are named by their places in the list of all stationary points. Exact.
#pragma once

#include <array>
#include <vector>

#include "oracle/connections.h"
#include "oracle/merge_tree.h"

namespace oracle {

// All lists ascend.
struct Void {
  std::vector<std::size_t> maxima;
  std::vector<std::size_t> cell;   // the stationary points whose stable sets make it (FC-POCK-03)
  std::vector<std::size_t> walls;  // index-2 points above which there are maxima of it, and others (FC-POCK-04)

  friend bool operator==(const Void&, const Void&) = default;
};

// The component of {d^2 > level} that has the maximum. The level is less than its value. The tree is
// superlevel_tree(), and `above` is peaks_above().
Void void_at(const std::vector<StationaryPoint>& all, const MergeTree& tree, const PeaksAbove& above,
             std::size_t maximum, const Rational& level);

// The samples of the components of {d^2 < s} that have the two samples of an index-1 point of value s, by their places
// in the point set. The tree is sublevel_tree().
std::array<std::vector<std::size_t>, 2> components_at(const PointSet& set, const MergeTree& tree,
                                                      const StationaryPoint& saddle);

}  // namespace oracle
