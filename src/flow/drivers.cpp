// The flow leaves a Voronoi vertex through a polygon that has the vertex on its other side. It enters a facet through
// obtuse polygons.
#include "flow/drivers.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "geometry/contract.h"
#include "geometry/predicates.h"
#include "voronoi/around_edge.h"

namespace flowcert::flow {

// ---- From a Voronoi vertex ----

namespace {

// The polygons that bound the cluster's polytope, by the sign of their side.
struct Boundary {
  std::vector<PolygonRef> polygons;
  std::vector<PolygonRef> negative;
  std::vector<PolygonRef> zero;
};

Boundary boundary_of(const VoronoiDiagram& diagram, CellIndex cluster) {
  const VoronoiComplex& complex = diagram.complex();
  Boundary boundary;
  for (const CellIndex cell : diagram.cells_of(cluster)) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const FacetRef facet{cell, i};
      if (complex.role(facet) == VoronoiComplex::FacetRole::kInterior) continue;
      const PolygonRef polygon = diagram.polygon(facet);
      boundary.polygons.push_back(polygon);
      const Sign side = complex.side(facet);
      if (side == Sign::kNegative) boundary.negative.push_back(polygon);
      if (side == Sign::kZero) boundary.zero.push_back(polygon);
    }
  }
  keep_unique(boundary.polygons);
  keep_unique(boundary.negative);
  keep_unique(boundary.zero);
  return boundary;
}

// The polytope's edge that is obtuse in both its polygons.
FacetName doubly_obtuse_edge(const VoronoiDiagram& diagram, const Boundary& boundary) {
  std::vector<FacetName> obtuse;
  for (const PolygonRef polygon : boundary.polygons) {
    for (const PolygonSide& side : diagram.sides(polygon)) {
      if (side.angle == Sign::kNegative) obtuse.push_back(side.facet());
    }
  }
  std::ranges::sort(obtuse);
  const auto twice = std::ranges::adjacent_find(obtuse);
  if (twice == obtuse.end()) throw std::logic_error("a Voronoi vertex without a driver");
  return *twice;
}

// A Voronoi vertex of one cell. Its four facets are its polytope's polygons, and the cell has the signs of all of them.
VertexFlow lone_vertex_flow(const VoronoiDiagram& diagram, CellIndex cell) {
  const VoronoiComplex& complex = diagram.complex();
  const TetrahedronSigns& signs = complex.signs(cell);
  std::size_t negative = 0, zeros = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Sign side = complex.side({cell, i});
    zeros += side == Sign::kZero ? 1 : 0;
    if (side != Sign::kNegative) continue;
    ++negative;
    if (!signs.is_obtuse(i)) return {.way = VertexFlow::Way::kAlongEdge, .edge = diagram.polygon({cell, i})};
  }
  if (negative == 0) return {.index = {static_cast<std::uint8_t>(zeros == 0 ? 3 : zeros == 1 ? 2 : 1), 3}};
  // Facets i and j share an edge. Vertex j sees it in facet i, vertex i in facet j.
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto j = signs.obtuse_corner(i);
    if (!j || signs.angle(*j, i) != Sign::kNegative) continue;
    const auto [k, l] = other_two(i, *j);
    const auto& v = diagram.delaunay().vertices(cell);
    return {.way = VertexFlow::Way::kAcrossFacet, .facet = facet_name(v[k], v[l])};
  }
  throw std::logic_error("a Voronoi vertex without a driver");
}

}  // namespace

VertexSources vertex_sources(const VoronoiDiagram& diagram, CellIndex cluster) {
  FLOWCERT_REQUIRES(diagram.dimension() == 3);
  const Boundary boundary = boundary_of(diagram, cluster);
  VertexSources sources;
  std::vector<PolygonSide> sides;
  for (const PolygonRef polygon : boundary.polygons) {
    for (const PolygonSide& side : diagram.sides(polygon)) sides.push_back(side);
    const bool is_positive = std::ranges::find(boundary.negative, polygon) == boundary.negative.end() &&
                             std::ranges::find(boundary.zero, polygon) == boundary.zero.end();
    if (is_positive && diagram.driver(polygon).shape != Sign::kNegative) sources.polygons.push_back(polygon);
  }
  // At each edge, the lesser of its two angles comes first.
  std::ranges::sort(sides, {}, [](const PolygonSide& side) { return std::pair(side.facet(), side.angle); });
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
    if (sides[k].angle == Sign::kPositive) sources.edges.push_back(sides[k].facet());
  }
  return sources;
}

Sign side_at(const VoronoiDiagram& diagram, PolygonRef polygon, std::size_t end) {
  FLOWCERT_REQUIRES(diagram.dimension() == 3 && diagram.end(polygon, end) != kNoCell);
  const VoronoiComplex& complex = diagram.complex();
  return complex.side(end == 0 ? polygon : complex.mirror(polygon));
}

