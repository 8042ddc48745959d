// The Voronoi vertices and edges of a finite point set, with the least squared distance on each edge (FC-TREE-03).
//
// All sets of four samples are tried for the vertices. Edges are found from what the contact sets of two vertices have
// in common, and rays from the samples on one side of a plane. There is no triangulation and no flow. Exact.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

struct VoronoiVertex {
  Point position;
  Rational squared_distance;
  std::vector<std::size_t> contact;  // class names, ascending
};

// An edge between two vertices, or a ray from one.
struct VoronoiEdge {
  std::vector<std::size_t> polygon;  // its contact set, by class names, ascending
  std::size_t from = 0;
  std::optional<std::size_t> to;  // nothing: infinity
  Rational least;                 // of d^2, on the closed edge
};

// If P does not span space, there is no vertex, and no edge is listed: each one is a full line.
struct VoronoiGraph {
  std::vector<VoronoiVertex> vertices;  // by contact set
  std::vector<VoronoiEdge> edges;

  // Infinity counts as one more vertex, behind the others.
  std::size_t infinity() const { return vertices.size(); }
};

VoronoiGraph voronoi_graph(const PointSet& set);

// The components of what has d^2 > a: vertices above a, and infinity, joined by edges that are above a everywhere. For
// each vertex and then for infinity the least one of its component; nothing for a vertex that is not above a.
std::vector<std::optional<std::size_t>> components_above(const VoronoiGraph& graph, const Rational& a);

}  // namespace oracle
