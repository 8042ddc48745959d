// Going around a sector: along the arc counterclockwise, and back along the near side of the facet, in the order of
// its ring.
#include "morse/stable_sector.h"

#include <stdexcept>
#include <utility>

#include "flow/drivers.h"
#include "morse/polygon_turn.h"
#include "morse/unbounded_faces.h"

namespace flowcert::morse {

namespace {

// Whether the ring goes along the Voronoi edge of a piece from end 0 to end 1.
bool is_forward(const Diagram& diagram, const FacetRing& ring, const RingPiece& piece) {
  return has_turn(diagram, piece.polygon(), {ring.facet.v0, ring.facet.v1, piece.apex});
}

// Where a ray comes from: a place on the near side. Piece k of the chain begins at element k.
struct NearPlace {
  FrontNumber front;
  bool is_element;
  std::size_t k;
};

// Whether an element of the ring is the front at infinity.
bool is_end_at(const Diagram& diagram, const BackwardWalk& walk, const FacetRing& ring, std::size_t element,
               FrontNumber front) {
  return ring.pieces[element].vertex == kNoCell &&
         direction_of_element(diagram, ring, element) == walk.direction(front);
}

// Where the near side itself is unbounded, its end may be the front.
NearPlace near_place(const Diagram& diagram, BackwardWalk& walk, const FacetRing& ring, const ObtuseChain& chain,
                     FrontNumber front) {
  if (walk.is_at_infinity(front)) {
    for (const std::size_t k : {std::size_t{0}, std::size_t{chain.count}}) {
      if (is_end_at(diagram, walk, ring, (chain.first + k) % ring.size(), front)) return {front, true, k};
    }
  }
  const FrontNumber back = walk.step(front, ring.facet).front;
  const Place& place = walk.place(back);
  for (std::size_t k = 0; k < chain.count; ++k) {
    const RingPiece& piece = ring.pieces[(chain.first + k) % ring.size()];
    if (place.kind == Place::Kind::kVertex && piece.vertex == place.vertex) return {back, true, k};
    if (place.kind == Place::Kind::kEdge && piece.polygon() == place.edge) return {back, false, k};
  }
  throw std::logic_error("a ray that comes from no place of the near side");
}

SectorParts sector_between(VoronoiFaces& faces, BackwardWalk& walk, const FacetRing& ring, FrontNumber a,
                           FrontNumber b) {
  const Diagram& diagram = faces.diagram();
  FilterTally tally;
  const ObtuseChain chain = obtuse_chain(diagram, ring.facet, ring, tally);
  SectorParts parts;
  parts.corners = {a, b};
  parts.has_midpoint = chain.count == 0;
  if (parts.has_midpoint) return parts;
  const NearPlace from_b = near_place(diagram, walk, ring, chain, b), to_a = near_place(diagram, walk, ring, chain, a);
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
    const bool is_along = is_forward(diagram, ring, piece);
    parts.arcs.push_back({piece.polygon(), is_along ? from : next, is_along ? next : from});
    parts.corners.push_back(next);
    if (is_last) return parts;
    from = next;
  }
}

}  // namespace

SectorParts sector_of(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, const Arc& arc) {
  const FacetRing ring = faces.ring(facet, arc.polygon.cell);
  const RingPiece& piece = ring.pieces[faces.rings().piece_of(ring, arc.polygon)];
  return is_forward(faces.diagram(), ring, piece) ? sector_between(faces, walk, ring, arc.a, arc.b)
                                                  : sector_between(faces, walk, ring, arc.b, arc.a);
}

SectorParts sector_at_infinity(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, FrontNumber a, FrontNumber b,
                               CellIndex hint) {
  return sector_between(faces, walk, faces.ring(facet, hint), a, b);
}

}  // namespace flowcert::morse
