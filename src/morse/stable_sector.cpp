// Going around a sector: along the arc counterclockwise, and back along the near side of the facet, in the order of
// its ring.
#include "morse/stable_sector.h"

#include <stdexcept>
#include <utility>

#include "morse/unbounded_faces.h"

namespace flowcert::morse {

namespace {

// Where a ray comes from: a place on the near side. Piece k of the chain begins at element k.
struct NearPlace {
  FrontNumber front;
  bool is_element;
  std::size_t k;
};

// Whether an element of the ring is the front at infinity.
bool is_end_at(const VoronoiDiagram& diagram, const BackwardWalk& walk, const FacetSides& sides, std::size_t element,
               FrontNumber front) {
  return sides.vertex(element) == kNoCell &&
         direction_of(diagram, sides.end_at_infinity(element)) == walk.direction(front);
}

// Where the near side itself is unbounded, its end may be the front.
NearPlace near_place(const VoronoiDiagram& diagram, BackwardWalk& walk, const FacetSides& sides, FrontNumber front) {
  const PieceRun near = sides.near();
  if (walk.is_at_infinity(front)) {
    for (const std::size_t k : {std::size_t{0}, std::size_t{near.count}}) {
      if (is_end_at(diagram, walk, sides, near.first + k, front)) return {front, true, k};
    }
  }
  const FrontNumber back = walk.step(front, sides.ring().facet).front;
  const Place& place = walk.place(back);
  for (std::size_t k = 0; k < near.count; ++k) {
    const RingPiece& piece = sides.piece(near.first + k);
    if (place.kind == Place::Kind::kVertex && piece.vertex == place.vertex) return {back, true, k};
    if (place.kind == Place::Kind::kEdge && piece.polygon() == place.edge) return {back, false, k};
  }
  throw std::logic_error("a ray that comes from no place of the near side");
}

SectorParts sector_between(const VoronoiDiagram& diagram, BackwardWalk& walk, const FacetSides& sides, FrontNumber a,
                           FrontNumber b) {
  SectorParts parts;
  parts.corners = {a, b};
  parts.has_midpoint = sides.near().count == 0;
  if (parts.has_midpoint) return parts;
  const NearPlace from_b = near_place(diagram, walk, sides, b), to_a = near_place(diagram, walk, sides, a);
  parts.corners.push_back(from_b.front);
  FrontNumber from = from_b.front;
  for (std::size_t k = from_b.k;; ++k) {
    const std::size_t piece = sides.near().first + k;
    const bool is_last = k + (to_a.is_element ? 1 : 0) == to_a.k;
    FrontNumber next = to_a.front;
    if (!is_last) {
      parts.vertices.push_back(sides.vertex(piece + 1));
      next = walk.at_vertex(parts.vertices.back());
    }
    const bool is_along = sides.is_forward(piece);
    parts.arcs.push_back({sides.piece(piece).polygon(), is_along ? from : next, is_along ? next : from});
    parts.corners.push_back(next);
    if (is_last) return parts;
    from = next;
  }
}

}  // namespace

SectorParts sector_of(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, const Arc& arc) {
  const FacetSides sides(faces.diagram(), faces.ring(facet, arc.polygon.cell));
  const bool is_along = sides.is_forward(faces.piece_of(sides.ring(), arc.polygon));
  return sector_between(faces.diagram(), walk, sides, is_along ? arc.a : arc.b, is_along ? arc.b : arc.a);
}

SectorParts sector_at_infinity(VoronoiFaces& faces, BackwardWalk& walk, FacetName facet, FrontNumber a, FrontNumber b,
                               CellIndex hint) {
  return sector_between(faces.diagram(), walk, FacetSides(faces.diagram(), faces.ring(facet, hint)), a, b);
}

}  // namespace flowcert::morse
