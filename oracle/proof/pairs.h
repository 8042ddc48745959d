// All persistence pairs of the squared distance, from the alpha filtration of the triangulation.
//
// The value of a simplex is the squared radius of the smallest sphere through its vertices if all link vertices are
// outside, and else the least value of the simplices that it is a face of. (With link vertices on the sphere and none
// inside, both are the same.) The sets of the simplices up to a value have the homotopy type of the unions of balls.
//
// Pairs of dimension 0 come from the edges in ascending order, joining points. Those of dimension 2 come from the
// triangles in descending order, joining cells and the outside. Those of dimension 1 come from reducing the boundaries
// of the other triangles, in ascending order, modulo 2.
#pragma once

#include "edge_stars.h"

class PersistencePairs {
 public:
  using Rank = std::uint32_t;  // 0 is the value 0, kNone is infinity, and values ascend between them
  struct Pair {
    std::uint32_t dimension;
    Rank birth, death;
    auto operator<=>(const Pair&) const = default;
    std::string text() const {
      return "of dimension " + std::to_string(dimension) + " from value " + std::to_string(birth) + " to value " +
             std::to_string(death) + " in ascending order";
    }
  };

  PersistencePairs(const Points& points, const Triangulation& triangulation) : points_(points), t_(triangulation) {
    find_simplices();
    find_ranks();
    if (points.point_count() > 0) pairs_.push_back({0, 0, kNone});
    const std::vector<std::uint32_t> edges = in_order(edge_ranks_), triangles = in_order(triangle_ranks_);
    pair_edges(edges);
    if (t_.dimension == 3) pair_cells(triangles);
    pair_triangles(edges, triangles);
  }

  const std::vector<Pair>& pairs() const { return pairs_; }
  // A simplex whose smallest sphere has the squared radius of the rank, which is neither 0 nor infinity.
  const Simplex& simplex(Rank rank) const { return values_[rank - 1]; }
  // Of the smallest sphere through the vertices; it is there.
  Rank rank_of(const Simplex& v) const {
    if (v[1] == kNone) return 0;
    const auto is_less = [this](const Simplex& a, const Simplex& b) { return compare(a, b) < 0; };
    return static_cast<Rank>(std::lower_bound(values_.begin(), values_.end(), v, is_less) - values_.begin() + 1);
  }

 private:
  void find_simplices() {
    std::vector<std::uint32_t> number_of(4 * t_.cells.size());  // by facet: of the triangle
    for (Facet facet = 0; facet < number_of.size(); ++facet) {
      if (t_.dimension == 3 ? t_.mate(facet) < facet : t_.dimension < 2 || facet % 4 != 3) continue;
      number_of[facet] = static_cast<std::uint32_t>(triangles_.size());
      if (t_.dimension == 3 && t_.mate(facet) != kHull) number_of[t_.mate(facet)] = number_of[facet];
      triangles_.push_back(facet);
    }
    sides_.resize(triangles_.size(), {kNone, kNone, kNone});
    for_each_edge(t_, [&](const EdgeStar& star) {
      bool is_gabriel = true;
      for (const Spoke& spoke : star.spokes) {
        auto& sides = sides_[number_of[spoke.triangle]];
        *std::find(sides.begin(), sides.end(), kNone) = static_cast<std::uint32_t>(edges_.size());
        is_gabriel = is_gabriel && side_of_sphere(points_, star.edge, spoke.link) > 0;
      }
      edges_.push_back(star.edge);
      edge_ranks_.push_back(is_gabriel ? 0 : kNone);
    });
  }

  // The squared diameter of the smallest sphere through the vertices, as numerator and denominator.
  template <class N>
  std::pair<N, N> squared_diameter(const Simplex& v) const {
    const N a = squared_distance<N>(v[0], v[1]);
    if (v[2] == kNone) return {a * a, a};
    const auto [center, denominator] = circumcenter<N>(points_, v);
    if (v[3] != kNone) return {dot(center, center), denominator * denominator};
    return {a * squared_distance<N>(v[0], v[2]) * squared_distance<N>(v[1], v[2]), denominator};
  }
  template <class N>
  N squared_distance(Id p, Id q) const {
    return dot(points_.vector<N>(p, q), points_.vector<N>(p, q));
  }
  int compare(const Simplex& v, const Simplex& w) const {
    const auto difference = [&]<class N>() {
      const auto [v_numerator, v_denominator] = squared_diameter<N>(v);
      const auto [w_numerator, w_denominator] = squared_diameter<N>(w);
      return v_numerator * w_denominator - w_numerator * v_denominator;
    };
    return points_.sign(difference, 6);
  }

