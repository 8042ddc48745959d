#include "voronoi/voronoi_faces.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/contract.h"
#include "geometry/rational_point.h"

namespace flowcert::voronoi {

namespace {

// Rings up to this size are searched from end to end.
constexpr std::uint32_t kSmallRing = 16;
constexpr PolygonRef kNoPolygon{kNoCell, 0};

bool contains(const std::array<VertexIndex, 4>& vertices, VertexIndex v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

bool before(PolygonRef a, PolygonRef b) { return std::tie(a.cell, a.index) < std::tie(b.cell, b.index); }

}  // namespace

// ---- Facets.

FacetRing VoronoiFaces::ring(FacetName facet, CellIndex hint) {
  FLOWCERT_REQUIRES(facet.v0 < facet.v1);
  if (dimension() < 2) return {0, {}, {}};
  const std::uint64_t key = (std::uint64_t{facet.v0} << 32) | facet.v1;
  auto entry = ring_of_.find(key);
  if (entry == ring_of_.end()) {
    rings_.push_back({static_cast<std::uint32_t>(elements_.size()), 0});
    const CellIndex cell = cell_with(facet, hint);
    diagram_.spatial() != nullptr ? add_spatial_ring(facet, cell) : add_planar_ring(facet, cell);
    rings_.back().count = static_cast<std::uint32_t>(elements_.size()) - rings_.back().first;
    if (rings_.back().count > kSmallRing) sort_large_ring(rings_.back());
    entry = ring_of_.emplace(key, static_cast<std::uint32_t>(rings_.size() - 1)).first;  // at last: the above may throw
  }
  const Ring& ring = rings_[entry->second];
  return {entry->second, std::span(elements_).subspan(ring.first, ring.count),
          std::span(pieces_).subspan(ring.first, ring.count)};
}

// Adds the passage from one polygon to the next, through a Voronoi vertex or at infinity.
void VoronoiFaces::add_junction(CellIndex cell, VertexIndex apex_before, VertexIndex apex_after) {
  if (cell != kNoCell) {
    elements_.push_back({cell, kInfiniteVertex, 0});
    return;
  }
  elements_.push_back({kNoCell, apex_before, 1});
  pieces_.push_back({kNoPolygon, kInfiniteVertex});
  elements_.push_back({kNoCell, apex_after, -1});
}

// Goes around v0 v1, counterclockwise seen from v1. In a positively oriented cell v0 v1 k l it goes from the facet
// that has k to the one that has l. A facet inside a cluster, or between two infinite cells, bounds nothing.
void VoronoiFaces::add_spatial_ring(FacetName facet, CellIndex start) {
  struct Crossing {
    PolygonRef polygon;
    VertexIndex apex;
    CellIndex after;  // the Voronoi vertex behind it; kNoCell: infinity
  };
  std::vector<Crossing> crossings;
  const auto& v = delaunay().vertices(start);
  const unsigned i0 = place_among(v, facet.v0), i1 = place_among(v, facet.v1);
  // v0 v1 k l is positive iff v0 v1 l is the outward order of the facet opposite k.
  unsigned k = 0, l = 0;
  for (k = 0; k < 4; ++k) {
    if (k == i0 || k == i1) continue;
    l = 6 - i0 - i1 - k;
    const auto& order = kOutward[k];
    const auto at = static_cast<unsigned>(std::find(order, order + 3, l) - order);
    if (order[(at + 1) % 3] == i0) break;
  }
  CellIndex cell = start;
  VertexIndex pivot = v[k];
  do {
    const auto& vertices = delaunay().vertices(cell);
    const unsigned behind = place_among(vertices, pivot);
    const unsigned ahead = 6 - behind - place_among(vertices, facet.v0) - place_among(vertices, facet.v1);
    const VertexIndex apex = vertices[ahead];
    const CellIndex next = delaunay().neighbors(cell)[behind];
    const bool here = delaunay().is_finite(cell), there = delaunay().is_finite(next);
    const bool is_inside = here && there && complex().cluster(cell) == complex().cluster(next);
    if ((here || there) && !is_inside) {
      crossings.push_back({polygon({cell, behind}), apex, there ? complex().cluster(next) : kNoCell});
    }
    pivot = apex;
    cell = next;
  } while (cell != start);

  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Crossing& before_it = crossings[i == 0 ? crossings.size() - 1 : i - 1];
    add_junction(before_it.after, before_it.apex, crossings[i].apex);
    pieces_.push_back({crossings[i].polygon, crossings[i].apex});
  }
}

// The facet is a slab between two lines, or a half plane beside one. Each line comes from infinity and goes there.
void VoronoiFaces::add_planar_ring(FacetName facet, CellIndex cell) {
  const auto& v = delaunay().vertices(cell);
  std::uint32_t i = 0;
  while (v[i] == facet.v0 || v[i] == facet.v1) ++i;
  const FacetRef across = delaunay().mirror({cell, i});
  if (!delaunay().is_finite(across.cell)) {
    add_junction(kNoCell, v[i], v[i]);
    pieces_.push_back({polygon({cell, 3}), v[i]});
    return;
  }
  const VertexIndex other = delaunay().vertices(across.cell)[across.index];
  add_junction(kNoCell, other, v[i]);
  pieces_.push_back({polygon({cell, 3}), v[i]});
  add_junction(kNoCell, v[i], other);
  pieces_.push_back({polygon({across.cell, 3}), other});
}

void VoronoiFaces::sort_large_ring(Ring& ring) {
  ring.order = static_cast<std::uint32_t>(order_.size());
  for (int twice = 0; twice < 2; ++twice) {
    for (std::uint32_t k = 0; k < ring.count; ++k) order_.push_back(k);
  }
  const auto places = order_.begin() + ring.order;
  std::sort(places, places + ring.count, [this, &ring](std::uint32_t a, std::uint32_t b) {
    return before(pieces_[ring.first + a].polygon, pieces_[ring.first + b].polygon);
  });
  std::sort(places + ring.count, places + 2 * std::ptrdiff_t{ring.count},
            [this, &ring](std::uint32_t a, std::uint32_t b) {
              return elements_[ring.first + a].vertex < elements_[ring.first + b].vertex;
            });
}

std::size_t VoronoiFaces::piece_of(const FacetRing& ring, PolygonRef polygon) const {
  FLOWCERT_REQUIRES(std::ranges::count(ring.pieces, polygon, &RingPiece::polygon) == 1);
  if (ring.pieces.size() <= kSmallRing) {
    std::size_t k = 0;
    while (ring.pieces[k].polygon != polygon) ++k;
    return k;
  }
  const auto places = order_.begin() + rings_[ring.id].order;
  return *std::lower_bound(
      places, places + static_cast<std::ptrdiff_t>(ring.pieces.size()), polygon,
      [&ring](std::uint32_t k, PolygonRef value) { return before(ring.pieces[k].polygon, value); });
}

std::size_t VoronoiFaces::element_of(const FacetRing& ring, CellIndex cluster) const {
  FLOWCERT_REQUIRES(std::ranges::count(ring.elements, cluster, &RingElement::vertex) == 1);
  const auto count = static_cast<std::ptrdiff_t>(ring.elements.size());
  if (ring.elements.size() <= kSmallRing) {
    std::size_t k = 0;
    while (ring.elements[k].vertex != cluster) ++k;
    return k;
  }
  const auto places = order_.begin() + rings_[ring.id].order + count;
  return *std::lower_bound(places, places + count, cluster,
                           [&ring](std::uint32_t k, CellIndex value) { return ring.elements[k].vertex < value; });
}

// ---- Finding faces.

// All cells that have p, the infinite ones too; valid until the next star. A cell that was seen bears the number of
// its star, because looking cells up in a set took most of the time.
template <class IsWanted>
std::span<const CellIndex> VoronoiFaces::star_until(VertexIndex p, const IsWanted& is_wanted) {
  const CompactDelaunay& cells = delaunay();
  const auto corners = static_cast<unsigned>(dimension()) + 1;
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
    const auto& v = delaunay().vertices(cell);
    return delaunay().is_finite(cell) && contains(v, facet.v0) && contains(v, facet.v1);
  };
  if (hint != kNoCell && has_both(hint)) return hint;
  return star_until(facet.v0, has_both).front();
}

