#include "voronoi/voronoi_faces.h"

#include <algorithm>
#include <utility>

#include "geometry/contract.h"
#include "geometry/distance_order.h"

namespace flowcert::voronoi {

// ---- Facets.

FacetRing VoronoiFaces::ring(FacetName facet, CellIndex hint) {
  if (dimension() < 2) return {kNoRing, facet, {}};
  return rings_.ring(facet, cell_with(facet, hint));
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
  const auto has_both = [&](CellIndex cell) { return delaunay().is_finite(cell) && diagram_.has_edge(cell, facet); };
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
  const geometry::DistanceOrder order(x);
  std::vector<VertexIndex> others;
  for (bool moved = true; moved;) {
    moved = false;
    others.clear();
    for (const VertexIndex v : neighbors(nearest)) {
      const Sign farther = order.compare(point(v), point(nearest));
      if (farther == Sign::kZero) others.push_back(v);
      if (farther != Sign::kNegative) continue;
      nearest = v;
      moved = true;
    }
  }
  return place_of(nearest, others);
}

}  // namespace flowcert::voronoi
