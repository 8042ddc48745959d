// Where the flow goes from a Voronoi vertex (along a Voronoi edge, across a facet, or nowhere), and through which
// edges it enters a facet.
//
// Guarantees: exact, from the signs of the merged polytope alone (spec clauses FC-SIGN-02 to 05); nothing is
// constructed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "flow/layer.h"
#include "flowcert/stationary_index.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::flow {

// ---- From a Voronoi vertex ----

// The point that drives: the centre of the smallest sphere through one, two or three samples.
struct Driver {
  std::array<VertexIndex, 3> samples{kInfiniteVertex, kInfiniteVertex, kInfiniteVertex};
  std::uint8_t count = 0;
};

struct VertexFlow {
  enum class Way : std::uint8_t { kStays, kAlongEdge, kAcrossFacet };
  Way way = Way::kStays;
  StationaryIndex index{};      // kStays
  PolygonRef edge{kNoCell, 0};  // kAlongEdge: driven by its centre
  FacetName facet{0, 0};        // kAcrossFacet: driven by its midpoint
};

// What flows into a Voronoi vertex.
struct VertexSources {
  // The edges of its polytope that lead to it, ascending. They connect all samples of the polytope (FC-STAB-03).
  std::vector<FacetName> edges;
  std::vector<PolygonRef> polygons;  // whose Voronoi edges lead to it, from their centres
};
// Dimension 3 only. The time is in proportion to the number of facets of the cluster, apart from sorting them.
[[nodiscard]] VertexSources vertex_sources(const VoronoiDiagram& diagram, CellIndex cluster);

// Dimension 3 only. s(o, f) of a polygon at end 0 or 1 of its Voronoi edge, which must be a Voronoi vertex
// (FC-SIGN-03).
[[nodiscard]] Sign side_at(const VoronoiDiagram& diagram, PolygonRef polygon, std::size_t end);

// Dimension 3 only. The polygons of the polytope that lie in a plane through the Voronoi vertex.
[[nodiscard]] std::vector<PolygonRef> polygons_through(const VoronoiDiagram& diagram, CellIndex cluster);

// Dimension 3 only. The time is in proportion to the number of facets of the cluster, which is 4 for most.
[[nodiscard]] VertexFlow vertex_flow(const VoronoiDiagram& diagram, CellIndex cluster);

// ---- Into a facet ----
// The flow enters a facet through those Voronoi edges whose polygon is obtuse at the facet's Delaunay edge.
//
// They separate the facet's midpoint m from the facet, so they are the side of the facet that is near m. They follow
// one another in the ring, and rays from m meet them in clockwise order, seen from v1. None are obtuse iff m lies in
// the closed facet. Then the edges with a right angle pass through m: one inside which m lies, or two that meet in m
// (spec clause FC-SIGN-04).
struct ObtuseChain {
  std::uint32_t first = 0, count = 0;  // of the ring's pieces
  // If none is obtuse: the last piece with a right angle, in the ring's order, and how many there are.
  std::uint32_t right = 0, right_count = 0;
};

// The one edge of a facet's near side.
struct NearEdge {
  PolygonRef polygon;
  VertexIndex apex;  // a sample of the polygon other than the facet's two
};
// Dimension 3 only. Walks around the facet's Delaunay edge from a polygon with an acute angle there, and lays out no
// ring. Nothing where the near side has no edge or several, or where cells on the way are not alone in their clusters.
[[nodiscard]] std::optional<NearEdge> only_near_edge(const VoronoiDiagram& diagram, FacetName facet, PolygonRef from);

// O(n) for n pieces.
[[nodiscard]] ObtuseChain obtuse_chain(const VoronoiDiagram& diagram, const FacetRing& ring);

}  // namespace flowcert::flow
