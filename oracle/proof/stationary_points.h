// Theorem 2: the stationary points that are no samples are, one to one, the simplices of the Delaunay triangulation whose
// circumcentre is in their relative interior, with no link vertex strictly inside the sphere around it; R1 to R3.
#pragma once

#include <set>

#include "edge_stars.h"

enum Kind : std::uint8_t {
  kSample,
  kIndex1,
  kIndex2,
  kIndex3,
  kRegular12,
  kRegular13,
  kRegular23
};  // in the list's order

struct StationaryPoint {
  Kind kind;
  std::array<Id, 4> simplex;   // whose circumcentre it is
  std::uint32_t contact, end;  // places in contact_ids()
};

class StationaryPoints {
 public:
  // is_cospherical: by cell, as the proof of the triangulation returns it.
  StationaryPoints(const Points& points, const Triangulation& triangulation,
                   const std::vector<std::uint8_t>& is_cospherical)
      : points_(points), triangulation_(triangulation), cells_(triangulation.cells) {
    for (Id p = 0; p < points.row_count(); ++p) {
      if (points.is_id(p)) add(kSample, {p, kNone, kNone, kNone}, {p});
    }
    if (cells_.empty()) return;
    find_spheres(is_cospherical);
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) find_at_cell(cell);
    for_each_edge(triangulation, [this](const EdgeStar& star) { find_at_edge(star); });
    std::sort(all_.begin(), all_.end(), [this](const StationaryPoint& a, const StationaryPoint& b) {
      if (a.kind != b.kind) return a.kind < b.kind;
      const Id* const ids = contact_ids_.data();
      return std::lexicographical_compare(ids + a.contact, ids + a.end, ids + b.contact, ids + b.end);
    });
  }

  const std::vector<StationaryPoint>& all() const { return all_; }
  const std::vector<Id>& contact_ids() const { return contact_ids_; }
  const std::array<std::size_t, 7>& counts() const { return counts_; }  // by kind

 private:
  // ---- Contact sets: all points on a sphere are the vertices of the cells that are connected by cospherical facets ----

  void find_spheres(const std::vector<std::uint8_t>& is_cospherical) {
    sphere_of_.assign(cells_.size(), kNone);
    for (std::uint32_t first = 0; first < cells_.size(); ++first) {
      if (is_cospherical[first] == 0 || sphere_of_[first] != kNone) continue;
      std::vector<std::uint32_t> found{first};
      const auto number = sphere_of_[first] = static_cast<std::uint32_t>(spheres_.size());
      std::vector<Id>& ids = spheres_.emplace_back();
      for (std::size_t k = 0; k < found.size(); ++k) {
        const std::uint32_t cell = found[k];
        ids.insert(ids.end(), cells_[cell].begin(), cells_[cell].begin() + triangulation_.dimension + 1);
        for (Facet i = 0; i < 4; ++i) {
          const std::uint32_t next = triangulation_.mates[cell][i] / 4;
          if ((is_cospherical[cell] >> i & 1) == 0 || sphere_of_[next] != kNone) continue;
          sphere_of_[next] = number;
          found.push_back(next);
        }
      }
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    }
  }
  std::vector<Id> on_sphere(std::uint32_t cell) const {
    if (sphere_of_[cell] != kNone) return spheres_[sphere_of_[cell]];
    std::vector<Id> ids(cells_[cell].begin(), cells_[cell].begin() + triangulation_.dimension + 1);
    std::sort(ids.begin(), ids.end());
    return ids;
  }
  // The points on the circle through the vertices of a triangle of the cell.
  std::vector<Id> on_circle(std::uint32_t cell, const Simplex& v) const {
    std::vector<Id> ids = on_sphere(cell);
    const auto is_off = [&](Id x) { return x != v[0] && x != v[1] && x != v[2] && !are_coplanar(v, x); };
    if (triangulation_.dimension == 3) ids.erase(std::remove_if(ids.begin(), ids.end(), is_off), ids.end());
    return ids;
  }
  bool are_coplanar(const Simplex& v, Id x) const {
    return points_.sign([&]<class N>() {
      return dot(points_.vector<N>(v[0], v[1]), cross(points_.vector<N>(v[0], v[2]), points_.vector<N>(v[0], x)));
    }) == 0;
  }

  void add(Kind kind, const Simplex& simplex, const std::vector<Id>& contact) {
    const auto begin = static_cast<std::uint32_t>(contact_ids_.size());
    contact_ids_.insert(contact_ids_.end(), contact.begin(), contact.end());
    all_.push_back({kind, simplex, begin, static_cast<std::uint32_t>(contact_ids_.size())});
    ++counts_[kind];
  }

  // R3. A tetrahedron with the circumcentre inside: index 3. The centre is on the inner side of a facet iff the opposite
  // vertex is outside of the smallest sphere through the facet.
  void find_at_cell(std::uint32_t cell) {
    const int d = triangulation_.dimension;
    if (d == 2) find_at_triangle(4 * cell + 3);  // with no opposite vertex
    if (d < 3) return;
    int outside = 0;
    for (Facet facet = 4 * cell; facet != 4 * cell + 4; ++facet) {
      if (outside == static_cast<int>(facet % 4) && side_of_opposite(facet) > 0) ++outside;
      if (triangulation_.mate(facet) >= facet) find_at_triangle(facet);
    }
    if (outside == 4) add(kIndex3, cells_[cell], on_sphere(cell));
  }

  // R2. A triangle with the circumcentre inside, which is one with acute angles. The opposite vertices of the cells at it
  // are its link vertices: with 0, 1, 2 of them on the sphere it is index 2; kind (2,3); index 3.
  void find_at_triangle(Facet facet) {
    const Simplex v = triangulation_.vertices(facet);
    for (std::size_t k = 0; k < 3; ++k) {
      if (side_of_sphere(points_, {v[(k + 1) % 3], v[(k + 2) % 3], kNone, kNone}, v[k]) <= 0) return;
    }
    std::uint32_t zero_cell = kNone;
    int zeros = 0;
    for (const Facet at : {facet, triangulation_.mate(facet)}) {
      if (triangulation_.dimension == 2 || at == kHull) continue;
      const int side = side_of_opposite(at);
      if (side < 0) return;
      if (side == 0) zero_cell = at / 4, ++zeros;
    }
    if (zeros == 0) return add(kIndex2, v, on_circle(facet / 4, v));
    add(zeros == 1 ? kRegular23 : kIndex3, v, on_sphere(zero_cell));
  }
  int side_of_opposite(Facet facet) const {
    return side_of_sphere(points_, triangulation_.vertices(facet), triangulation_.opposite(facet));
  }

  // R1. An edge. With a link vertices on its smallest sphere, and b tetrahedra that have all vertices on it:
  //   a = 0: index 1.  b = 0, a = 1: kind (1,2).  b = 0, a = 2: index 2.  b > 0, a = b: index 3.
  //   b > 0, a = b + 1: they make up a wedge. If its two sides are coplanar, kind (2,3), and if not, kind (1,3).
  void find_at_edge(const EdgeStar& star) {
    const Simplex& v = star.edge;
    const std::size_t size = star.spokes.size();
    std::vector<std::size_t> zeros;  // spokes
    std::vector<bool> is_zero(size);
    for (std::size_t k = 0; k < size; ++k) {
      const int sign = side_of_sphere(points_, v, star.spokes[k].link);
      if (sign < 0) return;
      if (sign > 0) continue;
      is_zero[k] = true;
      zeros.push_back(k);
    }
    if (zeros.empty()) return add(kIndex1, v, {v[0], v[1]});
    std::uint32_t zero_cell = kNone;
    std::set<Id> sides;  // the link vertices of one of the b tetrahedra, and not of two
    for (const std::size_t k : zeros) {
      const std::size_t next = (k + 1) % size;
      if (star.spokes[k].cell == kNone || !is_zero[next]) continue;
      zero_cell = star.spokes[k].cell;
      for (const Id x : {star.spokes[k].link, star.spokes[next].link}) {
        if (!sides.insert(x).second) sides.erase(x);
      }
    }
    if (zero_cell == kNone) {
      const auto [link, triangle, cell] = star.spokes[zeros[0]];
      add(zeros.size() == 1 ? kRegular12 : kIndex2, v, on_circle(triangle / 4, {v[0], v[1], link, kNone}));
    } else {
      const bool is_flat = sides.size() == 2 && are_coplanar({v[0], v[1], *sides.begin()}, *sides.rbegin());
      add(sides.empty() ? kIndex3 : is_flat ? kRegular23 : kRegular13, v, on_sphere(zero_cell));
    }
  }

  const Points& points_;
  const Triangulation& triangulation_;
  const std::vector<Simplex>& cells_;
  std::vector<std::vector<Id>> spheres_;  // those of more than one cell: the points on them
  std::vector<std::uint32_t> sphere_of_;  // by cell; kNone where it is that of no other cell
  std::vector<StationaryPoint> all_;
  std::vector<Id> contact_ids_;
  std::array<std::size_t, 7> counts_{};
};