std::vector<VertexIndex> VoronoiFaces::neighbors(VertexIndex p) {
  std::vector<VertexIndex> found;
  if (dimension() < 1) return found;
  for (const CellIndex cell : star(p)) {
    for (const VertexIndex v : delaunay().vertices(cell)) {
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
  const auto corners = static_cast<unsigned>(dimension()) + 1;
  Place edge;
  for (const CellIndex cell : star(p)) {
    if (!delaunay().is_finite(cell)) continue;
    const auto& v = delaunay().vertices(cell);
    unsigned missing = 0, count = 0;
    for (unsigned i = 0; i < corners; ++i) {
      if (is_contact(v[i])) {
        ++count;
      } else {
        missing = i;
      }
    }
    if (count == 4) return Place::at_vertex(complex().cluster(cell));
    if (count == 3 && edge.kind == Place::Kind::kInfinity) {
      edge = Place::on_edge(polygon({cell, dimension() == 2 ? 3 : missing}));
    }
  }
  return edge;
}

// A sample that is not the nearest has a Delaunay neighbour that is nearer. The samples at the least distance are all
// vertices of one Delaunay polytope, whose edges connect them.
Place VoronoiFaces::locate(const RationalPoint& x, std::optional<VertexIndex> hint) {
  FLOWCERT_REQUIRES(!delaunay().points.empty());
  VertexIndex& nearest = located_;
  nearest = hint.value_or(nearest);
  Rational least = squared_distance(x, point(nearest));
  for (bool moved = true; moved;) {
    moved = false;
    for (const VertexIndex v : neighbors(nearest)) {
      Rational distance = squared_distance(x, point(v));
      if (distance >= least) continue;
      least = std::move(distance);
      nearest = v;
      moved = true;
    }
  }
  std::vector<VertexIndex> others;
  for (const VertexIndex v : neighbors(nearest)) {
    if (squared_distance(x, point(v)) == least) others.push_back(v);
  }
  return place_of(nearest, others);
}

}  // namespace flowcert::voronoi
