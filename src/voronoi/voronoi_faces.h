// The faces of the merged Voronoi diagram and how they meet, as the flow walks over them: Voronoi vertices
// and edges with their ends, facets with the cyclic array of what bounds them, and the face that a given
// point lies in. One interface for inputs of every dimension: in a coplanar input Voronoi edges are whole
// lines and facets slabs, in a collinear one facets are planes.
//
// Guarantees: exact; the faces are those of spec clauses FC-VOR-01 to 04. A facet's array is made when the
// facet is first asked for, and kept: O(k) for k Delaunay cells around its edge, the duplicate Voronoi
// vertices among them merged there and then, so that no query meets them (paper, Proposition 1). Not for two
// threads at once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <variant>
#include <vector>

#include "flowcert/filter_tally.h"
#include "flowcert/rational.h"
#include "voronoi/planar_complex.h"
#include "voronoi/voronoi_complex.h"

namespace flowcert::voronoi {

// A Voronoi edge: always the same one of the Delaunay facets that make up its polygon. In a coplanar input,
// "facet 3" of one of the polygon's triangles.
using PolygonRef = FacetRef;

// A Voronoi facet: the ends of its Delaunay edge.
struct FacetName {
  VertexIndex v0, v1;  // v0 < v1

  friend bool operator==(const FacetName&, const FacetName&) = default;
};

// A Voronoi face, as wide as what it is the face of.
struct Place {
  enum class Kind : std::uint8_t { kInfinity, kVertex, kEdge, kFacet, kCell };
  Kind kind = Kind::kInfinity;
  CellIndex vertex = kNoCell;            // kVertex: the cluster
  PolygonRef edge{kNoCell, 0};           // kEdge
  FacetName facet{0, 0};                 // kFacet
  VertexIndex sample = kInfiniteVertex;  // kCell

  [[nodiscard]] static Place at_vertex(CellIndex cluster) {
    Place place;
    place.kind = Kind::kVertex, place.vertex = cluster;
    return place;
  }
  [[nodiscard]] static Place on_edge(PolygonRef polygon) {
    Place place;
    place.kind = Kind::kEdge, place.edge = polygon;
    return place;
  }
  [[nodiscard]] static Place on_facet(FacetName facet) {
    Place place;
    place.kind = Kind::kFacet, place.facet = facet;
    return place;
  }
  [[nodiscard]] static Place in_cell(VertexIndex sample) {
    Place place;
    place.kind = Kind::kCell, place.sample = sample;
    return place;
  }
  friend bool operator==(const Place&, const Place&) = default;
};

// What bounds a facet, counterclockwise seen from v1: element k, then the piece k of the boundary between
// elements k and k+1, and so on around. An element is a Voronoi vertex, or the direction of a Voronoi ray at
// infinity; a piece is a Voronoi edge, or lies at infinity.
struct RingElement {
  CellIndex vertex;  // the cluster; kNoCell for a direction
  // Of a direction: a third point of the ray's polygon, and +1 for the far end of a ray that is followed
  // outwards, -1 for one that comes from infinity. It lies counterclockwise of a vector d of the facet's
  // plane iff factor * <d, apex - v0> > 0 (paper, Eq. 5: the ray is orthogonal to v0 v1 apex).
  VertexIndex apex;
  int factor;
};
struct RingPiece {
  PolygonRef polygon;  // cell kNoCell: at infinity
  VertexIndex apex;    // a point of the polygon other than v0 and v1
};
// Valid until the next facet is asked for. Both empty: the facet is a whole plane.
struct FacetRing {
  std::uint32_t id;
  std::span<const RingElement> elements;
  std::span<const RingPiece> pieces;
};

// A polygon's driver: its centre where the polygon contains it, otherwise the middle of its obtuse side
// (spec section 6).
struct PolygonDriver {
  Sign shape;  // the least angle: negative iff the centre lies outside, zero iff it is the middle of a side
  FacetName side;  // where negative
};

class VoronoiFaces {
 public:
  // O(cells).
  VoronoiFaces(const Delaunay& delaunay, FilterTally& tally);

  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] const CompactDelaunay& delaunay() const;
  [[nodiscard]] const Point& point(VertexIndex vertex) const { return delaunay().points[vertex]; }

