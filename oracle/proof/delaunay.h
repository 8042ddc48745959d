// Theorem FC-CERT-02: if T0 to T8 hold, the cells are a Delaunay triangulation of the points. (T2 is in certificate.h.)
// B, o (here the middle of the first cell) and the inner side of a facet are those of FC-CERT-01.
#pragma once

#include <map>

#include "certificate.h"

class DelaunayProof {
 public:
  DelaunayProof(const Points& points, const Triangulation& triangulation)
      : points_(points), t_(triangulation), is_cospherical_(t_.cells.size()) {}

  // Returns, by cell, the bits i for which the cell across facet i has the same circumsphere.
  std::vector<std::uint8_t> prove() {
    check_dimension();
    if (t_.dimension < 1) return {};
    for (std::uint32_t cell = 0; cell < t_.cells.size(); ++cell) {
      if (volume_sign(cell) <= 0) reject("T1 " + name(4 * cell) + " has no positive volume");
      for (Facet facet = 4 * cell; facet < 4 * cell + t_.places(); ++facet) {
        check_neighbor(facet);
        if (t_.mate(facet) == kHull) hull_.push_back(facet);
      }
    }
    for (const Facet facet : hull_) check_middle(facet);
    check_ridges();
    for (const Facet facet : hull_) check_ray(facet);
    check_vertices();
    return std::move(is_cospherical_);
  }

 private:
  static std::string name(Facet facet) { return "cell " + std::to_string(facet / 4); }

  // The volume of the facet's cell with x in the opposite vertex's place, up to one positive factor; v: the vectors
  // from x to the others. In dimension 2 or 1 it is one component of the cross product, or of the vector.
  template <class N>
  N volume(Facet facet, const std::array<Vector<N>, 3>& v) const {
    const Vector<N> w = t_.dimension == 1 ? v[0] : cross(v[0], v[1]);
    const N value = t_.dimension == 3 ? dot(w, v[2]) : axis_ == 0 ? w.x : axis_ == 1 ? w.y : w.z;
    // An odd place changes the sign, and so does a reversed axis.
    return is_axis_reversed_ == (facet % 2 == 0) ? N{} - value : value;
  }
  int side_of_facet(Facet facet, Id x) const {
    const Simplex ids = t_.vertices(facet);
    return points_.sign([&]<class N>() {
      std::array<Vector<N>, 3> v{};
      for (std::size_t k = 0; ids[k] != kNone; ++k) v[k] = points_.vector<N>(x, ids[k]);
      return volume(facet, v);
    });
  }
  int volume_sign(std::uint32_t cell) const { return side_of_facet(4 * cell, t_.cells[cell][0]); }

  // T0. d is the dimension of the points: all of them lie in the affine hull of the first cell. In dimension 1 or 2 one
  // component tells the sign of each volume then, as all normals are parallel. In dimension 3, T1 is enough.
  void check_dimension() {
    const int d = t_.dimension;
    if (d < 1 && points_.point_count() != t_.places()) reject("T0 the points have another dimension");
    if (d != 1 && d != 2) return;
    const Simplex& v = t_.cells[0];
    while (axis_ < 3 && volume_sign(0) == 0) ++axis_;
    if (axis_ == 3) reject("T1 cell 0 has no volume");
    is_axis_reversed_ = volume_sign(0) < 0;
    for (Id x = 0; x < points_.row_count(); ++x) {
      const int is_off = points_.sign([&]<class N>() {
        const auto to_x = points_.vector<N>(v[0], x);
        const auto normal = cross(points_.vector<N>(v[0], v[1]), d == 1 ? to_x : points_.vector<N>(v[0], v[2]));
        return dot(normal, d == 1 ? normal : to_x);
      });
      if (is_off != 0) reject("T0 point " + std::to_string(x) + " is not in the affine hull of cell 0");
    }
  }

  // T3. For paired facets, the one cell's opposite vertex is not strictly inside the other's circumsphere. With T1 and
  // T2, it is the same to ask this the other way round, so it is asked once.
  void check_neighbor(Facet facet) {
    const Facet mate = t_.mate(facet);
    if (mate == kHull || mate < facet) return;
    const int side = side_of_sphere(points_, t_.cells[facet / 4], t_.opposite(mate));
    if (side < 0) reject("T3 " + name(facet) + " has a vertex of " + name(mate) + " inside its sphere");
    if (side > 0) return;
    is_cospherical_[facet / 4] |= static_cast<std::uint8_t>(1U << facet % 4);
    is_cospherical_[mate / 4] |= static_cast<std::uint8_t>(1U << mate % 4);
  }

