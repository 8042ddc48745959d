#include "morse/stable_regions.h"

#include <algorithm>
#include <utility>

#include "flowcert/sphere.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "morse/division_positions.h"
#include "morse/facet_regions.h"

namespace flowcert {

using namespace morse;

struct StableRegions::Parts {
  Parts(const VoronoiDiagram& voronoi, const FlowLimits& all)
      : diagram(voronoi), partition(LimitPartition::of(all)), faces(voronoi), positions(diagram, partition) {}

  void visit_ring(const FacetRing& ring, const Visit& visit) const;
  // A corner at a Voronoi vertex or at infinity.
  [[nodiscard]] DivisionPoint place(const RegionCorner& corner) const;
  [[nodiscard]] RationalPoint midpoint(const StableRegion& region) const;

  const VoronoiDiagram& diagram;
  const LimitPartition& partition;
  VoronoiFaces faces;
  DivisionPositions positions;
};

void StableRegions::Parts::visit_ring(const FacetRing& ring, const Visit& visit) const {
  StableRegion region;
  region.samples = diagram.names(ring.facet);
  const bool is_turned = diagram.name(ring.facet.v1) == region.samples[0];
  for (FacetRegion& found : regions_of(diagram, partition, ring)) {
    region.limit = found.limit == kInfinityLimit ? std::nullopt : std::optional<std::size_t>(found.limit);
    region.corners = std::move(found.corners);
    if (is_turned) std::ranges::reverse(region.corners);
    visit(region);
  }
}

StableRegions::StableRegions(const VoronoiDiagram& diagram, const FlowLimits& limits)
    : parts_(geometry::in_ieee_doubles([&] { return std::make_unique<Parts>(diagram, limits); })) {}
StableRegions::~StableRegions() = default;
StableRegions::StableRegions(StableRegions&&) noexcept = default;
StableRegions& StableRegions::operator=(StableRegions&&) noexcept = default;

// Each facet is visited from the first polygon that has its Delaunay edge.
void StableRegions::visit(const Visit& visit) {
  const geometry::IeeeDoubles ieee;
  Parts& all = *parts_;
  if (all.diagram.dimension() == 1) {
    for (CellIndex edge = 0; edge < all.diagram.delaunay().finite_count; ++edge) {
      const auto& v = all.diagram.delaunay().vertices(edge);
      all.visit_ring({kNoRing, facet_name(v[0], v[1]), {}}, visit);
    }
  }
  std::vector<bool> is_visited;
  for_each_polygon(all.diagram, [&](PolygonRef polygon) {
    for (const PolygonSide& side : all.diagram.sides(polygon)) {
      const FacetName facet = side.facet();
      const FacetRing ring = all.faces.ring(facet, all.diagram.cell_of_side(polygon, facet));
      if (ring.id >= is_visited.size()) is_visited.resize(2 * std::size_t{ring.id} + 1, false);
      if (!is_visited[ring.id]) all.visit_ring(ring, visit);
      is_visited[ring.id] = true;
    }
  });
}

RationalPoint StableRegions::Parts::midpoint(const StableRegion& region) const {
  const PointSet& points = diagram.points();
  return exact_midpoint(points.at_row(region.samples[0]), points.at_row(region.samples[1]));
}

DivisionPoint StableRegions::Parts::place(const RegionCorner& corner) const {
  if (corner.kind == RegionCorner::Kind::kVertex) return {DivisionPoint::Kind::kVertex, corner.number};
  return {DivisionPoint::Kind::kEnd, corner.number, {0, 0}, corner.end};
}

RationalPoint StableRegions::exact(const StableRegion& region, const RegionCorner& corner) {
  const geometry::IeeeDoubles ieee;
  Parts& all = *parts_;
  if (corner.kind == RegionCorner::Kind::kMidpoint) return all.midpoint(region);
  if (corner.kind == RegionCorner::Kind::kDivision) return all.positions.exact(corner.number);
  return all.positions.exact_face(all.place(corner));
}

Point StableRegions::rounded(const StableRegion& region, const RegionCorner& corner) {
  const geometry::IeeeDoubles ieee;
  Parts& all = *parts_;
  if (corner.kind == RegionCorner::Kind::kDivision) return all.positions.rounded(corner.number);
  if (corner.kind != RegionCorner::Kind::kMidpoint) return all.positions.rounded_face(all.place(corner));
  return rounded_point(all.midpoint(region));
}

}  // namespace flowcert
