// The list has critical points first, by index, then regular ones by kind. Each group is sorted by contact sets.
#include "morse/record_finder.h"

#include <algorithm>
#include <array>

namespace flowcert::morse {

namespace {

// Critical points by index, then the regular kinds.
auto list_order(StationaryIndex index) {
  return std::pair(!index.is_critical(), std::pair(index.face_dimension, index.hull_dimension));
}

// The first place from `low` on at which the property holds, or `high`. From there on it must hold everywhere.
template <class Property>
std::size_t first_place(std::size_t low, std::size_t high, const Property& holds) {
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

GabrielEdges::GabrielEdges(const PointSet& points, const StationaryPoints& stationary,
                           std::span<const VertexIndex> vertex_of)
    : first_(vertex_of.size() + 1, 0) {
  const auto [first, last] = RecordFinder(stationary).range({1, 1});
  const auto ends = [&](std::size_t record) {
    const auto contact = stationary.contact(record);
    const VertexIndex a = vertex_of[points.ordinal_of_row(contact[0])];
    const VertexIndex b = vertex_of[points.ordinal_of_row(contact[1])];
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

}  // namespace flowcert::morse
