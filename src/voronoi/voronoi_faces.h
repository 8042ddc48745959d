// What a worker keeps while it moves over a Voronoi diagram: a cyclic array for each facet that it has met, of what
// bounds the facet. It also finds where a point lies. The faces themselves are the diagram's, which all workers
// share.
//
// Guarantees: exact; the faces are those of spec clauses FC-VOR-01 to 04. A facet's array is made when the facet is
// first asked for, and kept. That takes O(k) for k Delaunay cells around its edge. Duplicate Voronoi vertices among
// them are merged there and then, so that no query meets them (paper, Proposition 1). A worker is not for two threads
// at once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "flowcert/rational.h"
#include "geometry/floating_point.h"
#include "voronoi/diagram.h"

namespace flowcert::voronoi {

// What bounds a facet, counterclockwise seen from v1: element k, then the piece k of the boundary between
// elements k and k+1, and so on around. An element is a Voronoi vertex, or the direction of a Voronoi ray at
// infinity; a piece is a Voronoi edge, or lies at infinity.
struct RingElement {
  CellIndex vertex;  // the cluster; kNoCell for a direction
  // For a direction: apex is a third point of the ray's polygon. factor is +1 for the far end of a ray that is
  // followed outwards, -1 for a ray that comes from infinity. The direction lies counterclockwise of a vector d of
  // the facet's plane iff factor * <d, apex - v0> > 0 (paper, Eq. 5: the ray is orthogonal to v0 v1 apex).
  VertexIndex apex;
  int factor;
};
struct RingPiece {
  PolygonRef polygon;  // cell kNoCell: at infinity
  VertexIndex apex;    // a point of the polygon other than v0 and v1
};
// A ring is valid until the next facet is asked for. If both spans are empty, the facet is a whole plane.
struct FacetRing {
  std::uint32_t id;
  std::span<const RingElement> elements;
  std::span<const RingPiece> pieces;
};

class VoronoiFaces {
 public:
  // The diagram must outlive it. Throws as require_ieee_doubles() in a thread where filters could be wrong. O(1).
  explicit VoronoiFaces(const VoronoiDiagram& diagram) : diagram_(diagram.faces()) { require_ieee_doubles(); }

  // The diagram, which all workers share.
  [[nodiscard]] const Diagram& diagram() const { return diagram_; }
  // The diagram answers these, and keeps nothing of a worker.
  [[nodiscard]] int dimension() const { return diagram_.dimension(); }
  [[nodiscard]] const CompactDelaunay& delaunay() const { return diagram_.delaunay(); }
  [[nodiscard]] const Point& point(VertexIndex vertex) const { return diagram_.point(vertex); }
  [[nodiscard]] const VoronoiComplex& complex() const { return diagram_.complex(); }
  [[nodiscard]] std::vector<CellIndex> cells_of(CellIndex cluster) const { return diagram_.cells_of(cluster); }
  [[nodiscard]] PolygonRef polygon(FacetRef facet) const { return diagram_.polygon(facet); }
  [[nodiscard]] PolygonDriver driver(PolygonRef polygon) const { return diagram_.driver(polygon); }
  [[nodiscard]] std::array<VertexIndex, 3> corners(PolygonRef polygon) const { return diagram_.corners(polygon); }
  [[nodiscard]] CellIndex end(PolygonRef polygon, std::size_t side) const { return diagram_.end(polygon, side); }
  [[nodiscard]] std::vector<PolygonSide> sides(PolygonRef polygon) const { return diagram_.sides(polygon); }
  [[nodiscard]] std::vector<VertexIndex> contact(const Place& place) const { return diagram_.contact(place); }

  // The bounds of a Voronoi facet, whose Delaunay edge must be one of a polygon's sides. The hint is a cell that may
  // have that edge, which spares a search.
  [[nodiscard]] FacetRing ring(FacetName facet, CellIndex hint = kNoCell);
  // The place in the ring of a Voronoi edge or vertex, which must bound the facet. O(log n).
  [[nodiscard]] std::size_t piece_of(const FacetRing& ring, PolygonRef polygon) const;
  [[nodiscard]] std::size_t element_of(const FacetRing& ring, CellIndex cluster) const;

  // The face that x lies in. It walks from sample to nearer sample, from the hint or from where the last walk ended,
  // so points that are near to one another take few steps. There must be points.
  [[nodiscard]] Place locate(const RationalPoint& x, std::optional<VertexIndex> hint = std::nullopt);
  // The face whose contact set is the sample p and `others`. Only those of `others` that are Delaunay neighbours of p
  // are needed.
  [[nodiscard]] Place place_of(VertexIndex p, std::span<const VertexIndex> others);
  // The Delaunay neighbours of a sample.
  [[nodiscard]] std::vector<VertexIndex> neighbors(VertexIndex p);

 private:
  struct Ring {
    std::uint32_t first, count;
    std::uint32_t order = 0;  // of a large ring: where its sorted places start in order_
  };

  // All cells around a vertex, infinite ones too. If one of them is wanted, it is that one alone.
  template <class IsWanted>
  [[nodiscard]] std::span<const CellIndex> star_until(VertexIndex p, const IsWanted& is_wanted);
  [[nodiscard]] std::span<const CellIndex> star(VertexIndex p);
  [[nodiscard]] CellIndex cell_with(FacetName facet, CellIndex hint);
  void add_spatial_ring(FacetName facet, CellIndex start);
  void add_planar_ring(FacetName facet, CellIndex cell);
  void add_junction(CellIndex cell, VertexIndex apex_before, VertexIndex apex_after);
  void sort_large_ring(Ring& ring);

  const Diagram& diagram_;
  VertexIndex located_ = 0;                  // where the latest walk ended
  std::vector<CellIndex> cell_of_;           // by vertex: a finite cell that has it
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
