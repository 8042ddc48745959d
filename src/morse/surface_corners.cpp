#include "morse/surface_corners.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "flowcert/sphere.h"
#include "geometry/rational_point.h"
#include "morse/unbounded_faces.h"

namespace flowcert::morse {

// ---- Exactly ----

RationalPoint SurfaceCorners::sample(VertexIndex v) const { return exact_position(faces_.diagram().point(v)); }

Corner<> SurfaceCorners::exact(const SurfaceEnd& end) {
  if (end.kind == SurfaceEnd::Kind::kPoint) return {flow_.exact(end.at)};
  if (end.kind == SurfaceEnd::Kind::kAlong) return {direction_of(faces_.diagram(), end.along), true};
  const RationalPoint x = Rational(2) * flow_.exact(end.at);
  return {as_direction(x - sample(end.facet.v0) - sample(end.facet.v1)), true};
}

Corner<> SurfaceCorners::exact(PolygonRef polygon, const TraceEnd& end) {
  if (end.kind == TraceEnd::Kind::kPoint) return {flow_.exact(end.at)};
  const EdgeEnd edge_end{polygon, end.is_end(1) ? 1u : 0u};
  const Location at = flow_.end_of_edge(polygon, edge_end.end);
  if (at.place.kind == Place::Kind::kVertex) return {flow_.exact(at)};
  return {direction_of(faces_.diagram(), edge_end), true};
}

Corner<> SurfaceCorners::middle_of_line(PolygonRef polygon) {
  return {flow_.exact({Place::on_edge(polygon), flow_.add_center(faces_.diagram().corners(polygon))})};
}

// ---- By number ----

void SurfaceCorners::clear() {
  corners_.clear();
  known_.clear();
  for (auto& each : by_position_) each.clear();
}

std::uint32_t SurfaceCorners::number(const SurfaceEnd& end) {
  return end.kind == SurfaceEnd::Kind::kPoint ? number(end.at) : number(exact(end));
}

std::uint32_t SurfaceCorners::number(PolygonRef polygon, const TraceEnd& end) {
  if (end.kind == TraceEnd::Kind::kPoint) return number(end.at);
  const CellIndex cluster = faces_.diagram().end(polygon, end.is_end(1) ? 1 : 0);
  return cluster != kNoCell ? number(Location{Place::at_vertex(cluster), kNoPoint}) : number(exact(polygon, end));
}

std::uint32_t SurfaceCorners::number(const Location& at) {
  const bool is_vertex = at.place.kind == Place::Kind::kVertex;
  const std::uint64_t key = is_vertex ? std::uint64_t{1} << 32 | at.place.vertex : std::uint64_t{at.point};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  return known_[key] = number_of({flow_.rounded(at).center, false, at, std::nullopt});
}

std::uint32_t SurfaceCorners::number(Corner<> corner) {
  const Point rounded = rounded_point(corner.position);
  return number_of({rounded, corner.at_infinity, {}, std::move(corner.position)});
}

std::uint32_t SurfaceCorners::number_of(Numbered corner) {
  auto& numbers = by_position_[corner.at_infinity ? 1 : 0];
  const auto [first, last] = numbers.equal_range(corner.rounded.coordinates());
  for (auto each = first; each != last; ++each) {
    if (exact_of(corners_[each->second]) == exact_of(corner)) return each->second;
  }
  const auto next = static_cast<std::uint32_t>(corners_.size());
  numbers.emplace(corner.rounded.coordinates(), next);
  corners_.push_back(std::move(corner));
  return next;
}

const RationalPoint& SurfaceCorners::exact_of(Numbered& corner) {
  if (!corner.exact) corner.exact = flow_.exact(corner.at);
  return *corner.exact;
}

std::vector<std::uint32_t> SurfaceCorners::sort() {
  std::vector<std::uint32_t> order(corners_.size()), number_of_old(corners_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    Numbered &a = corners_[i], &b = corners_[j];
    if (a.at_infinity != b.at_infinity) return b.at_infinity;
    if (a.rounded.coordinates() != b.rounded.coordinates()) return a.rounded.coordinates() < b.rounded.coordinates();
    return i != j && exact_of(a) < exact_of(b);
  });
  std::vector<Numbered> sorted;
  for (const std::uint32_t old : order) {
    number_of_old[old] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(std::move(corners_[old]));
  }
  corners_ = std::move(sorted);
  return number_of_old;
}

std::vector<RoundedUnstableSurface::Corner> SurfaceCorners::rounded() {
  std::vector<RoundedUnstableSurface::Corner> result;
  for (Numbered& corner : corners_) {
    result.push_back({corner.rounded, corner.at_infinity, std::nullopt});
    if (!corner.rounded.is_finite()) result.back().exact = exact_of(corner);
  }
  return result;
}

}  // namespace flowcert::morse
