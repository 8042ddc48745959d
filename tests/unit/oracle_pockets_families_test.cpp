// Merge trees and pockets by the oracle, on small inputs of all families.
//
// The trees come from Voronoi edges and from distances of samples. They are held to the flow, to the persistence pairs
// of the Čech filtration, to straight paths, and to the numbers of critical points. Pockets are held to the tree, to
// each other at several persistences, and to those of moved and permuted samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

#include "oracle/connections.h"
#include "oracle/merge_tree.h"
#include "oracle/persistence.h"
#include "oracle/pockets.h"
#include "oracle/voronoi_graph.h"
#include "tests/cites.h"
#include "tests/unit/landscape_inputs.h"

namespace oracle::oracle_pockets_families_test {
namespace {

using Subject = LandscapeSubject;

// Of all pairs of leaves: the value at which what is above the two sides of index-2 points comes together, going down.
std::map<std::array<std::size_t, 2>, Rational> joining_by_flow(const Subject& subject, const PeaksAbove& above) {
  std::vector<std::size_t> places, part(subject.infinity() + 1);
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (std::size_t k = 0; k < subject.all.size(); ++k) {
    if (!above.of_sides[k][0].empty()) places.push_back(k);
  }
  std::ranges::sort(places, std::greater<>(), [&](std::size_t k) { return subject.all[k].squared_distance; });
  std::map<std::array<std::size_t, 2>, Rational> joining;
  for (const std::size_t place : places) {
    for (const std::size_t leaf : above.of[place]) {
      const std::size_t from = part[leaf], to = part[*above.of[place].begin()];
      if (from == to) continue;
      for (std::size_t a = 0; a < part.size(); ++a) {
        for (std::size_t b = 0; b < part.size(); ++b) {
          if (part[a] == from && part[b] == to) {
            joining[{std::min(a, b), std::max(a, b)}] = subject.all[place].squared_distance;
          }
        }
      }
      std::replace(part.begin(), part.end(), from, to);
    }
  }
  return joining;
}

// The flow and the Voronoi graph tell one tree. What is above one side of an index-2 point is together above it.
void expect_tree_of_flow(const Subject& subject, const PeaksAbove& above) {
  const auto joining = joining_by_flow(subject, above);
  const std::size_t leaves = subject.infinity() + 1;
  EXPECT_EQ(joining.size(), leaves * (leaves - 1) / 2);
  for (const auto& [pair, value] : joining) EXPECT_EQ(subject.joining(pair[0], pair[1]), value);
  for (std::size_t place = 0; place < subject.all.size(); ++place) {
    for (const Peaks& side : above.of_sides[place]) {
      for (const std::size_t leaf : side) {
        if (leaf == *side.begin()) continue;
        EXPECT_GT(subject.joining(leaf, *side.begin()), subject.all[place].squared_distance);
      }
    }
  }
}

// Components between the values of nodes, and at values of other Voronoi vertices, do not come together.
void expect_tree_of_graph(const Subject& subject) {
  const VoronoiGraph graph = voronoi_graph(subject.set);
  std::map<std::size_t, std::size_t> vertex_of = {{subject.infinity(), graph.infinity()}};
  std::set<Rational> values = {0};
  for (std::size_t k = 0; k < graph.vertices.size(); ++k) {
    values.insert(graph.vertices[k].squared_distance);
    for (std::size_t leaf = 0; leaf < subject.infinity(); ++leaf) {
      if (subject.all[subject.maxima[leaf]].contact == graph.vertices[k].contact) vertex_of[leaf] = k;
    }
  }
  for (const VoronoiEdge& edge : graph.edges) values.insert(edge.least);
  for (const Rational& a : values) {
    const auto component = components_above(graph, a);
    for (const auto& [leaf, vertex] : vertex_of) {
      for (const auto& [other, other_vertex] : vertex_of) {
        if (other <= leaf || !component[vertex] || !component[other_vertex]) continue;
        EXPECT_EQ(component[vertex] == component[other_vertex], subject.joining(leaf, other) > a);
      }
    }
    // Each component has a leaf.
    for (const auto& one : component) {
      EXPECT_TRUE(!one || std::ranges::any_of(vertex_of, [&](const auto& l) { return component[l.second] == one; }));
    }
  }
}

// The least d^2 on a segment, or on a ray if there is no end: the samples' least distance from it.
Rational least_on(const PointSet& set, const Point& from, const Point& direction, bool is_ray) {
  std::optional<Rational> least;
  for (const Point& p : set.points) {
    Rational t = dot(minus(p, from), direction) / dot(direction, direction);
    t = std::max<Rational>(t, 0);
    if (!is_ray) t = std::min<Rational>(t, 1);
    const Rational there = squared_distance(p, moved(from, t, direction));
    least = least ? std::min(*least, there) : there;
  }
  return least.value();
}

// No straight path is wider than a widest one.
void expect_straight_paths_narrow(const Subject& subject) {
  for (std::size_t leaf = 0; leaf < subject.infinity(); ++leaf) {
    const Point& from = subject.all[subject.maxima[leaf]].center;
    for (std::size_t other = leaf + 1; other < subject.infinity(); ++other) {
      const Point way = minus(subject.all[subject.maxima[other]].center, from);
      EXPECT_LE(least_on(subject.set, from, way, false), subject.joining(leaf, other));
      EXPECT_LT(subject.joining(leaf, other), std::min(subject.value(leaf), subject.value(other)));
    }
    for (const StationaryPoint& z : subject.all) {
      const Point way = minus(z.center, from);
      if (way == Point{0, 0, 0}) continue;
      EXPECT_LE(least_on(subject.set, from, way, true), subject.joining(leaf, subject.infinity()));
    }
  }
}

// The pairs of a dimension, with birth and death, that the nodes of a tree stand for.
std::vector<PersistencePair> pairs_of_nodes(const Subject& subject) {
  std::vector<PersistencePair> pairs;
  for (const MergeNode& node : subject.pockets_tree.nodes) {
    std::vector<std::optional<Rational>> greatest;
    for (const std::size_t part : node.parts) {
      std::optional<Rational> value = 0;
      for (const std::size_t leaf : leaves_of(subject.pockets_tree, part)) {
        if (leaf == subject.infinity()) value.reset();
        if (value && leaf != subject.infinity()) value = std::max(*value, subject.value(leaf));
      }
      greatest.push_back(value);
    }
    std::sort(greatest.begin(), greatest.end(), [](const auto& a, const auto& b) { return b && (!a || *a > *b); });
    for (std::size_t k = 1; k < greatest.size(); ++k) pairs.push_back({2, node.value, greatest[k]});
  }
  for (const MergeNode& node : subject.components_tree.nodes) {
    for (std::size_t k = 1; k < node.parts.size(); ++k) pairs.push_back({0, 0, node.value});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// FC-TREE-05 and 06, and Euler's relation: tunnels are filled as often as they begin.
void expect_pairs(const Subject& subject) {
  std::vector<PersistencePair> expected = persistence_pairs(subject.set);
  std::erase_if(expected, [](const PersistencePair& pair) { return pair.dimension == 1 || !pair.death; });
  const std::vector<PersistencePair> found = pairs_of_nodes(subject);
  EXPECT_EQ(found, expected);
  const auto in_dimension = [&](int dimension) {
    return static_cast<std::size_t>(std::ranges::count(found, dimension, &PersistencePair::dimension));
  };
  EXPECT_EQ(in_dimension(2), subject.count(3));
  EXPECT_EQ(subject.count(1) - in_dimension(0), subject.count(2) - in_dimension(2));
}

struct TreeCount {
  std::size_t inputs = 0, maxima = 0, nodes = 0, of_three = 0, spare_gates = 0, ties_above = 0;
};

TEST(OraclePocketsFamilies, TreesHoldToFlowAndPersistence) {
  CITES("FC-TREE-01", "FC-TREE-02", "FC-TREE-03", "FC-TREE-04", "FC-TREE-05", "FC-TREE-06", "FC-POCK-01");
  TreeCount count;
  for_each_drawn(2, [&](const Subject& subject, std::uint64_t) {
    const PeaksAbove above = peaks_above(subject.set, subject.all);
    expect_tree_of_flow(subject, above);
    expect_tree_of_graph(subject);
    expect_straight_paths_narrow(subject);
    expect_pairs(subject);
    ++count.inputs;
    count.maxima += subject.maxima.size();
    for (const MergeNode& node : subject.pockets_tree.nodes) {
      ++count.nodes;
      count.of_three += node.parts.size() > 2 ? 1 : 0;
      count.spare_gates += node.points.size() >= node.parts.size() ? 1 : 0;
    }
    for (const auto& sides : above.of_sides) {
      for (const Peaks& side : sides) count.ties_above += side.size() > 1 ? 1 : 0;
    }
  });
  std::printf("%zu inputs, %zu maxima, %zu nodes, %zu of three parts or more, %zu with spare gates; %zu ties above\n",
              count.inputs, count.maxima, count.nodes, count.of_three, count.spare_gates, count.ties_above);
  const double scale = flowcert::property::scale_of_run();
  EXPECT_GT(static_cast<double>(count.maxima), 40 * scale);
  EXPECT_GT(static_cast<double>(count.of_three), 5 * scale);
  EXPECT_GT(static_cast<double>(count.spare_gates), 10 * scale);
  if (scale >= 1) {
    EXPECT_GT(count.ties_above, 0U);
  }
}

// The squares of 0, and of persistences just above which something has changed: a little more than lengths.
std::vector<Rational> squared_persistences(const Subject& subject) {
  std::set<Rational> lengths = {0};
  for (const PersistencePair& pair : pairs_of_nodes(subject)) {
    if (pair.dimension != 2) continue;
    const double length = std::sqrt(pair.death->convert_to<double>()) - std::sqrt(pair.birth.convert_to<double>());
    const Rational more(length * (1 + 1e-9));
    lengths.insert(more * more);
  }
  if (lengths.size() > 3)
    return {0, *std::next(lengths.begin()), *std::next(lengths.begin(), long(lengths.size() / 2))};
  return {lengths.begin(), lengths.end()};
}

std::size_t pairs_longer_than(const Subject& subject, const Rational& squared_persistence) {
  const std::vector<PersistencePair> pairs = pairs_of_nodes(subject);
  return static_cast<std::size_t>(std::ranges::count_if(pairs, [&](const PersistencePair& pair) {
    return pair.dimension == 2 && !is_root_difference_up_to(*pair.death, pair.birth, squared_persistence);
  }));
}

struct PocketCount {
  std::size_t inputs = 0, pockets = 0, merged = 0, apart = 0, cells = 0, outside = 0;
  std::map<Passage, std::size_t> passages;
};

// Each maximum is in one pocket, or in the outside, and nothing is in two cells.
void expect_partition(const Subject& subject, const Pockets& found) {
  std::vector<std::size_t> maxima = found.outside, cells;
  for (const Pocket& pocket : found.pockets) {
    maxima.insert(maxima.end(), pocket.maxima.begin(), pocket.maxima.end());
    cells.insert(cells.end(), pocket.cell.begin(), pocket.cell.end());
    EXPECT_TRUE(std::ranges::includes(pocket.cell, pocket.maxima));
    EXPECT_TRUE(std::ranges::includes(pocket.maxima, pocket.peaks));
    EXPECT_GT(pocket.volume, 0);
  }
  std::sort(maxima.begin(), maxima.end());
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(maxima, subject.maxima);
  EXPECT_TRUE(std::ranges::adjacent_find(cells) == cells.end());
}

// FC-POCK-05: the value of the highest mouth, by the tree.
Rational mouth_by_tree(const Subject& subject, const Pocket& pocket) {
  Rational highest = 0;
  for (const std::size_t place : pocket.maxima) {
    for (std::size_t other = 0; other <= subject.infinity(); ++other) {
      const bool is_own =
          other < subject.infinity() && std::ranges::binary_search(pocket.maxima, subject.maxima[other]);
      if (!is_own) highest = std::max(highest, subject.joining(subject.leaf_of(place), other));
    }
  }
  return highest;
}

void expect_depths(const Subject& subject, const Pockets& found, const Rational& squared_persistence,
                   PocketCount& count) {
  std::size_t deep = 0;
  for (const Pocket& pocket : found.pockets) {
    EXPECT_EQ(pocket.height, subject.all[pocket.peaks[0]].squared_distance);
    EXPECT_EQ(pocket.highest_mouth, mouth_by_tree(subject, pocket));
    EXPECT_GT(pocket.height, pocket.highest_mouth);
    ++(is_root_difference_up_to(pocket.height, pocket.highest_mouth, squared_persistence) ? count.apart : deep);
    count.merged += pocket.maxima.size() > 1 ? 1 : 0;
    count.cells += pocket.cell.size() > pocket.maxima.size() ? 1 : 0;
  }
  EXPECT_EQ(deep, pairs_longer_than(subject, squared_persistence));
}

void expect_neighbours(const Pockets& found) {
  for (std::size_t k = 0; k < found.pockets.size(); ++k) {
    EXPECT_FALSE(found.pockets[k].neighbours.empty());
    for (const std::size_t other : found.pockets[k].neighbours) {
      EXPECT_NE(other, k);
      if (other < found.pockets.size()) {
        EXPECT_TRUE(std::ranges::binary_search(found.pockets[other].neighbours, k));
      }
    }
  }
}

// At the values of mouths, and just above: what is a cavity cannot become open for a larger probe.
void expect_passages(const Subject& subject, const Pockets& found, PocketCount& count) {
  for (const Pocket& pocket : found.pockets) {
    std::set<Rational> probes = {0, pocket.to_infinity.value};
    for (const std::size_t mouth : pocket.mouths) {
      probes.insert(subject.all[mouth].squared_distance);
      probes.insert(subject.all[mouth].squared_distance * Rational(1001, 1000));
    }
    for (const Rational& probe : probes) {
      const Passage is = passage(subject.all, pocket, probe);
      EXPECT_EQ(is == Passage::kCavity, probe > pocket.to_infinity.value);
      const auto open = std::ranges::count_if(
          pocket.mouths, [&](std::size_t place) { return subject.all[place].squared_distance >= probe; });
      if (is != Passage::kCavity) {
        EXPECT_EQ(open == 1, is == Passage::kPocket);
        EXPECT_GT(open, 0);
      }
      ++count.passages[is];
    }
  }
}

// Of the whole: the widest path, its gates, and the largest balls.
void expect_widest(const Subject& subject, const Pockets& found) {
  const auto widest = widest_path(found);
  const auto largest = largest_balls(subject.all, found);
  ASSERT_EQ(widest.has_value(), !found.pockets.empty());
  ASSERT_EQ(largest.empty(), found.pockets.empty());
  if (!widest) return;
  EXPECT_LT(widest->value, subject.all[largest[0]].squared_distance);
  EXPECT_FALSE(widest->gates.empty());
  const PeaksAbove above = peaks_above(subject.set, subject.all);
  for (const std::size_t gate : widest->gates) {
    EXPECT_EQ(subject.all[gate].squared_distance, widest->value);
    // One of the sides is open to infinity above the gate, and the other one is not.
    std::size_t open = 0;
    for (const Peaks& side : above.of_sides[gate]) {
      const std::size_t leaf = *side.begin();
      open += leaf == subject.infinity() || subject.joining(leaf, subject.infinity()) > widest->value ? 1 : 0;
    }
    EXPECT_EQ(open, 1U);
  }
  for (const Pocket& pocket : found.pockets) {
    EXPECT_LE(pocket.to_infinity.value, widest->value);
    EXPECT_LE(subject.all[pocket.peaks[0]].squared_distance, subject.all[largest[0]].squared_distance);
    for (const std::size_t peak : pocket.peaks) {
      EXPECT_LE(subject.joining(subject.leaf_of(peak), subject.infinity()), pocket.to_infinity.value);
    }
  }
}

// Maxima of one pocket stay together at a greater persistence.
void expect_coarser(const Pockets& fine, const Pockets& coarse) {
  for (const Pocket& pocket : fine.pockets) {
    bool is_inside = std::ranges::includes(coarse.outside, pocket.maxima);
    for (const Pocket& other : coarse.pockets) {
      is_inside = is_inside || std::ranges::includes(other.maxima, pocket.maxima);
    }
    EXPECT_TRUE(is_inside);
  }
}

TEST(OraclePocketsFamilies, PocketsHoldToTheTree) {
  CITES("FC-POCK-02", "FC-POCK-03", "FC-POCK-04", "FC-POCK-05", "FC-POCK-06", "FC-POCK-07", "FC-POCK-08", "FC-POCK-09");
  PocketCount count;
  for_each_drawn(1, [&](const Subject& subject, std::uint64_t) {
    std::optional<Pockets> before;
    for (const Rational& square : squared_persistences(subject)) {
      const Pockets found = pockets(subject.set, subject.all, square);
      expect_partition(subject, found);
      expect_depths(subject, found, square, count);
      expect_neighbours(found);
      expect_passages(subject, found, count);
      expect_widest(subject, found);
      if (before) expect_coarser(*before, found);
      if (square == 0) {
        EXPECT_EQ(found.pockets.size(), subject.maxima.size());
      }
      before = found;
      count.pockets += found.pockets.size();
      count.outside += found.outside.size();
    }
    ++count.inputs;
  });
  std::printf("%zu inputs, %zu pockets: %zu of several maxima, %zu apart, %zu cells with more; %zu maxima outside\n",
              count.inputs, count.pockets, count.merged, count.apart, count.cells, count.outside);
  std::printf("%zu cavities, %zu pockets, %zu channels\n", count.passages[Passage::kCavity],
              count.passages[Passage::kPocket], count.passages[Passage::kChannel]);
  const double scale = flowcert::property::scale_of_run();
  EXPECT_GT(static_cast<double>(count.pockets), 35 * scale);
  EXPECT_GT(static_cast<double>(count.outside), 17 * scale);
  EXPECT_GT(static_cast<double>(count.passages[Passage::kPocket]), 7 * scale);
  EXPECT_GT(static_cast<double>(count.passages[Passage::kChannel]), 7 * scale);
  if (scale >= 1) {
    EXPECT_GT(count.merged, 0U);
    EXPECT_GT(count.apart, 0U);
    EXPECT_GT(count.cells, 0U);
  }
}

// All that is told of pockets, by positions of stationary points that are brought back.
template <typename Back>
auto described(const Subject& subject, const Pockets& found, const Back& back) {
  const auto positions = [&](const std::vector<std::size_t>& places) {
    std::set<Point> result;
    for (const std::size_t place : places) result.insert(back(subject.all[place].center));
    return result;
  };
  using Positions = std::set<Point>;
  using Described = std::tuple<Positions, Positions, Positions, Positions, Positions, std::array<Rational, 4>>;
  std::set<Described> result;
  for (const Pocket& pocket : found.pockets) {
    result.insert({positions(pocket.maxima),
                   positions(pocket.peaks),
                   positions(pocket.cell),
                   positions(pocket.mouths),
                   positions(pocket.to_infinity.gates),
                   {pocket.height, pocket.highest_mouth, pocket.volume, pocket.to_infinity.value}});
  }
  return result;
}

TEST(OraclePocketsFamilies, NeitherOrderNorMotionChangesThem) {
  CITES("FC-POCK-10", "FC-TREE-07");
  std::size_t with_pockets = 0;
  for_each_drawn(1, [&](const Subject& subject, std::uint64_t) {
    LandscapeRows moved(subject.rows.rbegin(), subject.rows.rend());
    for (auto& [x, y, z] : moved) std::tie(x, y, z) = std::tuple(-z, x, y);  // a reflection
    const Subject image(moved);
    const auto stays = [](const Point& x) { return x; };
    const auto returns = [](const Point& x) { return Point{x[1], x[2], -x[0]}; };
    for (const Rational& square : squared_persistences(subject)) {
      const auto found = described(subject, pockets(subject.set, subject.all, square), stays);
      EXPECT_EQ(described(image, pockets(image.set, image.all, square), returns), found);
      with_pockets += found.empty() ? 0 : 1;
    }
  });
  EXPECT_GT(static_cast<double>(with_pockets), 10 * flowcert::property::scale_of_run());
}

}  // namespace
}  // namespace oracle::oracle_pockets_families_test
