// At each value, from one to the next, it is asked which components the critical points of this value have at their
// two sides. The components of one group, joined by these points, make a node.
#include "oracle/merge_tree.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "oracle/voronoi_graph.h"

namespace oracle {

namespace {

// A critical point that has parts of the tree at its two sides, each by one of its leaves.
struct Join {
  std::size_t point = 0;  // by place in the list of all
  std::size_t one = 0, other = 0;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(std::size_t leaves) : tree_{leaves, {}}, part_of_(leaves) {
    std::iota(part_of_.begin(), part_of_.end(), std::size_t{0});
  }

  bool are_joined(std::size_t leaf, std::size_t other) const { return part_of_[leaf] == part_of_[other]; }

  // Adds the nodes of one value. The joins are in the order of their points.
  void merge(const Rational& value, const std::vector<Join>& joins) {
    const std::vector<std::size_t> before = part_of_;
    std::vector<std::size_t> group = before;  // by leaf: the same number for parts that are joined
    for (const Join& join : joins) {
      std::replace(group.begin(), group.end(), std::size_t{group[join.one]}, std::size_t{group[join.other]});
    }
    std::map<std::size_t, std::set<std::size_t>> parts;  // by group
    for (std::size_t leaf = 0; leaf < tree_.leaves; ++leaf) parts[group[leaf]].insert(before[leaf]);
    for (const std::size_t own : group) {  // by the least leaf
      if (parts[own].size() < 2) continue;
      MergeNode node{value, {parts[own].begin(), parts[own].end()}, {}};
      for (const auto& [point, one, other] : joins) {
        if (group[one] == own && before[one] != before[other]) node.points.push_back(point);
      }
      for (std::size_t leaf = 0; leaf < tree_.leaves; ++leaf) {
        if (group[leaf] == own) part_of_[leaf] = tree_.leaves + tree_.nodes.size();
      }
      tree_.nodes.push_back(node);
      parts[own].clear();
    }
  }

  MergeTree tree() && { return std::move(tree_); }

 private:
  MergeTree tree_;
  std::vector<std::size_t> part_of_;  // by leaf
};

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
  std::map<Rational, std::vector<std::size_t>, std::greater<>> levels;  // index-2 points by value
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].is_critical() && all[k].hull_dimension == 2) levels[all[k].squared_distance].push_back(k);
  }
  for (const auto& [value, saddles] : levels) {
    const auto component = components_above(graph, value);
    std::map<std::size_t, std::size_t> leaf_in;  // by component: each has one (FC-TREE-01)
    for (const auto& [vertex, leaf] : leaf_of) {
      if (component[vertex]) leaf_in[*component[vertex]] = leaf;
    }
    std::vector<Join> joins;
    for (const std::size_t point : saddles) {
      const auto [one, other] = ends_of(graph, all[point]);
      joins.push_back({point, leaf_in.at(component[one].value()), leaf_in.at(component[other].value())});
    }
    builder.merge(value, joins);
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
      if (builder.are_joined(p, q)) continue;
      const std::vector<std::size_t> contact = {set.names[p], set.names[q]};
      const auto found = std::find_if(all.begin(), all.end(), [&](const auto& z) { return z.contact == contact; });
      if (found == all.end()) throw std::logic_error("samples whose balls meet first are no index-1 point");
      joins.push_back({static_cast<std::size_t>(found - all.begin()), p, q});
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
