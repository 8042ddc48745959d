// See record_finder.h.
#include "morse/record_finder.h"

#include <algorithm>
#include <ranges>

namespace flowcert {

namespace {

// Critical points by index, then the regular kinds.
auto list_order(StationaryIndex index) {
  return std::pair(!index.is_critical(), std::pair(index.face_dimension, index.hull_dimension));
}

}  // namespace

std::pair<std::size_t, std::size_t> RecordFinder::range(StationaryIndex index) const {
  const auto records = std::views::iota(std::size_t{0}, list_.size());
  const auto key = [this](std::size_t record) { return list_order(list_.index(record)); };
  const auto found = std::ranges::equal_range(records, list_order(index), {}, key);
  if (found.empty()) return {0, 0};
  return {found.front(), found.back() + 1};
}

std::optional<std::size_t> RecordFinder::find(StationaryIndex index, std::span<const PointId> contact) const {
  auto [low, high] = range(index);
  const auto is_before = [](std::span<const PointId> a, std::span<const PointId> b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (is_before(list_.contact(middle), contact)) {
      low = middle + 1;
    } else if (is_before(contact, list_.contact(middle))) {
      high = middle;
    } else {
      return middle;
    }
  }
  return std::nullopt;
}

}  // namespace flowcert
