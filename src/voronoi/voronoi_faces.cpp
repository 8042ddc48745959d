// A ring is read off the cells around its Delaunay edge, whose number each of them keeps.
#include "voronoi/voronoi_faces.h"

#include <algorithm>
#include <utility>

#include "geometry/contract.h"
#include "geometry/nearest_samples.h"
#include "voronoi/around_edge.h"

namespace flowcert::voronoi {

// ---- Rings

namespace {

// Rings up to this size are searched from end to end.
constexpr std::size_t kSmallRing = 16;

}  // namespace

FacetRing VoronoiFaces::ring(FacetName facet, CellIndex hint) {
  if (diagram_.dimension() < 2) return {kNoRing, facet, {}};
  return ring(number_of(facet, cell_with(facet, hint)));
}

RingNumber VoronoiFaces::number_of(FacetName facet, CellIndex cell) {
  FLOWCERT_REQUIRES(facet.v0 < facet.v1 && diagram_.dimension() >= 2 && diagram_.delaunay().is_finite(cell));
  if (number_at_.empty()) {
    std::array<RingNumber, 6> none{};
    none.fill(kNoRing);
    number_at_.assign(diagram_.delaunay().finite_count, none);
    // Room for all rings that there can be. Memory that is not used is not taken.
    const std::size_t incidences = 6 * diagram_.delaunay().cells.size();
    pieces_.reserve(incidences + incidences / 3);
    place_.reserve(incidences + incidences / 3);
  }
  const RingNumber id = number_at(cell, facet);
  return id != kNoRing ? id : add_ring(facet, cell);
}

RingNumber VoronoiFaces::add_ring(FacetName facet, CellIndex cell) {
  const auto id = static_cast<RingNumber>(pieces_.size());
  pieces_.push_back({facet.v0, facet.v1, 0, kNoNote});
  diagram_.spatial() != nullptr ? add_spatial_pieces(facet, cell, id) : add_planar_pieces(facet, cell, id);
  const auto count = static_cast<std::uint32_t>(pieces_.size() - id - 1);
  pieces_[id].packed = count;
  place_.resize(pieces_.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    place_[id + 1 + k] = static_cast<std::uint8_t>(std::min<std::uint32_t>(k, kFar));
  }
  if (count > kSmallRing) sort_large_ring(ring(id));
  return id;
}

// Adds the passage to a polygon, through a Voronoi vertex or over a piece at infinity, and the polygon.
void VoronoiFaces::add_piece(CellIndex vertex_before, PolygonRef polygon, VertexIndex apex) {
  if (vertex_before == kNoCell) pieces_.push_back({kInfiniteVertex, kNoCell});
  pieces_.push_back({apex, vertex_before, polygon.packed()});
}

// A facet inside a cluster, or between two infinite cells, bounds nothing.
void VoronoiFaces::add_spatial_pieces(FacetName facet, CellIndex start, RingNumber id) {
  const CompactDelaunay& delaunay = diagram_.delaunay();
  const VoronoiComplex& complex = diagram_.complex();
  const bool is_plain = complex.is_plain();
  bool here = delaunay.is_finite(start);
  AroundEdge at = around_edge(delaunay, facet, start);
  do {
    const CellIndex cell = at.cell;
    const VertexIndex apex = delaunay.vertices(cell)[at.apex];
    const AroundEdge next = next_around(complex, at);
    const bool there = delaunay.is_finite(next.cell);
    if (here) number_at_[cell][kEdgeBetween[at.v0][at.v1]] = id;
    if (here && there && is_plain) {
      // No face is merged, so that the faces are those of the triangulation.
      pieces_.push_back(
          {apex, cell, (next.cell < cell ? PolygonRef{next.cell, next.apex} : PolygonRef{cell, at.behind}).packed()});
    } else if ((here || there) && !(here && there && complex.cluster(cell) == complex.cluster(next.cell))) {
      add_piece(here ? complex.cluster(cell) : kNoCell, diagram_.polygon({cell, at.behind}), apex);
    }
    at = next;
    here = there;
  } while (at.cell != start);
}

// The facet is a slab between two lines, or a half plane beside one. Each line comes from infinity and goes there.
void VoronoiFaces::add_planar_pieces(FacetName facet, CellIndex cell, RingNumber id) {
  const CompactDelaunay& delaunay = diagram_.delaunay();
  const auto& v = delaunay.vertices(cell);
  std::uint32_t i = 0;
  while (v[i] == facet.v0 || v[i] == facet.v1) ++i;
  number_at(cell, facet) = id;
  add_piece(kNoCell, diagram_.polygon({cell, 3}), v[i]);
  const FacetRef across = delaunay.mirror({cell, i});
  if (!delaunay.is_finite(across.cell)) return;
  number_at(across.cell, facet) = id;
  add_piece(kNoCell, diagram_.polygon({across.cell, 3}), delaunay.vertices(across.cell)[across.index]);
}

void VoronoiFaces::sort_large_ring(const FacetRing& ring) {
  std::vector<std::uint32_t>& places = sorted_[ring.id];
  const auto count = static_cast<std::uint32_t>(ring.size());
  for (int twice = 0; twice < 2; ++twice) {
    for (std::uint32_t k = 0; k < count; ++k) places.push_back(k);
  }
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(count);
  std::sort(places.begin(), middle,
            [&ring](std::uint32_t a, std::uint32_t b) { return ring.pieces[a].packed < ring.pieces[b].packed; });
  std::sort(middle, places.end(),
            [&ring](std::uint32_t a, std::uint32_t b) { return ring.pieces[a].vertex < ring.pieces[b].vertex; });
}

// Of a large ring, places sorted by polygon come before those sorted by cluster.
template <std::uint32_t RingPiece::* member>
std::size_t VoronoiFaces::place_with(const FacetRing& ring, std::uint32_t value) const {
  FLOWCERT_REQUIRES(std::ranges::count(ring.pieces, value, member) == 1);
  if (ring.size() <= kSmallRing) {
    std::size_t k = 0;
    while (ring.pieces[k].*member != value) ++k;
    return k;
  }
  const std::size_t first = member == &RingPiece::packed ? 0 : ring.size();
  const auto places = std::span(sorted_.at(ring.id)).subspan(first, ring.size());
  return *std::ranges::lower_bound(places, value, {}, [&ring](std::uint32_t k) { return ring.pieces[k].*member; });
}

std::size_t VoronoiFaces::piece_of(const FacetRing& ring, PolygonRef polygon) const {
  return place_with<&RingPiece::packed>(ring, polygon.packed());
}
std::size_t VoronoiFaces::element_of(const FacetRing& ring, CellIndex cluster) const {
  return place_with<&RingPiece::vertex>(ring, cluster);
}

// It may lay out another ring.
RingNumber VoronoiFaces::find_next(RingNumber id, std::size_t k) {
  const PolygonRef polygon = pieces_[id + 1 + k].polygon();
  const PolygonDriver driver = diagram_.driver(polygon);
  RingNumber next = RingLink::kAlongEdge;
  if (driver.shape == Sign::kNegative) {
    const FacetRing other = ring(number_of(driver.side, diagram_.cell_of_side(polygon, driver.side)));
    next = other.id + 1 + static_cast<RingNumber>(piece_of(other, polygon));
  }
  pieces_[id + 1 + k].next = next;
  return next;
}

// To a piece of a ring so large that its place is not kept beside it.
RingLink VoronoiFaces::link_to_far(RingNumber id, std::size_t k) {
  const PolygonRef polygon = pieces_[id + 1 + k].polygon();
  const FacetName side = diagram_.driver(polygon).side;
  const FacetRing other = ring(number_of(side, diagram_.cell_of_side(polygon, side)));
  return {other.id, static_cast<std::uint32_t>(piece_of(other, polygon))};
}

// ---- Location

// All cells that have p, the infinite ones too; valid until the next star. A cell that was seen bears the number of
// its star, because looking cells up in a set took most of the time.
std::span<const CellIndex> VoronoiFaces::star_until(VertexIndex p, const auto& is_wanted) {
  const CompactDelaunay& cells = diagram_.delaunay();
  const auto corners = static_cast<unsigned>(diagram_.dimension()) + 1;
  if (seen_in_star_.empty()) {
    cell_of_.assign(cells.points.size(), kNoCell);
    for (CellIndex cell = 0; cell < cells.finite_count; ++cell) {
      for (unsigned i = 0; i < corners; ++i) cell_of_[cells.vertices(cell)[i]] = cell;
    }
    seen_in_star_.assign(cells.cells.size(), 0);
  }
  ++star_number_;
  star_.assign(1, cell_of_[p]);
  seen_in_star_[star_.front()] = star_number_;
  for (std::size_t k = 0; k < star_.size(); ++k) {
    const CellIndex cell = star_[k];
    if (is_wanted(cell)) return std::span(star_).subspan(k, 1);
    for (unsigned i = 0; i < corners; ++i) {
      const CellIndex next = cells.neighbors(cell)[i];
      if (cells.vertices(cell)[i] == p || seen_in_star_[next] == star_number_) continue;
      seen_in_star_[next] = star_number_;
      star_.push_back(next);
    }
  }
  return star_;
}

std::span<const CellIndex> VoronoiFaces::star(VertexIndex p) {
  return star_until(p, [](CellIndex) { return false; });
}

// Finds a finite cell that has both ends of the edge; there must be one.
CellIndex VoronoiFaces::cell_with(FacetName facet, CellIndex hint) {
  const auto has_both = [&](CellIndex cell) {
    return diagram_.delaunay().is_finite(cell) && diagram_.has_edge(cell, facet);
  };
  if (hint != kNoCell && has_both(hint)) return hint;
  return star_until(facet.v0, has_both).front();
}

std::vector<VertexIndex> VoronoiFaces::neighbors(VertexIndex p) {
  std::vector<VertexIndex> found;
  if (diagram_.dimension() < 1) return found;
  for (const CellIndex cell : star(p)) {
    for (const VertexIndex v : diagram_.delaunay().vertices(cell)) {
      if (v != p && v != kInfiniteVertex) found.push_back(v);
    }
  }
  keep_unique(found);
  return found;
}

Place VoronoiFaces::place_of(VertexIndex p, std::span<const VertexIndex> others) {
  if (others.empty()) return Place::in_cell(p);
  if (others.size() == 1) return Place::on_facet(facet_name(p, others.front()));
  const auto is_contact = [&](VertexIndex v) {
    return v == p || std::find(others.begin(), others.end(), v) != others.end();
  };
  const auto corners = static_cast<unsigned>(diagram_.dimension()) + 1;
  Place edge;
  for (const CellIndex cell : star(p)) {
    if (!diagram_.delaunay().is_finite(cell)) continue;
    const auto& v = diagram_.delaunay().vertices(cell);
    unsigned missing = 0, count = 0;
    for (unsigned i = 0; i < corners; ++i) {
      if (is_contact(v[i])) {
        ++count;
      } else {
        missing = i;
      }
    }
    if (count == 4) return Place::at_vertex(diagram_.complex().cluster(cell));
    if (count == 3 && edge.kind == Place::Kind::kInfinity) {
      edge = Place::on_edge(diagram_.polygon({cell, diagram_.dimension() == 2 ? 3 : missing}));
    }
  }
  return edge;
}

// A sample that is not the nearest has a Delaunay neighbour that is nearer. The samples at the least distance are all
// vertices of one Delaunay polytope, whose edges connect them.
Place VoronoiFaces::locate(const RationalPoint& x, std::optional<VertexIndex> hint) {
  FLOWCERT_REQUIRES(!diagram_.delaunay().points.empty());
  VertexIndex& nearest = located_;
  nearest = hint.value_or(nearest);
  const geometry::DistanceOrder order(x);
  std::vector<VertexIndex> others;
  for (bool moved = true; moved;) {
    moved = false;
    others.clear();
    for (const VertexIndex v : neighbors(nearest)) {
      const Sign farther = order.compare(diagram_.point(v), diagram_.point(nearest));
      if (farther == Sign::kZero) others.push_back(v);
      if (farther != Sign::kNegative) continue;
      nearest = v;
      moved = true;
    }
  }
  return place_of(nearest, others);
}

}  // namespace flowcert::voronoi
