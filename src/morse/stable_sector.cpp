// Going around a sector: along the arc counterclockwise, and back along the near side of the facet, in the order of
// its ring.
#include "morse/stable_sector.h"

#include <stdexcept>
#include <utility>

#include "flow/drivers.h"
#include "morse/polygon_turn.h"

namespace flowcert::morse {

namespace {

// Where a ray comes from: a place on the near side. Piece k of the chain begins at element k.
struct NearPlace {
  FrontNumber front;
  bool is_element;
  std::size_t k;
};

NearPlace near_place(BackwardWalk& walk, const FacetRing& ring, const ObtuseChain& chain, FrontNumber front) {
  const FrontNumber back = walk.step(front, ring.facet).front;
  const Place& place = walk.place(back);
  for (std::size_t k = 0; k < chain.count; ++k) {
    const RingPiece& piece = ring.pieces[(chain.first + k) % ring.size()];
    if (place.kind == Place::Kind::kVertex && piece.vertex == place.vertex) return {back, true, k};
    if (place.kind == Place::Kind::kEdge && piece.polygon() == place.edge) return {back, false, k};
  }
  throw std::logic_error("a ray that comes from no place of the near side");
}

}  // namespace

SectorParts sector_of(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, const Arc& arc) {
  const FacetRing ring = faces.ring(facet, arc.polygon.cell);
  FilterTally tally;
  const ObtuseChain chain = obtuse_chain(faces.diagram(), facet, ring, tally);
  const auto is_forward = [&](const RingPiece& piece) {
    return has_turn(faces.diagram(), piece.polygon(), {facet.v0, facet.v1, piece.apex});
  };
  FrontNumber a = arc.a, b = arc.b;
  if (!is_forward(ring.pieces[faces.rings().piece_of(ring, arc.polygon)])) std::swap(a, b);
  SectorParts parts;
  parts.corners = {a, b};
  parts.has_midpoint = chain.count == 0;
  if (parts.has_midpoint) return parts;
  const NearPlace from_b = near_place(walk, ring, chain, b), to_a = near_place(walk, ring, chain, a);
  parts.corners.push_back(from_b.front);
  FrontNumber from = from_b.front;
  for (std::size_t k = from_b.k;; ++k) {
    const RingPiece& piece = ring.pieces[(chain.first + k) % ring.size()];
    const bool is_last = k + (to_a.is_element ? 1 : 0) == to_a.k;
    FrontNumber next = to_a.front;
    if (!is_last) {
      parts.vertices.push_back(ring.pieces[(chain.first + k + 1) % ring.size()].vertex);
      next = walk.at_vertex(parts.vertices.back());
    }
    const bool is_along = is_forward(piece);
    parts.arcs.push_back({piece.polygon(), is_along ? from : next, is_along ? next : from});
    parts.corners.push_back(next);
    if (is_last) return parts;
    from = next;
  }
}

}  // namespace flowcert::morse
