// Merge trees by the oracle, worked out by hand: lattices, where many components join at one value, and flat sets.
#include <gtest/gtest.h>

#include "oracle/fast/point_set.h"
#include "oracle/merge_tree.h"
#include "oracle/voronoi_graph.h"
#include "tests/cites.h"

namespace oracle::oracle_merge_tree_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;
using Places = std::vector<std::size_t>;

Rows lattice(int a, int b, int c) {
  Rows rows;
  for (int x = 0; x < a; ++x) {
    for (int y = 0; y < b; ++y) {
      for (int z = 0; z < c; ++z) rows.push_back({double(x), double(y), double(z)});
    }
  }
  return rows;
}

struct Trees {
  explicit Trees(const Rows& rows)
      : set(rows),
        all(stationary_points(set).stationary),
        pockets(superlevel_tree(set, all)),
        components(sublevel_tree(set, all)) {}

  std::vector<Names> contacts(const MergeNode& node) const {
    std::vector<Names> result;
    result.reserve(node.points.size());
    for (const std::size_t place : node.points) result.push_back(all[place].contact);
    return result;
  }

  fast::PointSet set;
  std::vector<StationaryPoint> all;
  MergeTree pockets, components;
};

TEST(OracleMergeTree, OfFlatAndSmallSets) {
  CITES("FC-TREE-01", "FC-TREE-02", "FC-TREE-06");
  EXPECT_EQ(Trees({}).pockets.leaves, 0U);
  EXPECT_EQ(Trees({}).components.leaves, 0U);
  for (const Rows& rows :
       {Rows{{1, 2, 3}}, Rows{{0, 0, 0}, {2, 0, 0}, {6, 0, 0}}, Rows{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}) {
    const Trees trees(rows);
    EXPECT_EQ(trees.pockets, (MergeTree{1, {}}));
    EXPECT_EQ(trees.components.leaves, rows.size());
  }
  const Trees line({{0, 0, 0}, {2, 0, 0}, {6, 0, 0}, {-2, 0, 0}});
  ASSERT_EQ(line.components.nodes.size(), 2U);
  EXPECT_EQ(line.components.nodes[0].value, 1);
  EXPECT_EQ(line.components.nodes[0].parts, (Places{0, 1, 3}));
  EXPECT_EQ(line.contacts(line.components.nodes[0]), (std::vector<Names>{{0, 1}, {0, 3}}));
  EXPECT_EQ(line.components.nodes[1].value, 4);
  EXPECT_EQ(line.components.nodes[1].parts, (Places{2, 4}));
  EXPECT_EQ(joining_value(line.components, 2, 3), Rational(4));
}

// Two pairs join at one value: the node with the least sample comes first.
TEST(OracleMergeTree, NodesOfOneValueAreInTheOrderOfTheirLeastLeaf) {
  CITES("FC-TREE-07");
  const Trees trees({{0, 0, 0}, {100, 0, 0}, {102, 0, 0}, {2, 0, 0}});
  ASSERT_EQ(trees.components.nodes.size(), 3U);
  EXPECT_EQ(trees.components.nodes[0].parts, (Places{0, 3}));
  EXPECT_EQ(trees.components.nodes[1].parts, (Places{1, 2}));
  EXPECT_EQ(trees.components.nodes[2].parts, (Places{4, 5}));
  EXPECT_EQ(leaves_of(trees.components, 6), (Places{0, 1, 2, 3}));
}

// Each of the 8 cells has the value 3/4, each of the 36 squares 1/2, each of the 54 edges 1/4.
TEST(OracleMergeTree, OfACubicLattice) {
  CITES("FC-TREE-02", "FC-TREE-03", "FC-TREE-05", "FC-TREE-06");
  const Trees trees(lattice(3, 3, 3));
  ASSERT_EQ(trees.pockets.nodes.size(), 1U);
  EXPECT_EQ(trees.pockets.nodes[0].value, Rational(1, 2));
  EXPECT_EQ(trees.pockets.nodes[0].parts, (Places{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(trees.pockets.nodes[0].points.size(), 36U);
  ASSERT_EQ(trees.components.nodes.size(), 1U);
  EXPECT_EQ(trees.components.nodes[0].value, Rational(1, 4));
  EXPECT_EQ(trees.components.nodes[0].parts.size(), 27U);
  EXPECT_EQ(trees.components.nodes[0].points.size(), 54U);
}

// The cell of the face-centred lattice of edge 4: an octahedral hole of squared radius 4 and eight tetrahedral ones of
// squared radius 3, behind triangles of squared radius 8/3.
TEST(OracleMergeTree, OfAFaceCentredLattice) {
  CITES("FC-TREE-02", "FC-TREE-03");
  Rows rows = {{2, 2, 0}, {2, 2, 4}, {2, 0, 2}, {2, 4, 2}, {0, 2, 2}, {4, 2, 2}};
  for (const double x : {0, 4}) {
    for (const double y : {0, 4}) {
      for (const double z : {0, 4}) rows.push_back({x, y, z});
    }
  }
  const Trees trees(rows);
  std::vector<Rational> values;
  for (const std::size_t place : maxima_places(trees.all)) values.push_back(trees.all[place].squared_distance);
  EXPECT_EQ(values, (std::vector<Rational>{4, 3, 3, 3, 3, 3, 3, 3, 3}));
  ASSERT_EQ(trees.pockets.nodes.size(), 1U);
  EXPECT_EQ(trees.pockets.nodes[0].value, Rational(8, 3));
  EXPECT_EQ(trees.pockets.nodes[0].parts.size(), 10U);
  EXPECT_EQ(trees.pockets.nodes[0].points.size(), 32U);
}

// A box of the edges 2, 4, 4 beside one of 4, 4, 4: the square between them has the squared radius 8, and the
// rectangles of the flat box have 5, those of the cube 8.
TEST(OracleMergeTree, OfTwoBoxes) {
  CITES("FC-TREE-02", "FC-TREE-03", "FC-TREE-05");
  Rows rows;
  for (const double x : {-2, 0, 4}) {
    for (const double y : {0, 4}) {
      for (const double z : {0, 4}) rows.push_back({x, y, z});
    }
  }
  const Trees trees(rows);
  ASSERT_EQ(trees.pockets.nodes.size(), 1U);
  EXPECT_EQ(trees.pockets.nodes[0].value, 8);
  EXPECT_EQ(trees.pockets.nodes[0].parts, (Places{0, 1, 2}));
  EXPECT_EQ(trees.pockets.nodes[0].points.size(), 7U);
  EXPECT_EQ(joining_value(trees.pockets, 0, 1), Rational(8));
}

// The chain from index 2 to index 2: {0,1,2} and {1,2,4} lead to {0,3,4}, which is between the two maxima. These are
// open at a higher value already.
TEST(OracleMergeTree, WithAChainOfIndexTwoPoints) {
  CITES("FC-TREE-02", "FC-TREE-03", "FC-TREE-04");
  const Trees trees({{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}});
  EXPECT_EQ(trees.pockets.leaves, 3U);
  ASSERT_EQ(trees.pockets.nodes.size(), 1U);
  EXPECT_EQ(trees.pockets.nodes[0].value, Rational(658255, 12842));
  EXPECT_EQ(trees.pockets.nodes[0].parts, (Places{0, 1, 2}));
  EXPECT_EQ(trees.contacts(trees.pockets.nodes[0]), (std::vector<Names>{{0, 1, 3}, {0, 2, 3}, {1, 3, 4}, {2, 3, 4}}));
}

// A box and a ray to infinity from each of its six sides.
TEST(OracleMergeTree, TheVoronoiGraphOfABox) {
  CITES("FC-TREE-04");
  Rows rows;
  for (const double x : {0, 2}) {
    for (const double y : {0, 4}) {
      for (const double z : {0, 6}) rows.push_back({x, y, z});
    }
  }
  const VoronoiGraph graph = voronoi_graph(PointSet(rows));
  ASSERT_EQ(graph.vertices.size(), 1U);
  EXPECT_EQ(graph.vertices[0].squared_distance, 14);
  std::multiset<Rational> values;
  for (const VoronoiEdge& edge : graph.edges) {
    EXPECT_FALSE(edge.to);
    values.insert(edge.least);
  }
  EXPECT_EQ(values, (std::multiset<Rational>{5, 5, 10, 10, 13, 13}));
  using Components = std::vector<std::optional<std::size_t>>;
  EXPECT_EQ(components_above(graph, 14), (Components{std::nullopt, 1}));
  EXPECT_EQ(components_above(graph, 13), (Components{0, 1}));
  EXPECT_EQ(components_above(graph, 12), (Components{0, 0}));
}

// A flat tetrahedron: its centre is outside of it, and on the ray from it d^2 is least at the vertex.
TEST(OracleMergeTree, AVertexThatIsNoMaximumIsNoLeaf) {
  CITES("FC-TREE-01", "FC-TREE-04");
  const Trees trees({{4, 0, 0}, {-4, 4, 0}, {-4, -4, 0}, {0, 0, 1}});
  EXPECT_EQ(trees.pockets, (MergeTree{1, {}}));
  const VoronoiGraph graph = voronoi_graph(trees.set);
  ASSERT_EQ(graph.vertices.size(), 1U);
  std::size_t from_vertex = 0;
  for (const VoronoiEdge& edge : graph.edges) {
    from_vertex += edge.least == graph.vertices[0].squared_distance ? 1 : 0;
  }
  EXPECT_EQ(graph.edges.size(), 4U);
  EXPECT_GT(from_vertex, 0U);
}

}  // namespace
}  // namespace oracle::oracle_merge_tree_test
