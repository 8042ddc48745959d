// The faces are read off the merged complexes. A Voronoi edge is named by one of its Delaunay facets.
#include "voronoi/voronoi_diagram.h"

#include <algorithm>
#include <utility>

#include "geometry/floating_point.h"

namespace flowcert::voronoi {

namespace {

std::variant<CompactDelaunay, PlanarComplex, VoronoiComplex> make_complex(const Delaunay& delaunay, FilterTally* tally,
                                                                          unsigned threads, const Progress& progress) {
  FilterTally unused;
  FilterTally& counted = tally != nullptr ? *tally : unused;
  CompactDelaunay copy = compact_copy(delaunay, threads);
  if (copy.dimension == 3) return VoronoiComplex(std::move(copy), counted, threads, progress);
  if (copy.dimension == 2) return PlanarComplex(std::move(copy), counted);
  return copy;
}

}  // namespace

VoronoiDiagram::VoronoiDiagram(const Delaunay& delaunay, FilterTally* tally, unsigned threads, const Progress& progress)
    : points_(&delaunay.points()),
      complex_(geometry::in_ieee_doubles([&] { return make_complex(delaunay, tally, threads, progress); })),
      spatial_(std::get_if<VoronoiComplex>(&complex_)),
      planar_(std::get_if<PlanarComplex>(&complex_)),
      delaunay_(spatial_ != nullptr  ? &spatial_->delaunay()
                : planar_ != nullptr ? &planar_->delaunay()
                                     : &std::get<CompactDelaunay>(complex_)),
      vertex_of_(delaunay_->ordinals.size()) {
  for (VertexIndex v = 0; v < vertex_of_.size(); ++v) vertex_of_[delaunay_->ordinals[v]] = v;
}

std::vector<CellIndex> VoronoiDiagram::cells_of(CellIndex cluster) const {
  if (spatial_->is_alone(cluster)) return {cluster};
  const auto cells = spatial_->large_cluster_of(cluster);
  return {cells.begin(), cells.end()};
}

// The facets of a polygon that has several; nothing for a polygon of one facet.
std::span<const FacetRef> VoronoiDiagram::large_polygon(PolygonRef polygon) const {
  if (spatial_->role(polygon) != VoronoiComplex::FacetRole::kPiece) return {};
  return spatial_->large_polygon(spatial_->large_polygon_of(polygon));
}

PolygonRef VoronoiDiagram::polygon(FacetRef facet) const {
  if (const PlanarComplex* plane = planar_) {
    return {plane->polygons()[plane->polygon_of(facet.cell)].front(), 3};
  }
  if (!delaunay_->is_finite(facet.cell)) facet = delaunay_->mirror(facet);
  if (const auto pieces = large_polygon(facet); !pieces.empty()) return pieces.front();
  const FacetRef mirror = spatial_->mirror(facet);
  return mirror.cell < facet.cell ? mirror : facet;  // infinite cells come last
}

PolygonSides VoronoiDiagram::planar_sides(PolygonRef polygon) const {
  PolygonSides sides;
  for (const CellIndex cell : planar_->polygons()[planar_->polygon_of(polygon.cell)]) {
    const auto& v = delaunay_->vertices(cell);
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (planar_->is_diagonal({cell, i})) continue;
      const FacetName side = facet_name(v[(i + 1) % 3], v[(i + 2) % 3]);
      sides.push_back({side.v0, side.v1, planar_->angle(cell, i)});
    }
  }
  return sides;
}

PolygonSides VoronoiDiagram::sides(PolygonRef polygon) const {
  if (planar_ != nullptr) return planar_sides(polygon);
  const auto pieces = large_polygon(polygon);
  return sides_of(*spatial_, pieces.empty() ? std::span<const FacetRef>(&polygon, 1) : pieces);
}

bool VoronoiDiagram::has_edge(CellIndex cell, FacetName edge) const {
  const auto& v = delaunay_->vertices(cell);
  return std::ranges::find(v, edge.v0) != v.end() && std::ranges::find(v, edge.v1) != v.end();
}

CellIndex VoronoiDiagram::cell_of_side(PolygonRef polygon, FacetName side) const {
  const auto has_side = [&](CellIndex cell) { return has_edge(cell, side); };
  if (has_side(polygon.cell)) return polygon.cell;
  if (planar_ != nullptr) {
    const auto& cells = planar_->polygons()[planar_->polygon_of(polygon.cell)];
    return *std::ranges::find_if(cells, has_side);
  }
  const auto pieces = large_polygon(polygon);
  return std::ranges::find_if(pieces, has_side, &FacetRef::cell)->cell;
}

PolygonDriver VoronoiDiagram::driver(PolygonRef polygon) const {
  // Most polygons are one facet, and the cell's signs suffice.
  if (spatial_ != nullptr && spatial_->role(polygon) == VoronoiComplex::FacetRole::kWhole) {
    const TetrahedronSigns& signs = spatial_->signs(polygon.cell);
    if (const auto corner = signs.obtuse_corner(polygon.index)) {
      const auto& v = delaunay_->vertices(polygon.cell);
      const auto [k, l] = other_two(polygon.index, *corner);
      return {Sign::kNegative, facet_name(v[k], v[l])};
    }
    return {signs.is_right(polygon.index) ? Sign::kZero : Sign::kPositive, {}};
  }
  PolygonDriver driver{Sign::kPositive, {}};
  for (const PolygonSide& side : sides(polygon)) {
    driver.shape = std::min(driver.shape, side.angle);
    if (side.angle == Sign::kNegative) driver.side = side.facet();
  }
  return driver;
}

std::array<VertexIndex, 3> VoronoiDiagram::corners(PolygonRef polygon) const {
  const auto& v = delaunay_->vertices(polygon.cell);
  const auto& order = kOutward[polygon.index];
  return {v[order[0]], v[order[1]], v[order[2]]};
}

CellIndex VoronoiDiagram::end(PolygonRef polygon, std::size_t side) const {
  if (planar_ != nullptr) return kNoCell;
  const CellIndex cell = side == 0 ? polygon.cell : delaunay_->neighbors(polygon.cell)[polygon.index];
  return delaunay_->is_finite(cell) ? spatial_->cluster(cell) : kNoCell;
}

std::vector<VertexIndex> VoronoiDiagram::contact(const Place& place) const {
  std::vector<VertexIndex> contact;
  switch (place.kind) {
    case Place::Kind::kVertex:
      for (const CellIndex cell : cells_of(place.vertex)) {
        const auto& v = delaunay_->vertices(cell);
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
  keep_unique(contact);
  return contact;
}

}  // namespace flowcert::voronoi
