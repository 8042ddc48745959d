// Theorem FC-CERT-03: the stationary points that are no samples are, one to one, the simplices of the triangulation
// whose circumcentre is in their relative interior, with no link vertex strictly inside the sphere around it. Their
// kinds follow from what is on that sphere (FC-CERT-04): R1 is for edges, R2 for triangles and R3 for tetrahedra.
#pragma once

#include <set>

#include "edge_stars.h"

enum Kind : std::uint8_t { kSample, kIndex1, kIndex2, kIndex3, kRegular12, kRegular13, kRegular23 };

struct StationaryPoint {
  Kind kind;
  std::vector<Id> contact;  // ascending
  Simplex simplex;          // whose circumcentre it is
  auto operator<=>(const StationaryPoint&) const = default;
};

class StationaryPoints {
 public:
  // is_cospherical: by cell, as the proof of the triangulation returns it.
  StationaryPoints(const Points& points, const Triangulation& triangulation,
                   const std::vector<std::uint8_t>& is_cospherical)
      : points_(points), t_(triangulation), sphere_of_(t_.cells.size(), kNone) {
    for (Id p = 0; p < points.row_count(); ++p) {
      if (points.is_id(p)) add(kSample, {p, kNone, kNone, kNone}, {p});
    }
    find_spheres(is_cospherical);
    for (std::uint32_t cell = 0; cell < t_.cells.size(); ++cell) find_at_cell(cell);
    for_each_edge(t_, [this](const EdgeStar& star) { find_at_edge(star); });
    std::sort(all_.begin(), all_.end());
  }

  const std::vector<StationaryPoint>& all() const { return all_; }      // in the order of a list
  const std::array<std::size_t, 7>& counts() const { return counts_; }  // by kind

 private:
  void add(Kind kind, const Simplex& simplex, std::vector<Id> contact) {
    all_.push_back({kind, std::move(contact), simplex});
    ++counts_[kind];
  }

  // All points on a sphere are the vertices of the cells that are connected by cospherical facets.
  void find_spheres(const std::vector<std::uint8_t>& is_cospherical) {
    for (std::uint32_t first = 0; first < t_.cells.size(); ++first) {
      if (is_cospherical[first] == 0 || sphere_of_[first] != kNone) continue;
      const auto number = sphere_of_[first] = static_cast<std::uint32_t>(spheres_.size());
      std::vector<Id>& ids = spheres_.emplace_back();
      std::vector<std::uint32_t> cells{first};
      for (std::size_t k = 0; k < cells.size(); ++k) {
        for (Facet i = 0; i < t_.places(); ++i) {
          ids.push_back(t_.cells[cells[k]][i]);
          const std::uint32_t next = t_.mates[cells[k]][i] / 4;
          if ((is_cospherical[cells[k]] >> i & 1) == 0 || sphere_of_[next] != kNone) continue;
          sphere_of_[next] = number;
          cells.push_back(next);
        }
      }
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    }
  }
  std::vector<Id> on_sphere(std::uint32_t cell) const {
    if (sphere_of_[cell] != kNone) return spheres_[sphere_of_[cell]];
    std::vector<Id> ids(t_.cells[cell].begin(), t_.cells[cell].begin() + t_.places());
    std::sort(ids.begin(), ids.end());
    return ids;
  }
  // The points on the circle through the vertices of a triangle of the cell.
  std::vector<Id> on_circle(std::uint32_t cell, const Simplex& v) const {
    std::vector<Id> ids = on_sphere(cell);
    const auto is_off = [&](Id x) { return std::find(v.begin(), v.end(), x) == v.end() && !are_coplanar(v, x); };
    if (t_.dimension == 3) ids.erase(std::remove_if(ids.begin(), ids.end(), is_off), ids.end());
    return ids;
  }
  bool are_coplanar(const Simplex& v, Id x) const {
    return points_.sign([&]<class N>() {
      return dot(points_.vector<N>(v[0], v[1]), cross(points_.vector<N>(v[0], v[2]), points_.vector<N>(v[0], x)));
    }) == 0;
  }

