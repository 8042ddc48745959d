// What a worker keeps while it moves over a Voronoi diagram: the rings of the facets that it has met. It also finds
// where a point lies. The faces themselves are the diagram's, which all workers share.
//
// Guarantees: exact; the faces are those of spec clauses FC-VOR-01 to 04. A worker is not for two threads at once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/rational.h"
#include "geometry/floating_point.h"
#include "voronoi/diagram.h"
#include "voronoi/facet_rings.h"

namespace flowcert::voronoi {

class VoronoiFaces {
 public:
  // The diagram must outlive it. Throws as require_ieee_doubles() in a thread where filters could be wrong. O(1).
  explicit VoronoiFaces(const VoronoiDiagram& diagram) : diagram_(diagram.faces()), rings_(diagram_) {
    require_ieee_doubles();
  }

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
  [[nodiscard]] PolygonSides sides(PolygonRef polygon) const { return diagram_.sides(polygon); }
  [[nodiscard]] std::vector<VertexIndex> contact(const Place& place) const { return diagram_.contact(place); }

  // The bounds of a Voronoi facet, whose Delaunay edge must be one of a polygon's sides. The hint is a cell that may
  // have that edge, which spares a search.
  [[nodiscard]] FacetRing ring(FacetName facet, CellIndex hint = kNoCell);
  [[nodiscard]] FacetRings& rings() { return rings_; }
  [[nodiscard]] const FacetRings& rings() const { return rings_; }

  // The face that x lies in. It walks from sample to nearer sample, from the hint or from where the last walk ended,
  // so points that are near to one another take few steps. There must be points.
  [[nodiscard]] Place locate(const RationalPoint& x, std::optional<VertexIndex> hint = std::nullopt);
  // The face whose contact set is the sample p and `others`. Only those of `others` that are Delaunay neighbours of p
  // are needed.
  [[nodiscard]] Place place_of(VertexIndex p, std::span<const VertexIndex> others);
  // The Delaunay neighbours of a sample.
  [[nodiscard]] std::vector<VertexIndex> neighbors(VertexIndex p);

 private:
  // All cells around a vertex, infinite ones too. If one of them is wanted, it is that one alone.
  template <class IsWanted>
  [[nodiscard]] std::span<const CellIndex> star_until(VertexIndex p, const IsWanted& is_wanted);
  [[nodiscard]] std::span<const CellIndex> star(VertexIndex p);
  [[nodiscard]] CellIndex cell_with(FacetName facet, CellIndex hint);

  const Diagram& diagram_;
  VertexIndex located_ = 0;                  // where the latest walk ended
  std::vector<CellIndex> cell_of_;           // by vertex: a finite cell that has it
  std::vector<CellIndex> star_;              // the latest
  std::vector<std::uint32_t> seen_in_star_;  // by cell: the number of the latest star that it was seen in
  std::uint32_t star_number_ = 0;
  FacetRings rings_;
};

}  // namespace flowcert::voronoi
