// Where the flow goes from a Voronoi vertex: along a Voronoi edge, across a facet, or nowhere.
//
// Guarantees: exact, from the signs of the merged polytope alone (spec clauses FC-SIGN-02 to 05); nothing is
// constructed.
#pragma once

#include <array>
#include <cstdint>

#include "flowcert/stationary_points.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert {

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

// dimension 3. In proportion to the number of facets of the cluster, which is 4 for most.
[[nodiscard]] VertexFlow vertex_flow(const VoronoiFaces& faces, CellIndex cluster);

}  // namespace flowcert
