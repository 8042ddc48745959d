// See stable_claim_fields.h.
#include "io/claims/stable_claim_fields.h"

#include <algorithm>
#include <array>

namespace flowcert::io {

namespace {

std::vector<PointId> pair_of_ids(const ExchangeValue& value) {
  value.expect_size(2);
  return ids_of(value);
}

std::vector<ClaimedPosition> corners_of(const ExchangeValue& value) {
  auto corners = list_of(value, position_of);
  if (corners.size() < 3) value.reject("three or more corners");
  return corners;
}

ClaimedBackwardSegment segment_of(const ExchangeValue& value) {
  ClaimedBackwardSegment segment;
  segment.samples = pair_of_ids(value.get("samples"));
  segment.front = position_of(value.get("front"));
  segment.back = position_of(value.get("back"));
  if (const auto contact = value.find("front_contact")) segment.front_contact = ids_of(*contact);
  if (const auto contact = value.find("back_contact")) segment.back_contact = ids_of(*contact);
  if (const auto kind = value.find("back_kind")) {
    constexpr std::array kKinds = {"critical", "regular", "edge", "vertex"};
    segment.back_kind = kind->text();
    if (std::ranges::find(kKinds, segment.back_kind) == kKinds.end()) kind->reject("a kind of back");
  }
  return segment;
}

ClaimedInterval interval_of(const ExchangeValue& value) {
  ClaimedInterval interval{ids_of(value.get("polygon")), position_of(value.get("front")),
                           position_of(value.get("back")), std::nullopt};
  if (const auto stationary = value.find("back_is_stationary")) {
    interval.back_is_stationary = bool_of(*stationary);
  }
  return interval;
}

ClaimedSector sector_of(const ExchangeValue& value) {
  return {pair_of_ids(value.get("samples")), corners_of(value.get("corners"))};
}

std::array<std::size_t, 3> triangle_of(const ExchangeValue& value) {
  value.expect_size(3);
  return {count_of(value[0]), count_of(value[1]), count_of(value[2])};
}

}  // namespace

ClaimedStable stable_of(const ExchangeValue& value) {
  ClaimedStable stable;
  if (const auto count = value.find("segments")) stable.segments = count_of(*count);
  if (const auto flag = value.find("has_vertex")) stable.has_vertex = bool_of(*flag);
  if (const auto flag = value.find("has_interval")) stable.has_interval = bool_of(*flag);
  if (const auto boundary = value.find("boundary")) stable.boundary = list_of(*boundary, ids_of);
  if (const auto walk = value.find("walk"); walk && !walk->is_null()) stable.walk = ids_of(*walk);
  return stable;
}

ClaimedSkeleton skeleton_of(const ExchangeValue& value) {
  ClaimedSkeleton skeleton;
  skeleton.segments = list_of(value.get("segments"), segment_of);
  if (const auto intervals = value.find("intervals")) skeleton.intervals = list_of(*intervals, interval_of);
  if (const auto sectors = value.find("sectors")) skeleton.sectors = list_of(*sectors, sector_of);
  return skeleton;
}

ClaimedSurface surface_of(const ExchangeValue& value) {
  ClaimedSurface surface;
  surface.vertices = list_of(value.get("vertices"), position_of);
  const ExchangeValue triangles = value.get("triangles");
  surface.triangles = list_of(triangles, triangle_of);
  for (const auto& triangle : surface.triangles) {
    for (const std::size_t vertex : triangle) {
      if (vertex >= surface.vertices.size())
        triangles.reject("triangles of the vertices: there are not so many");
    }
  }
  return surface;
}

}  // namespace flowcert::io
