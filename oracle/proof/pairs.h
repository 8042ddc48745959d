// All persistence pairs of the squared distance, from the alpha filtration of the triangulation.
//
// The value of a simplex is the squared radius of the smallest sphere through its vertices if all link vertices are
// outside, and else the least value of the simplices that it is a face of. (With link vertices on the sphere and none
// inside, both are the same.) The sets of the simplices up to a value have the homotopy type of the unions of balls.
// Pairs of dimension 0 come from the edges in ascending order, joining points. Those of dimension 2 come from the
// triangles in descending order, joining cells and the outside. Those of dimension 1 come from reducing the boundaries
// of the other triangles, in ascending order, modulo 2.
#pragma once

#include <memory>

#include "edge_stars.h"

using Rank = std::uint32_t;                   // 0 is the value 0, kNone is infinity, and values ascend between them
using PersistencePair = std::array<Rank, 3>;  // dimension, birth and death

template <class N>
struct Ratio {
  N numerator, denominator;
  // This less b, times both denominators.
  N less(const Ratio& b) const { return numerator * b.denominator - b.numerator * denominator; }
};

class PersistencePairs {
 public:
  PersistencePairs(const Points& points, const Triangulation& triangulation) : points_(points), t_(triangulation) {
    find_simplices();
    find_ranks();
    if (points.point_count() > 0) add(0, 0, kNone);
    const std::vector<std::uint32_t> closing = join(0, in_order(ranks_[2]));
    std::vector<std::uint32_t> triangles = in_order(ranks_[3]);
    std::reverse(triangles.begin(), triangles.end());
    if (t_.dimension == 3) triangles = join(2, triangles);
    pair_triangles(closing, triangles);
  }

  const std::vector<PersistencePair>& all() const { return all_; }
  Ratio<BigInteger> squared_diameter(Rank rank) const { return squared_diameter<BigInteger>(values_[rank - 1]); }
  // The rank of the smallest sphere through the vertices, whose value some simplex has.
  Rank rank_of(const Simplex& v) const {
    if (v[1] == kNone) return 0;
    const auto is_less = [this](const Simplex& a, const Simplex& b) { return compare(a, b) < 0; };
    return static_cast<Rank>(std::lower_bound(values_.begin(), values_.end(), v, is_less) - values_.begin() + 1);
  }

 private:
  // A triangle has the number of its facet, and of the first one if there are two; in dimension 2, 4 * cell + 3.
  void find_simplices() {
    sides_.resize(t_.dimension > 1 ? 4 * t_.cells.size() : 0, {kNone, kNone, kNone});
    ranks_[3].resize(sides_.size(), kNone);
    ranks_[4].resize(t_.dimension == 3 ? t_.cells.size() : 0);
    ranks_[4].push_back(kNone);  // of the outside
    ranks_[1].resize(points_.row_count());
    for_each_edge(t_, [this](const EdgeStar& star) {
      bool is_outside = true;
      for (const Spoke& spoke : star.spokes) {
        auto& sides = sides_[t_.dimension == 3 ? std::min(spoke.triangle, t_.mate(spoke.triangle)) : spoke.triangle];
        *std::find(sides.begin(), sides.end(), kNone) = static_cast<std::uint32_t>(edges_.size());
        is_outside = is_outside && side_of_sphere(points_, star.edge, spoke.link) > 0;
      }
      edges_.push_back(star.edge);
      ranks_[2].push_back(is_outside ? 0 : kNone);
    });
    for (Facet facet = 0; facet < sides_.size(); ++facet) {
      if (is_triangle(facet) && is_outside(facet) && is_outside(t_.mate(facet))) ranks_[3][facet] = 0;
    }
  }
  bool is_triangle(Facet facet) const { return sides_[facet][0] != kNone; }
  bool is_outside(Facet facet) const {  // the opposite vertex
    if (t_.dimension == 2 || facet == kHull) return true;
    return side_of_sphere(points_, t_.vertices(facet), t_.opposite(facet)) > 0;
  }