std::vector<PolygonRef> polygons_through(const VoronoiDiagram& diagram, CellIndex cluster) {
  FLOWCERT_REQUIRES(diagram.dimension() == 3);
  return boundary_of(diagram, cluster).zero;
}

VertexFlow vertex_flow(const VoronoiDiagram& diagram, CellIndex cluster) {
  FLOWCERT_REQUIRES(diagram.dimension() == 3);
  if (diagram.complex().is_alone(cluster)) return lone_vertex_flow(diagram, cluster);
  const Boundary boundary = boundary_of(diagram, cluster);
  if (boundary.negative.empty()) {
    // It lies in its polytope: inside, or in one polygon, or in the edge that two share.
    const std::size_t zeros = boundary.zero.size();
    return {.index = {static_cast<std::uint8_t>(zeros == 0 ? 3 : zeros == 1 ? 2 : 1), 3}};
  }
  for (const PolygonRef polygon : boundary.negative) {
    if (diagram.driver(polygon).shape == Sign::kNegative) continue;
    return {.way = VertexFlow::Way::kAlongEdge, .edge = polygon};
  }
  return {.way = VertexFlow::Way::kAcrossFacet, .facet = doubly_obtuse_edge(diagram, boundary)};
}

// ---- Into a facet ----

namespace {

// The angle of a piece; positive if the piece lies at infinity.
Sign angle_of(const VoronoiDiagram& diagram, FacetName facet, const RingPiece& piece) {
  if (!piece.is_finite()) return Sign::kPositive;
  // A polygon of one facet has the angle among its cell's signs.
  if (const VoronoiComplex* complex = diagram.spatial(); complex != nullptr) {
    const PolygonRef polygon = piece.polygon();
    if (complex->role(polygon) == VoronoiComplex::FacetRole::kWhole) {
      const std::uint32_t apex = place_among(diagram.delaunay().vertices(polygon.cell), piece.apex);
      return complex->signs(polygon.cell).angle(polygon.index, apex);
    }
  }
  FilterTally unused;
  return exact_sign(Angle{diagram.point(facet.v0), diagram.point(piece.apex), diagram.point(facet.v1)}, unused);
}

}  // namespace

// Edges of the near side follow one another, and the walk begins beside one of the far side. So the first one that it
// meets is alone iff the next one is not obtuse.
std::optional<NearEdge> only_near_edge(const VoronoiDiagram& diagram, FacetName facet, PolygonRef from) {
  const VoronoiComplex& complex = diagram.complex();
  const CompactDelaunay& delaunay = diagram.delaunay();
  if (!complex.is_alone(from.cell)) return std::nullopt;
  std::optional<NearEdge> found;
  AroundEdge at = around_edge(delaunay, facet, from.cell);
  do {
    const AroundEdge next = next_around(complex, at);
    const bool here = delaunay.is_finite(at.cell), there = delaunay.is_finite(next.cell);
    if (there && !complex.is_alone(next.cell)) return std::nullopt;
    // Between two infinite cells there is no Voronoi edge.
    const bool is_obtuse = here    ? complex.signs(at.cell).angle(at.behind, at.apex) == Sign::kNegative
                           : there ? complex.signs(next.cell).angle(next.apex, next.behind) == Sign::kNegative
                                   : false;
    if (is_obtuse) {
      if (found) return std::nullopt;
      found = {diagram.polygon({at.cell, at.behind}), delaunay.vertices(at.cell)[at.apex]};
    } else if (found) {
      return found;
    }
    at = next;
  } while (at.cell != from.cell);
  return found;
}

ObtuseChain obtuse_chain(const VoronoiDiagram& diagram, const FacetRing& ring) {
  const std::size_t n = ring.pieces.size();
  ObtuseChain chain;
  if (n == 0) return chain;
  const auto angle = [&](std::size_t k) { return angle_of(diagram, ring.facet, ring.pieces[k]); };
  const Sign first = angle(0);
  Sign before = n == 1 ? first : angle(n - 1);
  for (std::size_t k = 0; k < n; ++k) {
    const Sign here = k == 0 ? first : angle(k);
    if (here == Sign::kNegative) {
      ++chain.count;
      if (before != Sign::kNegative) chain.first = static_cast<std::uint32_t>(k);
    }
    if (here == Sign::kZero) {
      ++chain.right_count;
      // If the ring's last piece and its first one are both right, the first one is the later.
      const bool wraps = k + 1 == n && first == Sign::kZero && n > 2;
      if (!wraps) chain.right = static_cast<std::uint32_t>(k);
    }
    before = here;
  }
  return chain;
}

}  // namespace flowcert::flow
