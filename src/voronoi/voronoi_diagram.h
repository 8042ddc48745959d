// The faces of the merged Voronoi diagram and how they meet: Voronoi vertices and edges with their ends, and their
// contact sets. One interface serves inputs of every dimension. In a coplanar input Voronoi edges are whole lines and
// facets are slabs or half planes. In a collinear one facets are planes.
//
// Guarantees: exact; the faces are those of spec clauses FC-VOR-01 to 04. A diagram is constant once it is made, so
// threads share it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "voronoi/delaunay.h"
#include "voronoi/voronoi_complex.h"

namespace flowcert::voronoi {

// Names a Voronoi edge by one of the Delaunay facets that make up its polygon, always the same one. In a coplanar
// input it is "facet 3" of one of the polygon's triangles.
using PolygonRef = FacetRef;

// A Voronoi face of any dimension, or infinity.
struct Place {
  enum class Kind : std::uint8_t { kInfinity, kVertex, kEdge, kFacet, kCell };
  Kind kind = Kind::kInfinity;
  CellIndex vertex = kNoCell;            // kVertex: the cluster
  PolygonRef edge{kNoCell, 0};           // kEdge
  FacetName facet{0, 0};                 // kFacet
  VertexIndex sample = kInfiniteVertex;  // kCell

  [[nodiscard]] static Place at_vertex(CellIndex cluster) { return {.kind = Kind::kVertex, .vertex = cluster}; }
  [[nodiscard]] static Place on_edge(PolygonRef polygon) { return {.kind = Kind::kEdge, .edge = polygon}; }
  [[nodiscard]] static Place on_facet(FacetName facet) { return {.kind = Kind::kFacet, .facet = facet}; }
  [[nodiscard]] static Place in_cell(VertexIndex sample) { return {.kind = Kind::kCell, .sample = sample}; }
  friend bool operator==(const Place&, const Place&) = default;
};

// A polygon's driver is its centre if the polygon contains that, otherwise the middle of its obtuse side (spec
// section 6).
struct PolygonDriver {
  Sign shape;      // the least angle: negative iff the centre lies outside, zero iff it is the middle of a side
  FacetName side;  // where negative
};

class VoronoiDiagram {
 public:
  // O(cells), and sorting what is cospherical. The point set must outlive the diagram; the triangulation need not. The
  // counts are added to the tally, if one is given. Two threads must not use one triangulation here at once, because
  // this numbers the triangulation's cells. The diagram is the same for any number of threads that make it.
  explicit VoronoiDiagram(const Delaunay& delaunay, FilterTally* tally = nullptr, unsigned threads = 1,
                          const Progress& progress = {});
  VoronoiDiagram(const VoronoiDiagram&) = delete;
  VoronoiDiagram& operator=(const VoronoiDiagram&) = delete;

  [[nodiscard]] const PointSet& points() const { return *points_; }
  // Of the affine hull of the points: 0 to 3, -1 for no point.
  [[nodiscard]] int dimension() const { return delaunay_->dimension; }
  [[nodiscard]] const CompactDelaunay& delaunay() const { return *delaunay_; }
  [[nodiscard]] const Point& point(VertexIndex vertex) const { return delaunay_->points[vertex]; }
  // The name of a sample (PointSet), and the sample that has a name.
  [[nodiscard]] PointId name(VertexIndex vertex) const { return points_->name(delaunay_->ordinals[vertex]); }
  [[nodiscard]] VertexIndex named(PointId name) const { return vertex_of_[points_->ordinal_of_row(name)]; }
  // The names of a facet's samples, ascending.
  [[nodiscard]] std::array<PointId, 2> names(FacetName facet) const {
    const PointId a = name(facet.v0), b = name(facet.v1);
    return {std::min(a, b), std::max(a, b)};
  }

  // The first is null unless the points span R^3, the second unless they span a plane.
  [[nodiscard]] const VoronoiComplex* spatial() const { return spatial_; }
  [[nodiscard]] const PlanarComplex* planar() const { return planar_; }

  // Voronoi vertices, which exist in dimension 3 only.
  [[nodiscard]] const VoronoiComplex& complex() const { return *spatial_; }
  [[nodiscard]] std::vector<CellIndex> cells_of(CellIndex cluster) const;

  // Voronoi edges.
  [[nodiscard]] PolygonRef polygon(FacetRef facet) const;
  [[nodiscard]] PolygonDriver driver(PolygonRef polygon) const;
  // Three of the polygon's points; (b-a) x (c-a) points to end 1.
  [[nodiscard]] std::array<VertexIndex, 3> corners(PolygonRef polygon) const;
  // The Voronoi vertex at end 0 or 1; kNoCell at infinity.
  [[nodiscard]] CellIndex end(PolygonRef polygon, std::size_t side) const;
  [[nodiscard]] PolygonSides sides(PolygonRef polygon) const;
  [[nodiscard]] bool has_edge(CellIndex cell, FacetName edge) const;
  // A finite cell that has one of the polygon's sides. If the polygon has several facets, it need not be the one that
  // names it.
  [[nodiscard]] CellIndex cell_of_side(PolygonRef polygon, FacetName side) const;

  // All of a face's contact set, by ascending VertexIndex.
  [[nodiscard]] std::vector<VertexIndex> contact(const Place& place) const;

 private:
  [[nodiscard]] PolygonSides planar_sides(PolygonRef polygon) const;
  [[nodiscard]] std::span<const FacetRef> large_polygon(PolygonRef polygon) const;

  const PointSet* points_;
  // Collinear inputs and smaller ones need no more than the triangulation.
  std::variant<CompactDelaunay, PlanarComplex, VoronoiComplex> complex_;
  const VoronoiComplex* spatial_;
  const PlanarComplex* planar_;
  const CompactDelaunay* delaunay_;
  std::vector<VertexIndex> vertex_of_;  // by ordinal in the point set
};

// Calls use(polygon) once for each Voronoi edge, by the facet that names its polygon, in the order of cells. Inputs of
// dimension 1 and less have none.
void for_each_polygon(const VoronoiDiagram& diagram, const auto& use) {
  if (diagram.dimension() < 2) return;
  const VoronoiComplex* spatial = diagram.spatial();
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) {
    for (std::uint32_t i = spatial != nullptr ? 0 : 3; i < 4; ++i) {
      const FacetRef facet{cell, i};
      if (spatial != nullptr && spatial->role(facet) == VoronoiComplex::FacetRole::kInterior) continue;
      if (diagram.polygon(facet) == facet) use(PolygonRef(facet));
    }
  }
}

}  // namespace flowcert::voronoi
