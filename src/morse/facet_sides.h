// A Voronoi facet as rays from the midpoint of its samples see it: they enter through its near side and leave through
// its far one.
//
// Guarantees: exact, by signs of the diagram alone; nothing is constructed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "flow/drivers.h"
#include "morse/layer.h"

namespace flowcert::morse {

// An end 0 or 1 of a Voronoi edge.
struct EdgeEnd {
  PolygonRef polygon;
  std::size_t end;
};

// Neighbouring pieces of a ring.
struct PieceRun {
  std::uint32_t first = 0, count = 0;
};

// Places count around the ring, so that place n of n pieces is place 0.
class FacetSides {
 public:
  // The diagram and the ring's pieces must outlive it. O(n) for n pieces.
  FacetSides(const VoronoiDiagram& diagram, const FacetRing& ring);

  [[nodiscard]] const FacetRing& ring() const { return ring_; }
  [[nodiscard]] std::size_t size() const { return ring_.size(); }
  [[nodiscard]] const RingPiece& piece(std::size_t k) const { return ring_.pieces[k % size()]; }
  // The element before piece k: a Voronoi vertex, or kNoCell where a Voronoi edge ends at infinity.
  [[nodiscard]] CellIndex vertex(std::size_t k) const { return piece(k).vertex; }
  [[nodiscard]] EdgeEnd end_at_infinity(std::size_t k) const;

  // Whether the ring goes along the Voronoi edge of piece k from end 0 to end 1. It goes along (p1-p0) x (apex-p0).
  [[nodiscard]] bool is_forward(std::size_t k) const;
  // The angle of the polygon of piece k at the facet's Delaunay edge; positive of a piece at infinity.
  [[nodiscard]] Sign angle(std::size_t k) const;

  // Rays cross the near side clockwise, seen from v1, and the far one counterclockwise. The near side is empty iff the
  // closed facet contains the midpoint.
  [[nodiscard]] PieceRun near() const { return {chain_.first, chain_.count}; }
  // Without pieces with a right angle, which lie on rays.
  [[nodiscard]] PieceRun far() const;
  // Where the near side is empty: the last piece with a right angle in the ring's order, and the first one. The
  // midpoint lies on it, or between both.
  [[nodiscard]] std::size_t last_right() const { return chain_.right; }
  [[nodiscard]] std::size_t first_right() const {
    return chain_.right_count == 2 ? ring_.before(chain_.right) : chain_.right;
  }

 private:
  const VoronoiDiagram* diagram_;
  FacetRing ring_;
  ObtuseChain chain_;
};

}  // namespace flowcert::morse
