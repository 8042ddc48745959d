// The list has critical points first, by index, then regular ones by kind. Each group is sorted by contact sets.
#include "morse/record_finder.h"

#include <algorithm>
#include <array>

#include "flow/drivers.h"
#include "geometry/contract.h"

namespace flowcert::morse {

namespace {

// Critical points by index, then the regular kinds.
auto list_order(StationaryIndex index) {
  return std::pair(!index.is_critical(), std::pair(index.face_dimension, index.hull_dimension));
}

// The first place from `low` on at which the property holds, or `high`. From there on it must hold everywhere.
std::size_t first_place(std::size_t low, std::size_t high, const auto& holds) {
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

// The binary search runs over the places themselves: libstdc++'s ranges of integers do not compile with clang 14.
std::pair<std::size_t, std::size_t> RecordFinder::range(StationaryIndex index) const {
  const auto wanted = list_order(index);
  const auto key = [this](std::size_t record) { return list_order(list_.index(record)); };
  const std::size_t first = first_place(0, list_.size(), [&](std::size_t record) { return key(record) >= wanted; });
  const std::size_t last = first_place(first, list_.size(), [&](std::size_t record) { return key(record) > wanted; });
  return {first, last};
}

std::optional<std::size_t> RecordFinder::find(StationaryIndex index, std::span<const PointId> contact) const {
  const auto [first, last] = range(index);
  const std::size_t found = first_place(first, last, [&](std::size_t record) {
    const auto there = list_.contact(record);
    return !std::lexicographical_compare(there.begin(), there.end(), contact.begin(), contact.end());
  });
  if (found == last || !std::ranges::equal(list_.contact(found), contact)) return std::nullopt;
  return found;
}

GabrielEdges::GabrielEdges(const VoronoiDiagram& diagram, const StationaryPoints& stationary)
    : first_(diagram.delaunay().points.size() + 1, 0) {
  const auto [first, last] = RecordFinder(stationary).range({1, 1});
  const auto ends = [&](std::size_t record) {
    const auto contact = stationary.contact(record);
    const VertexIndex a = diagram.named(contact[0]), b = diagram.named(contact[1]);
    return std::array{std::min(a, b), std::max(a, b)};
  };
  for (std::size_t record = first; record < last; ++record) ++first_[ends(record)[0] + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  edges_.resize(last - first);
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t record = first; record < last; ++record) {
    const auto [v0, v1] = ends(record);
    edges_[next[v0]++] = {v1, static_cast<std::uint32_t>(record)};
  }
}

// A regular stationary point lies on the side at which one of its polygons has a right angle.
FacetName facet_of_record(const VoronoiDiagram& diagram, const StationaryPoints& list, std::size_t record) {
  const StationaryIndex index = list.index(record);
  FLOWCERT_REQUIRES(index.face_dimension == 1);
  if (index.is_critical()) {
    const auto contact = list.contact(record);
    return facet_name(diagram.named(contact[0]), diagram.named(contact[1]));
  }
  const PolygonRef polygon = index.hull_dimension == 2
                                 ? edge_of_record(list, record)
                                 : polygons_through(diagram, cell_of_record(list, record)).front();
  const PolygonSides sides = diagram.sides(polygon);
  const auto side = std::ranges::find(sides, Sign::kZero, &PolygonSide::angle);
  return {side->v0, side->v1};
}

}  // namespace flowcert::morse