  // Sorted by doubles first. That is nearly always the right order, which exact comparisons prove, or mend.
  void find_ranks() {
    struct Own {  // a simplex that has a value of its own
      double about;
      Simplex vertices;
      Rank* rank;
    };
    std::vector<Own> all;
    const auto add = [&](const Simplex& v, Rank& rank) {
      const auto [numerator, denominator] = squared_diameter<Filtered>(v);
      const double about = numerator.value / denominator.value;
      all.push_back({std::isfinite(about) ? about : 0, v, &rank});
    };
    triangle_ranks_.assign(triangles_.size(), kNone);
    cell_ranks_.assign(t_.dimension == 3 ? t_.cells.size() : 0, kNone);
    for (std::size_t k = 0; k < cell_ranks_.size(); ++k) add(t_.cells[k], cell_ranks_[k]);
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      if (is_outside(triangles_[k]) && is_outside(t_.mate(triangles_[k])))
        add(t_.vertices(triangles_[k]), triangle_ranks_[k]);
    }
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (edge_ranks_[k] == 0) add(edges_[k], edge_ranks_[k]);
    }
    std::sort(all.begin(), all.end(), [](const Own& a, const Own& b) { return a.about < b.about; });
    const auto is_less = [this](const Own& a, const Own& b) { return compare(a.vertices, b.vertices) < 0; };
    if (!std::is_sorted(all.begin(), all.end(), is_less)) std::sort(all.begin(), all.end(), is_less);
    for (const Own& own : all) {
      if (values_.empty() || compare(values_.back(), own.vertices) != 0) values_.push_back(own.vertices);
      *own.rank = static_cast<Rank>(values_.size());
    }
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      Rank& rank = triangle_ranks_[k];
      if (rank == kNone) rank = std::min(cell_rank(triangles_[k]), cell_rank(t_.mate(triangles_[k])));
      for (const std::uint32_t side : sides_[k]) edge_ranks_[side] = std::min(edge_ranks_[side], rank);
    }
  }
  bool is_outside(Facet facet) const {
    if (t_.dimension == 2 || facet == kHull) return true;
    return side_of_sphere(points_, t_.vertices(facet), t_.opposite(facet)) > 0;
  }
  Rank cell_rank(Facet facet) const { return facet == kHull ? kNone : cell_ranks_[facet / 4]; }

  static std::vector<std::uint32_t> in_order(const std::vector<Rank>& ranks) {
    std::vector<std::uint32_t> order(ranks.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return ranks[a] < ranks[b]; });
    return order;
  }
  void add(std::uint32_t dimension, Rank birth, Rank death) {
    if (birth != death) pairs_.push_back({dimension, birth, death});
  }

  // What is joined has one root.
  class Union {
   public:
    explicit Union(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0); }
    std::uint32_t root(std::uint32_t x) {
      while (parents_[x] != x) x = parents_[x] = parents_[parents_[x]];
      return x;
    }
    void join(std::uint32_t root, std::uint32_t new_root) { parents_[root] = new_root; }

   private:
    std::vector<std::uint32_t> parents_;
  };
  void pair_edges(const std::vector<std::uint32_t>& edges) {
    Union components(points_.row_count());
    for (const std::uint32_t edge : edges) {
      const std::uint32_t p = components.root(edges_[edge][0]), q = components.root(edges_[edge][1]);
      if (p == q) continue;
      components.join(p, q);
      add(0, 0, edge_ranks_[edge]);
    }
  }
  // The root of a component is its cell of greatest rank. The outside has the rank infinity.
  void pair_cells(const std::vector<std::uint32_t>& triangles) {
    const auto outside = static_cast<std::uint32_t>(cell_ranks_.size());
    cell_ranks_.push_back(kNone);
    Union components(cell_ranks_.size());
    is_paired_.resize(triangles.size());
    for (auto triangle = triangles.rbegin(); triangle != triangles.rend(); ++triangle) {
      const Facet facet = triangles_[*triangle], mate = t_.mate(facet);
      std::uint32_t lower = components.root(facet / 4), upper = components.root(mate == kHull ? outside : mate / 4);
      if (lower == upper) continue;
      if (cell_ranks_[lower] > cell_ranks_[upper]) std::swap(lower, upper);
      components.join(lower, upper);
      add(2, triangle_ranks_[*triangle], cell_ranks_[lower]);
      is_paired_[*triangle] = true;
    }
  }
  // A column is a sum of boundaries: places of edges in the order. Earlier columns are added until it ends with an edge
  // that no other one ends with.
  void pair_triangles(const std::vector<std::uint32_t>& edges, const std::vector<std::uint32_t>& triangles) {
    using Column = std::vector<std::uint32_t>;
    std::vector<std::uint32_t> place(edges.size());
    for (std::uint32_t k = 0; k < edges.size(); ++k) place[edges[k]] = k;
    const auto boundary = [&](std::uint32_t triangle) {
      Column column;
      for (const std::uint32_t side : sides_[triangle]) column.push_back(place[side]);
      std::sort(column.begin(), column.end());
      return column;
    };
    std::vector<std::uint32_t> by_last(edges.size(), kNone);  // the triangle whose column ends there
    std::vector<Column> sums(edges.size());                   // and the column, if it is not just the boundary
    for (const std::uint32_t triangle : triangles) {
      if (t_.dimension == 3 && is_paired_[triangle]) continue;
      Column column = boundary(triangle), sum;
      while (by_last[column.back()] != kNone) {
        const std::uint32_t last = column.back();
        const Column other = sums[last].empty() ? boundary(by_last[last]) : sums[last];
        sum.clear();
        std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                      std::back_inserter(sum));
        column.swap(sum);
      }
      const std::uint32_t last = column.back();
      by_last[last] = triangle;
      add(1, edge_ranks_[edges[last]], triangle_ranks_[triangle]);
      if (sum.capacity() > 0) sums[last] = column;
    }
  }

  const Points& points_;
  const Triangulation& t_;
  std::vector<Simplex> edges_;
  std::vector<Facet> triangles_;
  std::vector<std::array<std::uint32_t, 3>> sides_;  // of the triangles: edges
  std::vector<Rank> edge_ranks_, triangle_ranks_, cell_ranks_;
  std::vector<Simplex> values_;
  std::vector<bool> is_paired_;  // by triangle: in dimension 2
  std::vector<Pair> pairs_;
};
