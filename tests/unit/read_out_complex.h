// A merged Voronoi complex, read out for tests: what lies around each Delaunay edge, and which facets make up each
// polygon. Of a planar complex only the edges are read out.
//
// Guarantees: the result is made of what the complex says of single cells and facets, without a traversal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "voronoi/voronoi_complex.h"

namespace flowcert {

using namespace voronoi;

using EdgeKey = std::pair<VertexIndex, VertexIndex>;
inline EdgeKey key_of(VertexIndex u, VertexIndex v) { return {std::min(u, v), std::max(u, v)}; }

// What lies around a Delaunay edge.
struct AroundEdge {
  std::set<std::size_t> polygons;
  Sign least_angle = Sign::kPositive;
  bool on_hull = false;
};

// Numbers the polygons of a complex: large ones first, then whole facets. A facet's two sides have one number.
class Polygons {
 public:
  explicit Polygons(const VoronoiComplex& complex) : complex_(complex) {}
  std::size_t of(FacetRef facet) const {
    if (complex_.role(facet) == VoronoiComplex::FacetRole::kPiece) return complex_.large_polygon_of(facet);
    const FacetRef mirror = complex_.delaunay().mirror(facet);
    const FacetRef first = complex_.delaunay().is_finite(mirror.cell) && mirror.cell < facet.cell ? mirror : facet;
    return complex_.large_polygon_count() + 4 * std::size_t{first.cell} + first.index;
  }

 private:
  const VoronoiComplex& complex_;
};

inline Sign angle_of(const TetrahedronSigns& signs, unsigned facet, unsigned vertex) {
  const unsigned bit = TetrahedronSigns::angle_bit(facet, vertex);
  if (((signs.angle_negative >> bit) & 1u) != 0) return Sign::kNegative;
  return ((signs.angle_zero >> bit) & 1u) != 0 ? Sign::kZero : Sign::kPositive;
}

// Every facet of every cell tells what it knows of its three edges; together they have gone around each edge.
inline std::map<EdgeKey, AroundEdge> edges_of(const VoronoiComplex& complex) {
  std::map<EdgeKey, AroundEdge> edges;
  const CompactDelaunay& delaunay = complex.delaunay();
  const Polygons polygons(complex);
  for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
    const auto& v = delaunay.vertices(cell);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const bool is_interior = complex.role({cell, i}) == VoronoiComplex::FacetRole::kInterior;
      for (std::uint32_t j = 0; j < 4; ++j) {
        if (j == i) continue;
        std::vector<VertexIndex> ends;
        for (std::uint32_t k = 0; k < 4; ++k) {
          if (k != i && k != j) ends.push_back(v[k]);
        }
        AroundEdge& edge = edges[key_of(ends[0], ends[1])];
        edge.least_angle = std::min(edge.least_angle, angle_of(complex.signs(cell), i, j));
        if (!is_interior) edge.polygons.insert(polygons.of({cell, i}));
      }
    }
  }
  return edges;
}

inline std::map<EdgeKey, AroundEdge> edges_of(const PlanarComplex& complex) {
  std::map<EdgeKey, AroundEdge> edges;
  const CompactDelaunay& delaunay = complex.delaunay();
  for (std::size_t k = 0; k < complex.polygons().size(); ++k) {
    for (const CellIndex cell : complex.polygons()[k]) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto& v = delaunay.vertices(cell);
        AroundEdge& edge = edges[key_of(v[(i + 1) % 3], v[(i + 2) % 3])];
        edge.polygons.insert(k);
        edge.least_angle = std::min(edge.least_angle, complex.angle(cell, i));
        edge.on_hull = edge.on_hull || !delaunay.is_finite(delaunay.neighbors(cell)[i]);
      }
    }
  }
  return edges;
}

// The facets of each polygon, seen from one side.
inline std::map<std::size_t, std::vector<FacetRef>> facets_by_polygon(const VoronoiComplex& complex) {
  std::map<std::size_t, std::vector<FacetRef>> facets;
  const CompactDelaunay& delaunay = complex.delaunay();
  const Polygons polygons(complex);
  for (std::size_t k = 0; k < complex.large_polygon_count(); ++k) {
    for (const FacetRef facet : complex.large_polygon(k)) facets[k].push_back(facet);
  }
  for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (complex.role({cell, i}) != VoronoiComplex::FacetRole::kWhole) continue;
      std::vector<FacetRef>& whole = facets[polygons.of({cell, i})];
      if (whole.empty()) whole.push_back({cell, i});
    }
  }
  return facets;
}

}  // namespace flowcert