  // T4. Every ridge of B is in exactly two facets of B, which induce opposite orientations.
  // T6. For two facets of B at a ridge, the second's opposite vertex is not strictly outside of the first. By T4, it is
  // the same the other way round.
  // In dimension 1, facets are points, and the one ridge is the empty set.
  void check_ridges() const {
    std::map<Simplex, std::vector<std::pair<Facet, Facet>>> ridges;  // of each: facets, and which vertex is not there
    for (const Facet facet : hull_) {
      for (Facet k = 0; k < t_.places() - 1; ++k) ridges[ridge(facet, k).ids].emplace_back(facet, k);
    }
    if (ridges.empty()) reject("T4 no facet is unpaired");
    for (const auto& [ids, facets] : ridges) {
      const auto [facet, k] = facets.front();
      const auto [other, l] = facets.back();
      if (facets.size() != 2) reject("T4 " + name(facet) + " has a ridge that is not of two facets of the hull");
      const bool is_odd = ridge(facet, k).is_odd != ridge(other, l).is_odd;
      if (is_odd == (facet % 2 != other % 2)) reject("T4 " + name(facet) + " has a facet not oriented as the next");
      if (side_of_facet(facet, t_.vertices(other)[l]) < 0) reject("T6 " + name(facet) + " has a reflex ridge");
    }
  }
  SortedIds ridge(Facet facet, Facet without) const {
    Simplex ids = t_.vertices(facet);
    ids[without] = kNone;
    return SortedIds(ids);
  }

  // T5. o is strictly on the inner side of every facet of B.
  void check_middle(Facet facet) const {
    const int side = points_.sign([&]<class N>() { return volume(facet, from_middle<N>(facet)); });
    if (side <= 0) reject("T5 " + name(facet) + " has a hull facet that is not seen from the middle of cell 0");
  }
  // The vectors from o to the facet's vertices, times d + 1.
  template <class N>
  std::array<Vector<N>, 3> from_middle(Facet facet) const {
    const Simplex ids = t_.vertices(facet);
    std::array<Vector<N>, 3> v{};
    for (std::size_t k = 0; ids[k] != kNone; ++k) {
      for (Facet i = 0; i < t_.places(); ++i) v[k] = v[k] + points_.vector<N>(t_.cells[0][i], ids[k]);
    }
    return v;
  }

  // T7. The ray from o through the middle of one facet of B, the first, meets no other closed facet of B.
  // It meets those where its vector is a sum of the vectors to the vertices with coefficients that are not negative. By
  // Cramer's rule and T5, these have the signs of the volumes where the ray's vector replaces one of the facet's.
  void check_ray(Facet facet) const {
    for (std::size_t k = 0; k + 1 < t_.places(); ++k) {
      const int coefficient = points_.sign([&]<class N>() {
        const auto to_first = from_middle<N>(hull_[0]);
        auto v = from_middle<N>(facet);
        v[k] = to_first[0] + to_first[1] + to_first[2];
        return volume(facet, v);
      });
      if (coefficient < 0 || facet == hull_[0]) return;
    }
    reject("T7 " + name(facet) + " and " + name(hull_[0]) + " have hull facets on one ray");
  }

  // T8. Every point is a vertex of a cell.
  void check_vertices() const {
    std::vector<bool> is_vertex(points_.row_count());
    for (const Simplex& cell : t_.cells) {
      for (Facet i = 0; i < t_.places(); ++i) is_vertex[cell[i]] = true;
    }
    for (Id p = 0; p < points_.row_count(); ++p) {
      if (points_.is_id(p) && !is_vertex[p]) reject("T8 point " + std::to_string(p) + " is a vertex of no cell");
    }
  }

  const Points& points_;
  const Triangulation& t_;
  int axis_ = 0;
  bool is_axis_reversed_ = false;
  std::vector<std::uint8_t> is_cospherical_;
  std::vector<Facet> hull_;  // B
};
