// Both sides of a facet are gone through in the order in which rays from the midpoint meet them. The rays that separate
// regions are the same on both.
#include "morse/facet_regions.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace flowcert::morse {

namespace {

// A corner, or the place of a ray that separates two regions.
struct SideItem {
  RegionCorner corner;
  bool separates = false;
};

// What is met along one side: first and last a ray that separates, and between two of these the limit of a region.
struct FacetSide {
  std::vector<SideItem> items;
  std::vector<Limit> limits;
};

class FacetWalk {
 public:
  FacetWalk(const VoronoiDiagram& diagram, const LimitPartition& partition, const FacetRing& ring)
      : partition_(partition), sides_(diagram, ring) {}

  [[nodiscard]] std::vector<FacetRegion> regions() {
    go_along_far_side();
    if (sides_.near().count == 0) return triangles();
    go_along_near_side();
    return regions_between_rays();
  }

 private:
  [[nodiscard]] RegionCorner element(std::size_t k) const {
    if (sides_.vertex(k) != kNoCell) return {RegionCorner::Kind::kVertex, 0, sides_.vertex(k)};
    const auto [polygon, end] = sides_.end_at_infinity(k);
    return {RegionCorner::Kind::kEnd, static_cast<std::uint8_t>(end), polygon.packed()};
  }
  [[nodiscard]] RegionCorner corner_of(PointOfDivision number) const {
    const DivisionPoint& point = partition_.point(number);
    if (point.kind == DivisionPoint::Kind::kVertex) return {RegionCorner::Kind::kVertex, 0, point.from};
    return {RegionCorner::Kind::kDivision, 0, number};
  }

  // The divisions of a piece in the sense of the ring, or against it.
  void for_divisions(std::size_t k, bool with_ring, const auto& use) const {
    const RingPiece& piece = sides_.piece(k);
    if (!piece.is_finite()) return use(Division{kInfinityLimit});
    const std::span<const Division> divisions = partition_.edge(piece.polygon());
    const bool is_along = divisions.size() == 1 || sides_.is_forward(k) == with_ring;
    for (std::size_t i = 0; i < divisions.size(); ++i) use(divisions[is_along ? i : divisions.size() - 1 - i]);
  }

  // From an element to an element. All the way around, these are the same.
  void go_along_far_side() {
    const PieceRun far = sides_.far();
    far_.items.push_back({element(far.first), true});
    for (std::uint32_t i = 0; i < far.count; ++i) {
      const std::size_t k = far.first + i;
      if (i > 0) far_.items.push_back({element(k)});
      for_divisions(k, true, [&](const Division& division) { add_far(division); });
    }
    far_.items.push_back({element(far.first + far.count), true});
  }

  // An element that is followed by an arc separates unless its limit is that of both arcs beside it.
  void add_far(const Division& division) {
    if (!division.is_arc()) {
      far_.items.push_back({corner_of(division.point), true});
      return;
    }
    SideItem& last = far_.items.back();
    if (!last.separates) {
      if (limit_at(last.corner) == division.limit && far_.limits.back() == division.limit) return;
      last.separates = true;
    }
    far_.limits.push_back(division.limit);
  }
  [[nodiscard]] Limit limit_at(const RegionCorner& element) const {
    return element.kind == RegionCorner::Kind::kVertex ? partition_.limit_of_vertex(element.number) : kInfinityLimit;
  }

  void go_along_near_side() {
    const PieceRun near = sides_.near();
    near_.items.push_back({element(near.first + near.count), true});
    for (std::size_t left = near.count; left > 0; --left) {
      const std::size_t k = near.first + left - 1;
      for_divisions(k, false, [&](const Division& division) {
        if (!division.is_arc()) near_.items.push_back({corner_of(division.point), true});
      });
      if (left > 1) near_.items.push_back({element(k), partition_.point_behind(sides_.vertex(k)).has_value()});
    }
    near_.items.push_back({element(near.first), true});
  }

  // The facet contains its midpoint. Each step along the far side is the base of a triangle.
  [[nodiscard]] std::vector<FacetRegion> triangles() const {
    std::vector<FacetRegion> regions;
    std::size_t limit = 0;
    for (std::size_t i = 1; i < far_.items.size(); ++i) {
      regions.push_back(
          {far_.limits[limit], {far_.items[i - 1].corner, far_.items[i].corner, {RegionCorner::Kind::kMidpoint}}});
      limit += far_.items[i].separates ? 1 : 0;
    }
    return regions;
  }

  static void append(FacetRegion& region, const RegionCorner& corner) {
    if (region.corners.empty() || region.corners.back() != corner) region.corners.push_back(corner);
  }
  // The place of the next ray that separates.
  static std::size_t next_ray(const std::vector<SideItem>& items, std::size_t from) {
    std::size_t to = from + 1;
    while (!items[to].separates) ++to;
    return to;
  }

  [[nodiscard]] std::vector<FacetRegion> regions_between_rays() const {
    const auto rays = [](const std::vector<SideItem>& items) {
      return std::ranges::count(items, true, &SideItem::separates);
    };
    if (rays(near_.items) != rays(far_.items)) {
      throw std::logic_error("the two sides of a facet are divided by different rays");
    }
    std::vector<FacetRegion> regions;
    std::size_t far_at = 0, near_at = 0;
    for (const Limit limit : far_.limits) {
      FacetRegion region{limit, {}};
      const std::size_t far_to = next_ray(far_.items, far_at), near_to = next_ray(near_.items, near_at);
      for (std::size_t i = far_at; i <= far_to; ++i) append(region, far_.items[i].corner);
      for (std::size_t i = near_to + 1; i > near_at; --i) append(region, near_.items[i - 1].corner);
      far_at = far_to, near_at = near_to;
      if (region.corners.size() > 1 && region.corners.back() == region.corners.front()) region.corners.pop_back();
      regions.push_back(std::move(region));
    }
    return regions;
  }

  const LimitPartition& partition_;
  FacetSides sides_;
  FacetSide far_, near_;
};

}  // namespace

std::vector<FacetRegion> regions_of(const VoronoiDiagram& diagram, const LimitPartition& partition,
                                    const FacetRing& ring) {
  if (ring.size() == 0) return {{kInfinityLimit, {}}};
  return FacetWalk(diagram, partition, ring).regions();
}

}  // namespace flowcert::morse
