// The merge trees of the distance function: of its maxima and infinity, and of the samples (FC-TREE-01 to 06).
//
// The first one says how the components of {d^2 > a} come together as a falls. It is made from the Voronoi graph, so
// that no flow and no persistence enters. The second one does it for {d^2 <= a} as a grows. It is made from the
// distances of all pairs of samples. Any number of components may come together at one value. Exact.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// Parts that become one at a value. A part is a leaf, by its number, or an earlier node: then its number is the number
// of leaves and its place in the list of nodes.
struct MergeNode {
  Rational value;
  std::vector<std::size_t> parts;   // two at least, ascending
  std::vector<std::size_t> points;  // the critical points that join them, by place in the list of all, ascending

  friend bool operator==(const MergeNode&, const MergeNode&) = default;
};

// Nodes come in the order of merging. Of one value, the node with the least leaf comes first.
struct MergeTree {
  std::size_t leaves = 0;
  std::vector<MergeNode> nodes;

  friend bool operator==(const MergeTree&, const MergeTree&) = default;
};

// Where the maxima of `all` are in it. `all` has all stationary points in the order of FC-OUT-02, here and below.
std::vector<std::size_t> maxima_places(const std::vector<StationaryPoint>& all);

// The leaves are the maxima, in their order, and infinity as the last one. The empty set has no leaf.
MergeTree superlevel_tree(const PointSet& set, const std::vector<StationaryPoint>& all);

// The leaves are the samples, in their order.
MergeTree sublevel_tree(const PointSet& set, const std::vector<StationaryPoint>& all);

// The leaves of a part, ascending.
std::vector<std::size_t> leaves_of(const MergeTree& tree, std::size_t part);

// The value of the first node that has both leaves. They must differ. Nothing iff no node has both, which does not
// occur in the two trees above.
std::optional<Rational> joining_value(const MergeTree& tree, std::size_t leaf, std::size_t other);

}  // namespace oracle