  // R3. A tetrahedron with the circumcentre inside: index 3. The centre is on the inner side of a facet iff the
  // opposite vertex is outside of the smallest sphere through the facet (its power is twice the heights' product).
  void find_at_cell(std::uint32_t cell) {
    if (t_.dimension == 2) find_at_triangle(4 * cell + 3);  // which has no opposite vertex
    bool is_center_inside = t_.dimension == 3;
    for (Facet facet = 4 * cell; facet < 4 * cell + 4 && t_.dimension == 3; ++facet) {
      if (t_.mate(facet) > facet) find_at_triangle(facet);
      is_center_inside = is_center_inside && side_of_opposite(facet) > 0;
    }
    if (is_center_inside) add(kIndex3, t_.cells[cell], on_sphere(cell));
  }
  int side_of_opposite(Facet facet) const { return side_of_sphere(points_, t_.vertices(facet), t_.opposite(facet)); }

  // R2. A triangle with the circumcentre inside, which is one with acute angles. The opposite vertices of the cells at
  // it are its link vertices: with 0, 1, 2 of them on the sphere it is index 2; kind (2,3); index 3.
  void find_at_triangle(Facet facet) {
    const Simplex v = t_.vertices(facet);
    for (std::size_t k = 0; k < 3; ++k) {
      if (side_of_sphere(points_, {v[(k + 1) % 3], v[(k + 2) % 3], kNone, kNone}, v[k]) <= 0) return;
    }
    std::vector<std::uint32_t> zero_cells;
    for (const Facet at : {facet, t_.mate(facet)}) {
      if (t_.dimension == 2 || at == kHull) continue;
      const int side = side_of_opposite(at);
      if (side < 0) return;
      if (side == 0) zero_cells.push_back(at / 4);
    }
    if (zero_cells.empty()) return add(kIndex2, v, on_circle(facet / 4, v));
    add(zero_cells.size() == 1 ? kRegular23 : kIndex3, v, on_sphere(zero_cells[0]));
  }

  // R1. An edge. With a link vertices on its smallest sphere, and b tetrahedra that have all vertices on it:
  //   a = 0: index 1.  b = 0, a = 1: kind (1,2).  b = 0, a = 2: index 2.  b > 0, a = b: index 3.
  //   b > 0, a = b + 1: they make up a wedge. If its two sides are coplanar, kind (2,3), and if not, kind (1,3).
  void find_at_edge(const EdgeStar& star) {
    const auto& [v, spokes] = star;
    std::vector<bool> is_zero;  // by spoke: its link vertex is on the sphere; a times
    for (const Spoke& spoke : spokes) {
      const int side = side_of_sphere(points_, v, spoke.link);
      if (side < 0) return;
      is_zero.push_back(side == 0);
    }
    const auto a = std::count(is_zero.begin(), is_zero.end(), true);
    if (a == 0) return add(kIndex1, v, {v[0], v[1]});
    std::vector<std::uint32_t> zero_cells;  // the b tetrahedra
    std::set<Id> sides;                     // link vertices of one of them, and not of two: none iff a = b
    for (std::size_t k = 0; k < spokes.size(); ++k) {
      const std::size_t next = (k + 1) % spokes.size();
      if (spokes[k].cell == kNone || !is_zero[k] || !is_zero[next]) continue;
      zero_cells.push_back(spokes[k].cell);
      for (const Id x : {spokes[k].link, spokes[next].link}) {
        if (!sides.insert(x).second) sides.erase(x);
      }
    }
    if (zero_cells.empty()) {
      const Spoke& spoke = *(spokes.begin() + (std::find(is_zero.begin(), is_zero.end(), true) - is_zero.begin()));
      return add(a == 1 ? kRegular12 : kIndex2, v, on_circle(spoke.triangle / 4, {v[0], v[1], spoke.link, kNone}));
    }
    if (sides.empty()) return add(kIndex3, v, on_sphere(zero_cells[0]));
    const bool is_flat = are_coplanar({v[0], v[1], *sides.begin(), kNone}, *sides.rbegin());
    add(is_flat ? kRegular23 : kRegular13, v, on_sphere(zero_cells[0]));
  }

  const Points& points_;
  const Triangulation& t_;
  std::vector<std::uint32_t> sphere_of_;  // by cell; kNone where no other cell has its sphere
  std::vector<std::vector<Id>> spheres_;  // the points on those of several cells
  std::vector<StationaryPoint> all_;
  std::array<std::size_t, 7> counts_{};
};