  // Voronoi vertices; none but in dimension 3.
  [[nodiscard]] const VoronoiComplex& complex() const { return std::get<VoronoiComplex>(complex_); }
  [[nodiscard]] std::vector<CellIndex> cells_of(CellIndex cluster) const;

  // Voronoi edges.
  [[nodiscard]] PolygonRef polygon(FacetRef facet) const;
  [[nodiscard]] PolygonDriver driver(PolygonRef polygon) const;
  // Three of the polygon's points; (b-a) x (c-a) points to end 1.
  [[nodiscard]] std::array<VertexIndex, 3> corners(PolygonRef polygon) const;
  // The Voronoi vertex at end 0 or 1; kNoCell at infinity.
  [[nodiscard]] CellIndex end(PolygonRef polygon, std::size_t side) const;
  [[nodiscard]] std::vector<PolygonSide> sides(PolygonRef polygon) const;

  // Voronoi facets. The Delaunay edge must be one of a polygon's sides. The hint is a cell that may have it,
  // which spares a search.
  [[nodiscard]] FacetRing ring(FacetName facet, CellIndex hint = kNoCell);
  // Where in its ring a Voronoi edge or vertex is: O(log n).
  [[nodiscard]] std::size_t piece_of(const FacetRing& ring, PolygonRef polygon) const;
  [[nodiscard]] std::size_t element_of(const FacetRing& ring, CellIndex cluster) const;

  // The face that x lies in. A walk from sample to nearer sample. There must be points.
  [[nodiscard]] Place locate(const RationalPoint& x);
  // The face whose points have this contact set, given the sample p and those of the others that are Delaunay
  // neighbours of p, at least.
  [[nodiscard]] Place place_of(VertexIndex p, std::span<const VertexIndex> others);
  // All of a face's contact set, by ascending VertexIndex.
  [[nodiscard]] std::vector<VertexIndex> contact(const Place& place) const;
  // The Delaunay neighbours of a sample.
  [[nodiscard]] std::vector<VertexIndex> neighbors(VertexIndex p);

 private:
  struct Ring {
    std::uint32_t first, count;
    std::uint32_t order = 0;  // of a large ring: where its sorted places start in order_
  };

  [[nodiscard]] const VoronoiComplex* spatial() const { return std::get_if<VoronoiComplex>(&complex_); }
  [[nodiscard]] const PlanarComplex* planar() const { return std::get_if<PlanarComplex>(&complex_); }
  [[nodiscard]] std::span<const FacetRef> large_polygon(PolygonRef polygon) const;
  // All cells around a vertex, infinite ones too; or one that is wanted, if there is one.
  template <class IsWanted>
  [[nodiscard]] std::span<const CellIndex> star_until(VertexIndex p, const IsWanted& is_wanted);
  [[nodiscard]] std::span<const CellIndex> star(VertexIndex p);
  [[nodiscard]] CellIndex cell_with(FacetName facet, CellIndex hint);
  void add_spatial_ring(FacetName facet, CellIndex start);
  void add_planar_ring(FacetName facet, CellIndex cell);
  void add_junction(CellIndex cell, VertexIndex apex_before, VertexIndex apex_after);
  void sort_large_ring(Ring& ring);

  int dimension_;
  // Collinear inputs and smaller ones need no more than the triangulation.
  std::variant<CompactDelaunay, PlanarComplex, VoronoiComplex> complex_;
  std::vector<CellIndex> incident_cell_;     // by VertexIndex; made when first needed
  std::vector<CellIndex> star_;              // the latest
  std::vector<std::uint32_t> seen_in_star_;  // by cell: the number of the latest star that it was seen in
  std::uint32_t star_number_ = 0;
  std::unordered_map<std::uint64_t, std::uint32_t> ring_of_;
  std::vector<Ring> rings_;
  std::vector<RingElement> elements_;
  std::vector<RingPiece> pieces_;
  std::vector<std::uint32_t> order_;  // a large ring's places by polygon, then its places by cluster
};

}  // namespace flowcert::voronoi
