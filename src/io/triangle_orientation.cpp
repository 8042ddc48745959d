// Each triangle has two sides. A manifold edge joins each side of one of its triangles to the side of the other one
// that goes along the edge in the opposite direction. A component has an orientation iff no triangle is joined to its
// own other side.
//
// The code is our own. CGAL's orient_polygon_soup gives vertices of edges that are not manifold new copies, but here
// two vertices are one iff their positions are equal. CGAL's orientation functions for meshes want no such edges at
// all. Neither may be included in this layer.
#include "io/triangle_orientation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/contract.h"
#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"

namespace flowcert {

namespace {

// A triangle at an edge. The edge's lesser vertex is known from where this is kept.
struct EdgeUse {
  std::uint32_t greater_vertex = 0;
  std::uint32_t triangle = 0;
  bool ascends = false;  // the triangle goes along the edge from the lesser vertex to the greater one
};

// The uses of all edges, those of one edge next to each other. begin_of_edge() is where each edge begins.
class EdgeUses {
 public:
  EdgeUses(std::span<const Triangle> triangles, std::size_t vertices)
      : first_(vertices + 1), uses_(3 * triangles.size()) {
    for (const Triangle& triangle : triangles) {
      for (std::size_t k = 0; k < 3; ++k) ++first_[std::min(triangle[k], triangle[(k + 1) % 3]) + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [from, to] = std::pair(triangles[t][k], triangles[t][(k + 1) % 3]);
        FLOWCERT_REQUIRES(from != to);
        uses_[next[std::min(from, to)]++] = {std::max(from, to), t, from < to};
      }
    }
    for (std::size_t v = 0; v < vertices; ++v) {
      std::ranges::sort(at(v), {}, [](const EdgeUse& use) { return std::pair(use.greater_vertex, use.triangle); });
    }
  }

  // Calls take(uses) for each edge.
  template <typename Take>
  void for_each_edge(const Take& take) {
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
      const std::span<EdgeUse> uses = at(v);
      for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
        while (last < uses.size() && uses[last].greater_vertex == uses[first].greater_vertex) ++last;
        take(std::span<const EdgeUse>(uses.subspan(first, last - first)));
      }
    }
  }

 private:
  [[nodiscard]] std::span<EdgeUse> at(std::size_t v) {
    return std::span(uses_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

  std::vector<std::size_t> first_;  // by the lesser vertex
  std::vector<EdgeUse> uses_;
};

// Side 2t of triangle t is the triangle as it is, and 2t + 1 is the turned one.
class TriangleSides {
 public:
  explicit TriangleSides(std::size_t triangles) : sets_(2 * triangles) {}

  void join(const EdgeUse& one, const EdgeUse& other) {
    const std::uint32_t turned = one.ascends == other.ascends ? 1 : 0;
    sets_.unite(2 * one.triangle, 2 * other.triangle + turned);
    sets_.unite(2 * one.triangle + 1, 2 * other.triangle + 1 - turned);
  }
  [[nodiscard]] std::uint32_t set_of(std::uint32_t triangle, bool turned) {
    return sets_.find(2 * triangle + (turned ? 1 : 0));
  }

 private:
  geometry::DisjointSets sets_;
};

}  // namespace

TriangleEdges orient(std::span<Triangle> triangles, std::size_t vertices) {
  const geometry::IeeeDoubles ieee;
  FLOWCERT_REQUIRES(triangles.size() < (std::size_t{1} << 31));
  TriangleEdges edges;
  TriangleSides sides(triangles.size());
  EdgeUses(triangles, vertices).for_each_edge([&](std::span<const EdgeUse> uses) {
    ++(uses.size() == 1 ? edges.boundary : uses.size() == 2 ? edges.manifold : edges.non_manifold);
    if (uses.size() == 2) sides.join(uses[0], uses[1]);
  });
  // A component has two sets of sides. The set with its first triangle as it is is taken.
  std::vector<bool> is_taken(2 * triangles.size(), false);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t as_it_is = sides.set_of(t, false), turned = sides.set_of(t, true);
    if (!is_taken[as_it_is] && !is_taken[turned]) {
      is_taken[as_it_is] = true;
      ++edges.components;
      edges.without_orientation += as_it_is == turned ? 1 : 0;
    }
    if (!is_taken[as_it_is]) std::swap(triangles[t][1], triangles[t][2]);
  }
  return edges;
}

}  // namespace flowcert
