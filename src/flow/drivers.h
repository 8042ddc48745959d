// Where the flow goes from a Voronoi vertex, along a Voronoi edge, across a facet, or nowhere; and through which
// edges it enters a facet.
//
// Guarantees: exact, from the signs of the merged polytope alone (spec clauses FC-SIGN-02 to 05); nothing is
// constructed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "flow/layer.h"
#include "flowcert/filter_tally.h"
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
  StationaryIndex index;        // kStays
  PolygonRef edge{kNoCell, 0};  // kAlongEdge: driven by its centre
  FacetName facet{0, 0};        // kAcrossFacet: driven by its midpoint
};

// An edge of a Voronoi vertex' polytope, with the angles at it in its two polygons, the lesser first (h of
// FC-SIGN-01). Both are zero iff its midpoint is the Voronoi vertex.
struct PolytopeEdge {
  FacetName facet;
  std::array<Sign, 2> angles;
  // Where the lesser angle is zero: the polygon that has it, whose centre is the edge's midpoint.
  PolygonRef right_polygon{kNoCell, 0};

  // Its facet leads to the Voronoi vertex (FC-STAB-03).
  [[nodiscard]] bool leads() const { return angles[0] == Sign::kPositive; }
};

// What flows into a Voronoi vertex.
struct VertexSources {
  std::vector<PolytopeEdge> edges;   // all of the polytope's
  std::vector<PolygonRef> polygons;  // whose Voronoi edges lead to it, from their centres
};
// dimension 3. In proportion to the number of facets of the cluster, but for sorting them.
[[nodiscard]] VertexSources vertex_sources(const Diagram& faces, CellIndex cluster);

// dimension 3. s(o, f) of a polygon at end 0 or 1 of its Voronoi edge, which must be a Voronoi vertex
// (FC-SIGN-03).
[[nodiscard]] Sign side_at(const Diagram& faces, PolygonRef polygon, std::size_t end);

// dimension 3. The polygons of the polytope that lie in a plane through the Voronoi vertex.
[[nodiscard]] std::vector<PolygonRef> polygons_through(const Diagram& faces, CellIndex cluster);

// dimension 3. In proportion to the number of facets of the cluster, which is 4 for most.
[[nodiscard]] VertexFlow vertex_flow(const Diagram& faces, CellIndex cluster);

// ---- Into a facet ----
// The Voronoi edges of a facet through which the flow enters it: those whose polygon is obtuse at the facet's
// Delaunay edge.
//
// Seen from the facet's midpoint m, which they separate from the facet, they are its near
// side: they follow one another in its ring, and rays from m meet them in clockwise order, seen from v1. None
// are obtuse iff m lies in the closed facet; then those at right angles pass through m: one inside which it
// lies, or two that meet in it (spec clause FC-SIGN-04).
struct ObtuseChain {
  std::uint32_t first = 0, count = 0;  // of the ring's pieces
  // Where none is obtuse: of the pieces at right angles, the last one in the ring's order, and how many.
  std::uint32_t right = 0, right_count = 0;
};

// O(n) for n pieces.
[[nodiscard]] ObtuseChain obtuse_chain(const Diagram& faces, FacetName facet, const FacetRing& ring,
                                       FilterTally& tally);

}  // namespace flowcert::flow
