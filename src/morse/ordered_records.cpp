// Ordinals ascend with names (PointSet), so sorting by ordinals sorts by names. The search for stationary points is
// in another file, because it is compiled better alone.
#include "morse/ordered_records.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "geometry/parallel_for.h"
#include "geometry/unset_vector.h"

namespace flowcert::morse {

// Makes room for what scans have: for each sample, about 3 critical points of index 1 and 2 of index 2.
OrderedRecords OrderedRecords::empty_part(std::size_t parts) const {
  OrderedRecords part(ordinals_);
  part.records_[0].reserve(3 * ordinals_.size() / parts);
  part.records_[1].reserve(2 * ordinals_.size() / parts);
  return part;
}

// Records of large contact sets are rare, and only these change.
void OrderedRecords::take(OrderedRecords other) {
  const auto first_large = static_cast<std::uint32_t>(large_.size());
  std::ranges::move(other.large_, std::back_inserter(large_));
  if (first_large > 0 && large_.size() > first_large) {
    for (std::vector<Record>& records : other.records_) {
      for (Record& record : records) {
        if (record.size > record.small.size()) record.small[1] += first_large;
      }
    }
  }
  taken_.push_back(std::move(other.records_));
}

namespace {

// Most contact sets have two points or three, and which comes first cannot be guessed.
void sort_first(std::array<std::uint32_t, 4>& ordinals, std::size_t count) {
  const auto in_order = [&](std::size_t i, std::size_t j) {
    const std::uint32_t least = std::min(ordinals[i], ordinals[j]);
    ordinals[j] = std::max(ordinals[i], ordinals[j]);
    ordinals[i] = least;
  };
  if (count == 4) return std::sort(ordinals.begin(), ordinals.end());
  if (count > 1) in_order(0, 1);
  if (count > 2) in_order(1, 2), in_order(0, 1);
}

}  // namespace

void OrderedRecords::add(StationaryIndex index, std::span<const VertexIndex> contact, std::uint32_t face) {
  const auto slot = static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), index) - kOrder.begin());
  Record record{static_cast<std::uint32_t>(contact.size()), face, {}};
  if (contact.size() <= record.small.size()) {
    for (std::size_t k = 0; k < contact.size(); ++k) record.small[k] = ordinals_[contact[k]];
    sort_first(record.small, contact.size());
  } else {
    std::vector<std::uint32_t> ordinals;
    for (const VertexIndex v : contact) ordinals.push_back(ordinals_[v]);
    std::sort(ordinals.begin(), ordinals.end());
    record.small = {ordinals.front(), static_cast<std::uint32_t>(large_.size()), 0, 0};
    large_.push_back(std::move(ordinals));
  }
  records_[slot].push_back(record);
}

// Spreads the records over buckets by their first points, then sorts each small bucket.
void OrderedRecords::sort(std::size_t slot, std::span<Record> result) const {
  std::vector<std::uint32_t> start(ordinals_.size() + 1, 0);
  for_each_record(slot, [&](const Record& record) { ++start[record.small[0] + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for_each_record(slot, [&](const Record& record) { result[next[record.small[0]]++] = record; });
  for (std::size_t k = 0; k < ordinals_.size(); ++k) {
    if (start[k + 1] - start[k] < 2) continue;
    std::sort(result.begin() + start[k], result.begin() + start[k + 1],
              [this](const Record& a, const Record& b) { return is_less(a, b); });
  }
}

StationaryPoints OrderedRecords::list(const PointSet& points, unsigned threads) const {
  // Where the records of each index or kind are in the list, and their contact sets.
  std::array<std::size_t, kOrder.size() + 1> first_record{points.size()}, first_contact{points.size()};
  std::array<std::size_t, kOrder.size()> counts{};
  for (std::size_t slot = 0; slot < kOrder.size(); ++slot) {
    first_contact[slot + 1] = first_contact[slot];
    for_each_record(slot, [&](const Record& record) {
      ++counts[slot];
      first_contact[slot + 1] += record.size;
    });
    first_record[slot + 1] = first_record[slot] + counts[slot];
  }
  StationaryPoints list;
  const auto make_room = [&](std::size_t k) {
    if (k == 0) list.contact_.resize(first_contact.back());
    if (k == 1) list.first_.resize(first_record.back() + 1);
    if (k == 2) list.face_.resize(first_record.back());
    if (k == 3) list.index_.resize(first_record.back());
  };
  geometry::parallel_for(4, threads, make_room);
  for (std::size_t k = 0; k < points.size(); ++k) {
    list.contact_[k] = points.name(k);
    list.first_[k + 1] = k + 1;
  }
  // The memory is taken here, because a thread of its own would have none that was used before.
  std::array<geometry::UnsetVector<Record>, kOrder.size()> sorted;
  for (std::size_t slot = 0; slot < kOrder.size(); ++slot) sorted[slot].resize(counts[slot]);
  geometry::parallel_for(kOrder.size(), threads, [&](std::size_t slot) {
    if (counts[slot] == 0) return;
    sort(slot, sorted[slot]);
    std::size_t at = first_record[slot], end = first_contact[slot];
    for (const Record& record : sorted[slot]) {
      list.index_[at] = kOrder[slot];
      list.face_[at] = record.face;
      for (const std::uint32_t ordinal : contact(record)) list.contact_[end++] = points.name(ordinal);
      list.first_[++at] = end;
    }
    geometry::UnsetVector<Record>().swap(sorted[slot]);
  });
  list.critical_ = {points.size(), counts[0], counts[1], counts[2]};
  list.regular_ = {counts[3], counts[4], counts[5]};
  return list;
}

}  // namespace flowcert::morse
