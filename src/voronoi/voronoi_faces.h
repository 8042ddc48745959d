// What a worker keeps while it moves over a Voronoi diagram: what bounds the facets that it has met, a cyclic array for
// each, laid out once, side by side in memory. It also finds where a point lies.
//
// Guarantees: exact; the faces are those of spec clauses FC-VOR-01 to 04. A ring is made when it is first asked for,
// and kept. That takes O(k) for k Delaunay cells around its edge. Duplicate Voronoi vertices among them are merged
// there and then, so that no query meets them (paper, Proposition 1). Where the flow leaves one facet for another, the
// way to the other ring is looked up once. A worker is not for two threads at once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "flowcert/rational.h"
#include "geometry/floating_point.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::voronoi {

// Where a ring lies in memory, so that nothing has to be looked up to find it.
using RingNumber = std::uint32_t;
inline constexpr RingNumber kNoRing = 0xffffffffu;

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
// Where the flow goes on from the inside of a Voronoi edge.
struct RingLink {
  static constexpr RingNumber kUnknown = kNoRing;
  static constexpr RingNumber kAlongEdge = kNoRing - 1;

  RingNumber ring = kUnknown;  // the facet of the polygon's obtuse side, or kAlongEdge if there is none
  std::uint32_t place = 0;     // of the same Voronoi edge among the other ring's pieces
};
// Four pieces are a cache line.
struct RingPiece {
  static constexpr std::uint32_t kAtInfinity = 0xffffffffu;

  VertexIndex apex;                      // a point of the polygon other than v0 and v1
  CellIndex vertex;                      // the element before it: the cluster, or kNoCell for a direction
  std::uint32_t packed = kAtInfinity;    // the polygon
  RingNumber next = RingLink::kUnknown;  // VoronoiFaces::link(): the number of the piece that it leads to

  [[nodiscard]] bool is_finite() const { return packed != kAtInfinity; }
  // The piece must be finite.
  [[nodiscard]] PolygonRef polygon() const { return PolygonRef::unpacked(packed); }
};

// A ring is valid until the next facet is asked for. If there is no piece, the facet is a whole plane.
struct FacetRing {
  RingNumber id = kNoRing;
  FacetName facet{0, 0};
  std::span<const RingPiece> pieces;

  [[nodiscard]] std::size_t size() const { return pieces.size(); }
  [[nodiscard]] std::size_t before(std::size_t k) const { return (k == 0 ? pieces.size() : k) - 1; }
  [[nodiscard]] RingElement element(std::size_t k) const {
    const RingPiece &here = pieces[k], &last = pieces[before(k)];
    if (here.vertex != kNoCell) return {here.vertex, kInfiniteVertex, 0};
    return last.is_finite() ? RingElement{kNoCell, last.apex, 1} : RingElement{kNoCell, here.apex, -1};
  }
};

class VoronoiFaces {
 public:
  // The diagram, which all workers share, must outlive it. Throws as require_ieee_doubles() in a thread where filters
  // could be wrong. O(1).
  explicit VoronoiFaces(const VoronoiDiagram& diagram) : diagram_(diagram) { require_ieee_doubles(); }

  [[nodiscard]] const VoronoiDiagram& diagram() const { return diagram_; }

  // ---- Rings ----

  // The bounds of a Voronoi facet, whose Delaunay edge must be one of a polygon's sides. The hint is a cell that may
  // have that edge, which spares a search.
  [[nodiscard]] FacetRing ring(FacetName facet, CellIndex hint = kNoCell);
  // A ring that was asked for before.
  [[nodiscard]] FacetRing ring(RingNumber id) const {
    const RingPiece& header = pieces_[id];
    return {id, {header.apex, header.vertex}, {&header + 1, header.packed}};
  }
  // A number that a user of the rings may keep with one; kNoNote before.
  static constexpr std::uint32_t kNoNote = 0xffffffffu;
  [[nodiscard]] std::uint32_t& note(RingNumber id) { return pieces_[id].next; }

  // The place in the ring of a Voronoi edge or vertex, which must bound the facet. O(log n).
  [[nodiscard]] std::size_t piece_of(const FacetRing& ring, PolygonRef polygon) const;
  [[nodiscard]] std::size_t element_of(const FacetRing& ring, CellIndex cluster) const;

