// At each value, from one to the next, it is asked which components the critical points of this value have at their
// two sides. The components of one group, joined by these points, make a node.
#include "oracle/merge_tree.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "oracle/voronoi_graph.h"

namespace oracle {

namespace {

// A critical point that has parts of the tree at its two sides.
struct Join {
  std::size_t point = 0;  // by place in the list of all
  std::size_t one = 0, other = 0;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(std::size_t leaves) : tree_{leaves, {}} {
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) part_of_.push_back(leaf);
  }

  // The part that has the leaf by now.
  std::size_t part_of(std::size_t leaf) const { return part_of_[leaf]; }

  // Adds the nodes of one value. The joins are in the order of their points.
  void merge(const Rational& value, const std::vector<Join>& joins) {
    std::map<std::size_t, std::size_t> group;  // of a part: the least part that it is joined to
    for (const Join& join : joins) {
      const std::size_t one = group.try_emplace(join.one, join.one).first->second;
      const std::size_t other = group.try_emplace(join.other, join.other).first->second;
      for (auto& [part, least] : group) least = least == std::max(one, other) ? std::min(one, other) : least;
    }
    std::map<std::size_t, MergeNode> nodes;  // by the least leaf
    std::map<std::size_t, std::size_t> least_leaf;
    for (std::size_t leaf = tree_.leaves; leaf-- > 0;) {
      const auto found = group.find(part_of_[leaf]);
      if (found != group.end()) least_leaf[found->second] = leaf;
    }
    for (const auto& [part, least] : group) nodes[least_leaf.at(least)].parts.push_back(part);
    for (const Join& join : joins) {
      if (join.one != join.other) nodes[least_leaf.at(group.at(join.one))].points.push_back(join.point);
    }
    for (auto& [leaf, node] : nodes) {
      if (node.parts.size() > 1) add(value, std::move(node));
    }
  }

  MergeTree tree() && { return std::move(tree_); }

 private:
  void add(const Rational& value, MergeNode node) {
    node.value = value;
    const std::size_t number = tree_.leaves + tree_.nodes.size();
    for (std::size_t& part : part_of_) {
      if (std::binary_search(node.parts.begin(), node.parts.end(), part)) part = number;
    }
    tree_.nodes.push_back(std::move(node));
  }

  MergeTree tree_;
  std::vector<std::size_t> part_of_;  // by leaf
};

// The critical points of an index, by value.
std::map<Rational, std::vector<std::size_t>> by_value(const std::vector<StationaryPoint>& all, int index) {
  std::map<Rational, std::vector<std::size_t>> result;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].is_critical() && all[k].hull_dimension == index) result[all[k].squared_distance].push_back(k);
  }
  return result;
}

// The Voronoi vertices, or infinity, at the two ends of the Voronoi edge of an index-2 point.
std::array<std::size_t, 2> ends_of(const VoronoiGraph& graph, const StationaryPoint& z) {
  for (const VoronoiEdge& edge : graph.edges) {
    if (edge.polygon == z.contact) return {edge.from, edge.to.value_or(graph.infinity())};
  }
  return {graph.infinity(), graph.infinity()};  // P spans a plane
}

// The leaf at each vertex that is a maximum, and at infinity.
std::map<std::size_t, std::size_t> leaf_of_vertex(const VoronoiGraph& graph, const std::vector<StationaryPoint>& all) {
  std::map<std::size_t, std::size_t> leaf_of;
  const std::vector<std::size_t> maxima = maxima_places(all);
  for (std::size_t leaf = 0; leaf < maxima.size(); ++leaf) {
    const auto found = std::find_if(graph.vertices.begin(), graph.vertices.end(),
                                    [&](const VoronoiVertex& v) { return v.contact == all[maxima[leaf]].contact; });
    if (found == graph.vertices.end()) throw std::logic_error("a maximum is no Voronoi vertex");
    leaf_of[static_cast<std::size_t>(found - graph.vertices.begin())] = leaf;
  }
  leaf_of[graph.infinity()] = maxima.size();
  return leaf_of;
}

}  // namespace

std::vector<std::size_t> maxima_places(const std::vector<StationaryPoint>& all) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].face_dimension == 3) places.push_back(k);
  }
  return places;
}

MergeTree superlevel_tree(const PointSet& set, const std::vector<StationaryPoint>& all) {
  if (set.points.empty()) return {};
  const VoronoiGraph graph = voronoi_graph(set);
  const auto leaf_of = leaf_of_vertex(graph, all);
  TreeBuilder builder(leaf_of.size());
  const auto saddles = by_value(all, 2);
  for (auto level = saddles.rbegin(); level != saddles.rend(); ++level) {
    const auto component = components_above(graph, level->first);
    std::map<std::size_t, std::size_t> part_of;  // by component: each has a leaf (FC-TREE-01)
    for (const auto& [vertex, leaf] : leaf_of) {
      if (component[vertex]) part_of[*component[vertex]] = builder.part_of(leaf);
    }
    std::vector<Join> joins;
    for (const std::size_t point : level->second) {
      const auto [one, other] = ends_of(graph, all[point]);
      joins.push_back({point, part_of.at(component[one].value()), part_of.at(component[other].value())});
    }
    builder.merge(level->first, joins);
  }
  return std::move(builder).tree();
}

// The ball around p of squared radius a meets that around q iff |p - q|^2 <= 4 a. The balls' union is {d^2 <= a}.
MergeTree sublevel_tree(const PointSet& set, const std::vector<StationaryPoint>& all) {
  std::map<Rational, std::vector<std::array<std::size_t, 2>>> pairs;  // by the value at which the balls meet
  for (std::size_t p = 0; p < set.points.size(); ++p) {
    for (std::size_t q = p + 1; q < set.points.size(); ++q) {
      pairs[squared_distance(set.points[p], set.points[q]) / 4].push_back({p, q});
    }
  }
  TreeBuilder builder(set.points.size());
  for (const auto& [value, meeting] : pairs) {
    std::vector<Join> joins;
    for (const auto& [p, q] : meeting) {
      if (builder.part_of(p) == builder.part_of(q)) continue;
      const std::vector<std::size_t> contact = {set.names[p], set.names[q]};
      const auto found = std::find_if(all.begin(), all.end(), [&](const auto& z) { return z.contact == contact; });
      if (found == all.end()) throw std::logic_error("samples whose balls meet first are no index-1 point");
      joins.push_back({static_cast<std::size_t>(found - all.begin()), builder.part_of(p), builder.part_of(q)});
    }
    std::sort(joins.begin(), joins.end(), [](const Join& a, const Join& b) { return a.point < b.point; });
    builder.merge(value, joins);
  }
  return std::move(builder).tree();
}

std::vector<std::size_t> leaves_of(const MergeTree& tree, std::size_t part) {
  if (part < tree.leaves) return {part};
  std::vector<std::size_t> leaves;
  for (const std::size_t below : tree.nodes[part - tree.leaves].parts) {
    const std::vector<std::size_t> more = leaves_of(tree, below);
    leaves.insert(leaves.end(), more.begin(), more.end());
  }
  std::sort(leaves.begin(), leaves.end());
  return leaves;
}

std::optional<Rational> joining_value(const MergeTree& tree, std::size_t leaf, std::size_t other) {
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    const std::vector<std::size_t> leaves = leaves_of(tree, tree.leaves + k);
    const auto has = [&](std::size_t l) { return std::binary_search(leaves.begin(), leaves.end(), l); };
    if (has(leaf) && has(other)) return tree.nodes[k].value;
  }
  return std::nullopt;
}

}  // namespace oracle
