// See voronoi_faces.h.
#include "voronoi/voronoi_faces.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/rational_point.h"

namespace flowcert::voronoi {

namespace {

// Rings up to this size are searched from end to end.
constexpr std::uint32_t kSmallRing = 16;
constexpr PolygonRef kNoPolygon{kNoCell, 0};

// The vertices of facet i of a positively oriented cell, counterclockwise seen from outside.
constexpr unsigned kOutward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

unsigned place_in(const std::array<VertexIndex, 4>& vertices, VertexIndex v) {
  return unsigned{vertices[1] == v} + 2 * unsigned{vertices[2] == v} + 3 * unsigned{vertices[3] == v};
}

bool contains(const std::array<VertexIndex, 4>& vertices, VertexIndex v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

FacetName facet_name(VertexIndex v, VertexIndex w) { return {std::min(v, w), std::max(v, w)}; }

bool before(PolygonRef a, PolygonRef b) { return std::tie(a.cell, a.index) < std::tie(b.cell, b.index); }

std::variant<CompactDelaunay, PlanarComplex, VoronoiComplex> make_complex(const Delaunay& delaunay,
                                                                          FilterTally& tally) {
  CompactDelaunay copy = compact_copy(delaunay);
  if (copy.dimension == 3) return VoronoiComplex(std::move(copy), tally);
  if (copy.dimension == 2) return PlanarComplex(std::move(copy), tally);
  return copy;
}

}  // namespace

VoronoiFaces::VoronoiFaces(const Delaunay& delaunay, FilterTally& tally)
    : dimension_(delaunay.dimension()), complex_(make_complex(delaunay, tally)) {}

const CompactDelaunay& VoronoiFaces::delaunay() const {
  if (spatial() != nullptr) return spatial()->delaunay();
  return planar() != nullptr ? planar()->delaunay() : std::get<CompactDelaunay>(complex_);
}

std::vector<CellIndex> VoronoiFaces::cells_of(CellIndex cluster) const {
  if (complex().is_alone(cluster)) return {cluster};
  const auto cells = complex().large_cluster_of(cluster);
  return {cells.begin(), cells.end()};
}

// The facets of a polygon of several; empty for one.
std::span<const FacetRef> VoronoiFaces::large_polygon(PolygonRef polygon) const {
  if (complex().role(polygon) != VoronoiComplex::FacetRole::kPiece) return {};
  return complex().large_polygon(complex().large_polygon_of(polygon));
}

PolygonRef VoronoiFaces::polygon(FacetRef facet) const {
  if (const PlanarComplex* plane = planar()) {
    return {plane->polygons()[plane->polygon_of(facet.cell)].front(), 3};
  }
  if (!delaunay().is_finite(facet.cell)) facet = delaunay().mirror(facet);
  if (const auto pieces = large_polygon(facet); !pieces.empty()) return pieces.front();
  const FacetRef mirror = complex().mirror(facet);
  return mirror.cell < facet.cell ? mirror : facet;  // infinite cells come last
}

std::vector<PolygonSide> VoronoiFaces::sides(PolygonRef polygon) const {
  if (const PlanarComplex* plane = planar()) {
    std::vector<PolygonSide> sides;
    for (const CellIndex cell : plane->polygons()[plane->polygon_of(polygon.cell)]) {
      const auto& v = delaunay().vertices(cell);
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (plane->is_diagonal({cell, i})) continue;
        const FacetName side = facet_name(v[(i + 1) % 3], v[(i + 2) % 3]);
        sides.push_back({side.v0, side.v1, plane->angle(cell, i)});
      }
    }
    return sides;
  }
  const auto pieces = large_polygon(polygon);
  return sides_of(complex(), pieces.empty() ? std::span<const FacetRef>(&polygon, 1) : pieces);
}

PolygonDriver VoronoiFaces::driver(PolygonRef polygon) const {
  // Most are one acute facet, which its signs tell.
  if (spatial() != nullptr && complex().role(polygon) == VoronoiComplex::FacetRole::kWhole &&
      complex().signs(polygon.cell).is_acute(polygon.index)) {
    return {Sign::kPositive, {}};
  }
  PolygonDriver driver{Sign::kPositive, {}};
  for (const PolygonSide& side : sides(polygon)) {
    driver.shape = std::min(driver.shape, side.angle);
    if (side.angle == Sign::kNegative) driver.side = {side.v0, side.v1};
  }
  return driver;
}

std::array<VertexIndex, 3> VoronoiFaces::corners(PolygonRef polygon) const {
  const auto& v = delaunay().vertices(polygon.cell);
  const auto& order = kOutward[polygon.index];
  return {v[order[0]], v[order[1]], v[order[2]]};
}

CellIndex VoronoiFaces::end(PolygonRef polygon, std::size_t side) const {
  if (planar() != nullptr) return kNoCell;
  const CellIndex cell = side == 0 ? polygon.cell : delaunay().neighbors(polygon.cell)[polygon.index];
  return delaunay().is_finite(cell) ? complex().cluster(cell) : kNoCell;
}

// ---- Facets.

FacetRing VoronoiFaces::ring(FacetName facet, CellIndex hint) {
  if (dimension_ < 2) return {0, {}, {}};
  const std::uint64_t key = (std::uint64_t{facet.v0} << 32) | facet.v1;
  const auto [entry, is_new] = ring_of_.try_emplace(key, static_cast<std::uint32_t>(rings_.size()));
  if (is_new) {
    rings_.push_back({static_cast<std::uint32_t>(elements_.size()), 0});
    const CellIndex cell = cell_with(facet, hint);
    spatial() != nullptr ? add_spatial_ring(facet, cell) : add_planar_ring(facet, cell);
    rings_.back().count = static_cast<std::uint32_t>(elements_.size()) - rings_.back().first;
    if (rings_.back().count > kSmallRing) sort_large_ring(rings_.back());
  }
  const Ring& ring = rings_[entry->second];
  return {entry->second, std::span(elements_).subspan(ring.first, ring.count),
          std::span(pieces_).subspan(ring.first, ring.count)};
}

// Where the boundary passes from one polygon to the next, through a Voronoi vertex or at infinity.
void VoronoiFaces::add_junction(CellIndex cell, VertexIndex apex_before, VertexIndex apex_after) {
  if (cell != kNoCell) {
    elements_.push_back({cell, kInfiniteVertex, 0});
    return;
  }
  elements_.push_back({kNoCell, apex_before, 1});
  pieces_.push_back({kNoPolygon, kInfiniteVertex});
  elements_.push_back({kNoCell, apex_after, -1});
}

// Goes around v0 v1, counterclockwise seen from v1: in a positively oriented cell v0 v1 k l, from the facet
// that has k to the one that has l. Facets inside of a cluster, and those between two infinite cells, bound
// nothing.
void VoronoiFaces::add_spatial_ring(FacetName facet, CellIndex start) {
  struct Crossing {
    PolygonRef polygon;
    VertexIndex apex;
    CellIndex after;  // the Voronoi vertex behind it; kNoCell: infinity
  };
  std::vector<Crossing> crossings;
  const auto& v = delaunay().vertices(start);
  const unsigned i0 = place_in(v, facet.v0), i1 = place_in(v, facet.v1);
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
    const unsigned behind = place_in(vertices, pivot);
    const unsigned ahead = 6 - behind - place_in(vertices, facet.v0) - place_in(vertices, facet.v1);
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

// A slab between two lines, or a half plane beside one: each line comes from infinity and goes there.
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
  const auto count = static_cast<std::ptrdiff_t>(ring.elements.size());
  if (ring.elements.size() <= kSmallRing) {
    std::size_t k = 0;
    while (ring.elements[k].vertex != cluster) ++k;
    return k;
  }
  const auto places = order_.begin() + rings_[ring.id].order + count;
  return *std::lower_bound(places, places + count, cluster, [&ring](std::uint32_t k, CellIndex value) {
    return ring.elements[k].vertex < value;
  });
}

// ---- Finding faces.

// All cells that have p, the infinite ones too.
// Valid until the next star. The cells that were seen bear the number of their star: a set of them was most
// of the time.
template <class IsWanted>
std::span<const CellIndex> VoronoiFaces::star_until(VertexIndex p, const IsWanted& is_wanted) {
  const CompactDelaunay& cells = delaunay();
  const auto corners = static_cast<unsigned>(dimension_) + 1;
  if (incident_cell_.empty()) {
    incident_cell_.assign(cells.points.size(), kNoCell);
    for (CellIndex cell = 0; cell < cells.finite_count; ++cell) {
      for (unsigned i = 0; i < corners; ++i) incident_cell_[cells.vertices(cell)[i]] = cell;
    }
    seen_in_star_.assign(cells.cells.size(), 0);
  }
  ++star_number_;
  star_.assign(1, incident_cell_[p]);
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

// A finite one, given that there is one.
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
  if (dimension_ < 1) return found;
  for (const CellIndex cell : star(p)) {
    for (const VertexIndex v : delaunay().vertices(cell)) {
      if (v != p && v != kInfiniteVertex) found.push_back(v);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Place VoronoiFaces::place_of(VertexIndex p, std::span<const VertexIndex> others) {
  if (others.empty()) return Place::in_cell(p);
  if (others.size() == 1) return Place::on_facet(facet_name(p, others.front()));
  const auto is_contact = [&](VertexIndex v) {
    return v == p || std::find(others.begin(), others.end(), v) != others.end();
  };
  const auto corners = static_cast<unsigned>(dimension_) + 1;
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
      edge = Place::on_edge(polygon({cell, dimension_ == 2 ? 3 : missing}));
    }
  }
  return edge;
}

// A sample that is not the nearest has a Delaunay neighbour that is nearer. The samples at one distance, all
// of them vertices of one Delaunay polytope, are connected by its edges.
Place VoronoiFaces::locate(const RationalPoint& x) {
  VertexIndex nearest = 0;
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

std::vector<VertexIndex> VoronoiFaces::contact(const Place& place) const {
  std::vector<VertexIndex> contact;
  switch (place.kind) {
    case Place::Kind::kVertex:
      for (const CellIndex cell : cells_of(place.vertex)) {
        const auto& v = delaunay().vertices(cell);
        contact.insert(contact.end(), v.begin(), v.end());
      }
      break;
    case Place::Kind::kEdge:
      for (const PolygonSide& side : sides(place.edge)) {
        contact.push_back(side.v0);
        contact.push_back(side.v1);
      }
      break;
    case Place::Kind::kFacet:
      contact = {place.facet.v0, place.facet.v1};
      break;
    case Place::Kind::kCell:
      contact = {place.sample};
      break;
    case Place::Kind::kInfinity:
      break;
  }
  std::sort(contact.begin(), contact.end());
  contact.erase(std::unique(contact.begin(), contact.end()), contact.end());
  return contact;
}

}  // namespace flowcert::voronoi