  // From piece k of a ring, which must be finite. It may lay out another ring.
  [[nodiscard]] RingLink link(RingNumber id, std::size_t k) {
    const RingNumber known = pieces_[id + 1 + k].next;
    const RingNumber next = known != RingLink::kUnknown ? known : find_next(id, k);
    if (next == RingLink::kAlongEdge) return {next, 0};
    const std::uint32_t place = place_[next];
    return place != kFar ? RingLink{next - 1 - place, place} : link_to_far(id, k);
  }
  // Prefetches what link(), and then the ring that it leads to, will need. Where g++ does not inline such a
  // function at once, it takes it for one without effect and leaves its calls out.
  [[gnu::always_inline]] void prefetch_link(const RingPiece& piece) const {
    if (piece.next < pieces_.size()) {
      constexpr std::size_t kLine = 4;  // pieces
      __builtin_prefetch(&place_[piece.next]);
      __builtin_prefetch(&pieces_[piece.next]);
      __builtin_prefetch(&pieces_[piece.next] - kLine);
      __builtin_prefetch(&pieces_[piece.next] - 2 * kLine);
      __builtin_prefetch(&pieces_[piece.next] + kLine);
    } else if (piece.is_finite()) {
      const CellIndex cell = piece.polygon().cell;
      __builtin_prefetch(&diagram_.complex().signs(cell));
      __builtin_prefetch(&diagram_.delaunay().cells[cell]);
      __builtin_prefetch(&number_at_[cell]);
    }
  }

  // ---- Location ----

  // The face that x lies in. It walks from sample to nearer sample, from the hint or from where the last walk ended,
  // so points that are near to one another take few steps. There must be points.
  [[nodiscard]] Place locate(const RationalPoint& x, std::optional<VertexIndex> hint = std::nullopt);
  // The face whose contact set is the sample p and `others`. Only those of `others` that are Delaunay neighbours of p
  // are needed.
  [[nodiscard]] Place place_of(VertexIndex p, std::span<const VertexIndex> others);
  // The Delaunay neighbours of a sample.
  [[nodiscard]] std::vector<VertexIndex> neighbors(VertexIndex p);

 private:
  // The place of a facet's number in a cell that has its Delaunay edge.
  [[nodiscard]] RingNumber& number_at(CellIndex cell, FacetName facet) {
    const auto& v = diagram_.delaunay().vertices(cell);
    return number_at_[cell][kEdgeBetween[place_among(v, facet.v0)][place_among(v, facet.v1)]];
  }
  [[nodiscard]] RingNumber add_ring(FacetName facet, CellIndex cell);
  void add_spatial_pieces(FacetName facet, CellIndex start, RingNumber id);
  void add_planar_pieces(FacetName facet, CellIndex cell, RingNumber id);
  void add_piece(CellIndex vertex_before, PolygonRef polygon, VertexIndex apex);
  // The place of the one piece whose member has this value.
  template <std::uint32_t RingPiece::* member>
  [[nodiscard]] std::size_t place_with(const FacetRing& ring, std::uint32_t value) const;
  [[nodiscard]] RingNumber find_next(RingNumber id, std::size_t k);
  [[nodiscard]] RingLink link_to_far(RingNumber id, std::size_t k);
  void sort_large_ring(const FacetRing& ring);
  // The number of the ring of a facet of which a finite cell has the Delaunay edge. Dimension 2 and 3.
  [[nodiscard]] RingNumber number_of(FacetName facet, CellIndex cell);
  // All cells around a vertex, infinite ones too. If one of them is wanted, it is that one alone.
  [[nodiscard]] std::span<const CellIndex> star_until(VertexIndex p, const auto& is_wanted);
  [[nodiscard]] std::span<const CellIndex> star(VertexIndex p);
  [[nodiscard]] CellIndex cell_with(FacetName facet, CellIndex hint);

  const VoronoiDiagram& diagram_;
  std::vector<std::array<RingNumber, 6>> number_at_;  // by finite cell and edge
  // Before the pieces of each ring there is its header: v0, v1, the number of pieces, and the note.
  std::vector<RingPiece> pieces_;
  // By number of a piece: its place in its ring. Pieces beyond have kFar.
  static constexpr std::uint8_t kFar = 255;
  std::vector<std::uint8_t> place_;
  // Large rings have their places here, sorted by polygon, and then sorted by cluster.
  std::unordered_map<RingNumber, std::vector<std::uint32_t>> sorted_;

  VertexIndex located_ = 0;                  // where the latest walk ended
  std::vector<CellIndex> cell_of_;           // by vertex: a finite cell that has it
  std::vector<CellIndex> star_;              // the latest
  std::vector<std::uint32_t> seen_in_star_;  // by cell: the number of the latest star that it was seen in
  std::uint32_t star_number_ = 0;
};

}  // namespace flowcert::voronoi