  // The squared diameter of the smallest sphere through the vertices.
  template <class N>
  Ratio<N> squared_diameter(const Simplex& v) const {
    if (v[3] != kNone) {
      const auto [center, denominator] = circumcenter<N>(points_, v);
      return {dot(center, center), denominator * denominator};
    }
    const Vector<N> a = points_.vector<N>(v[0], v[1]);
    if (v[2] == kNone) return {dot(a, a), N{1}};
    const Vector<N> b = points_.vector<N>(v[0], v[2]), c = points_.vector<N>(v[1], v[2]), ab = cross(a, b);
    return {dot(a, a) * dot(b, b) * dot(c, c), dot(ab, ab)};
  }
  int compare(const Simplex& v, const Simplex& w) const {
    const auto polynomial = [&]<class N>() { return squared_diameter<N>(v).less(squared_diameter<N>(w)); };
    return points_.sign(polynomial, 6);
  }
  struct Own {  // a simplex that has a value of its own
    double quotient;
    Ratio<Filtered> about;
    mutable std::unique_ptr<Ratio<BigInteger>> exact;  // once it was needed
    std::uint32_t size, number;
  };
  Simplex vertices(const Own& own) const {
    if (own.size == 2) return edges_[own.number];
    return own.size == 3 ? t_.vertices(own.number) : t_.cells[own.number];
  }
  int compare(const Own& a, const Own& b) const {
    const Filtered about = a.about.less(b.about);
    if (about.has_certain_sign()) return sign_of(about);
    if (points_.grid_bits() <= 6) return compare(vertices(a), vertices(b));
    for (const auto* x : {&a, &b}) {
      if (!x->exact) x->exact = std::make_unique<Ratio<BigInteger>>(squared_diameter<BigInteger>(vertices(*x)));
    }
    return sign_of(a.exact->less(*b.exact));
  }
  void find_ranks() {
    std::vector<Own> own;
    own.reserve(ranks_[2].size() + ranks_[3].size() + ranks_[4].size());
    for (const std::uint32_t size : {2U, 3U, 4U}) {
      for (std::uint32_t number = 0; number < ranks_[size].size(); ++number) {
        if (ranks_[size][number] == kNone) continue;
        Own& next = own.emplace_back(Own{0, {}, nullptr, size, number});
        next.about = squared_diameter<Filtered>(vertices(next));
        const double quotient = next.about.numerator.value / next.about.denominator.value;
        next.quotient = std::isfinite(quotient) ? quotient : 0;
      }
    }
    // Quotients have the order of the values, unless roundings are in the way.
    std::sort(own.begin(), own.end(), [](const Own& a, const Own& b) { return a.quotient < b.quotient; });
    const auto is_less = [this](const Own& a, const Own& b) { return compare(a, b) < 0; };
    if (!std::is_sorted(own.begin(), own.end(), is_less)) std::sort(own.begin(), own.end(), is_less);
    values_.reserve(own.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (k == 0 || compare(own[k - 1], own[k]) != 0) values_.push_back(vertices(own[k]));
      ranks_[own[k].size][own[k].number] = static_cast<Rank>(values_.size());
    }
    for (Facet facet = 0; facet < sides_.size(); ++facet) {
      if (!is_triangle(facet)) continue;
      Rank& rank = ranks_[3][facet];
      for (const Facet at : {facet, t_.mate(facet)}) {
        if (t_.dimension == 3 && at != kHull) rank = std::min(rank, ranks_[4][at / 4]);
      }
      for (const std::uint32_t side : sides_[facet]) ranks_[2][side] = std::min(ranks_[2][side], rank);
    }
  }
  static std::vector<std::uint32_t> in_order(const std::vector<Rank>& ranks) {
    std::vector<std::uint64_t> keys;  // in the upper half the rank
    for (std::uint32_t k = 0; k < ranks.size(); ++k) {
      if (ranks[k] != kNone) keys.push_back(std::uint64_t{ranks[k]} << 32 | k);
    }
    std::sort(keys.begin(), keys.end());
    return {keys.begin(), keys.end()};
  }

  void add(std::uint32_t dimension, Rank birth, Rank death) {
    if (birth != death) all_.push_back({dimension, birth, death});
  }
  static std::uint32_t& root(std::vector<std::uint32_t>& parents, std::uint32_t x) {
    while (parents[x] != x) x = parents[x] = parents[parents[x]];
    return parents[x];
  }
  // Joins the ends of edges, or the cells at triangles, in this order. It pairs each with what ceases to be the root of
  // a component: a root has the greatest rank. It returns those whose two sides are joined already.
  std::vector<std::uint32_t> join(std::uint32_t dimension, const std::vector<std::uint32_t>& order) {
    const std::vector<Rank>&ranks = ranks_[dimension == 0 ? 2 : 3], &roots = ranks_[dimension == 0 ? 1 : 4];
    const auto outside = static_cast<std::uint32_t>(t_.cells.size());
    std::vector<std::uint32_t> parents(roots.size()), others;
    std::iota(parents.begin(), parents.end(), 0);
    for (const std::uint32_t k : order) {
      std::uint32_t& x = root(parents, dimension == 0 ? edges_[k][0] : k / 4);
      std::uint32_t& y = root(parents, dimension == 0 ? edges_[k][1] : std::min(t_.mate(k) / 4, outside));
      if (x == y) {
        others.push_back(k);
        continue;
      }
      std::uint32_t &lower = roots[x] < roots[y] ? x : y, &upper = &lower == &x ? y : x;
      add(dimension, std::min(ranks[k], roots[lower]), std::max(ranks[k], roots[lower]));
      lower = upper;
    }
    return others;
  }
  // A column is a sum of boundaries: the places of its edges in the order. Earlier columns are added until it ends with
  // an edge that none of them ends with. The last edge of a cycle closes it, so that columns need no other edges.
  void pair_triangles(const std::vector<std::uint32_t>& closing, std::vector<std::uint32_t> triangles) {
    std::vector<std::uint32_t> place(edges_.size(), kNone), column, sum, columns;  // all columns, one after the other
    for (std::uint32_t k = 0; k < closing.size(); ++k) place[closing[k]] = k;
    std::vector<std::pair<std::size_t, std::size_t>> by_last(closing.size());  // by last edge: begin and end
    for (; !triangles.empty(); triangles.pop_back()) {
      column.clear();
      for (const std::uint32_t side : sides_[triangles.back()]) {
        if (place[side] != kNone) column.push_back(place[side]);
      }
      std::sort(column.begin(), column.end());
      while (by_last[column.back()].second != 0) {
        const auto [begin, end] = by_last[column.back()];
        sum.clear();
        std::set_symmetric_difference(column.begin(), column.end(), &columns[begin], &columns[end - 1] + 1,
                                      std::back_inserter(sum));
        column.swap(sum);
      }
      add(1, ranks_[2][closing[column.back()]], ranks_[3][triangles.back()]);
      by_last[column.back()] = {columns.size(), columns.size() + column.size()};
      columns.insert(columns.end(), column.begin(), column.end());
    }
  }

  const Points& points_;
  const Triangulation& t_;
  std::vector<Simplex> edges_;
  std::vector<std::array<std::uint32_t, 3>> sides_;  // of triangles: edges
  std::array<std::vector<Rank>, 5> ranks_;           // by number of vertices: of edges, triangles and cells
  std::vector<Simplex> values_;                      // by rank, from 1: a simplex that has the value
  std::vector<PersistencePair> all_;
};
