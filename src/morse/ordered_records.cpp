// Ordinals ascend with names (PointSet), so sorting by ordinals sorts by names. The search for stationary points is
// in another file, because it is compiled better alone.
#include "morse/ordered_records.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "geometry/parallel_for.h"

namespace flowcert::morse {

// Makes room for what scans have: for each sample, about 3 critical points of index 1 and 2 of index 2.
OrderedRecords OrderedRecords::empty_part(std::size_t parts) const {
  OrderedRecords part(ordinals_);
  part.records_[0].reserve(3 * ordinals_.size() / parts);
  part.records_[1].reserve(2 * ordinals_.size() / parts);
  return part;
}

void OrderedRecords::take(OrderedRecords other) {
  const auto first_large = static_cast<std::uint32_t>(large_.size());
  std::ranges::move(other.large_, std::back_inserter(large_));
  for (std::size_t slot = 0; slot < records_.size(); ++slot) {
    std::vector<Record>& added = other.records_[slot];
    for (Record& record : added) {
      if (record.size > record.small.size()) record.small[1] += first_large;
    }
    if (records_[slot].empty()) {
      records_[slot] = std::move(added);
    } else {
      records_[slot].insert(records_[slot].end(), added.begin(), added.end());
    }
  }
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
std::vector<OrderedRecords::Record> OrderedRecords::sorted(const std::vector<Record>& records) const {
  std::vector<std::uint32_t> start(ordinals_.size() + 1, 0);
  for (const Record& record : records) ++start[record.small[0] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Record> result(records.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (const Record& record : records) result[next[record.small[0]]++] = record;
  for (std::size_t k = 0; k < ordinals_.size(); ++k) {
    if (start[k + 1] - start[k] < 2) continue;
    std::sort(result.begin() + start[k], result.begin() + start[k + 1],
              [this](const Record& a, const Record& b) { return is_less(a, b); });
  }
  return result;
}

StationaryPoints OrderedRecords::list(const PointSet& points, unsigned threads) const {
  // Where the records of each index or kind are in the list, and their contact sets.
  std::array<std::size_t, kOrder.size() + 1> first_record{points.size()}, first_contact{points.size()};
  for (std::size_t slot = 0; slot < kOrder.size(); ++slot) {
    first_record[slot + 1] = first_record[slot] + records_[slot].size();
    first_contact[slot + 1] = first_contact[slot];
    for (const Record& record : records_[slot]) first_contact[slot + 1] += record.size;
  }
  StationaryPoints list;
  list.index_.resize(first_record.back());
  list.face_.resize(first_record.back());
  list.first_.resize(first_record.back() + 1);
  list.contact_.resize(first_contact.back());
  for (std::size_t k = 0; k < points.size(); ++k) {
    list.contact_[k] = points.name(k);
    list.first_[k + 1] = k + 1;
  }
  geometry::parallel_for(kOrder.size(), threads, [&](std::size_t slot) {
    if (records_[slot].empty()) return;
    std::size_t at = first_record[slot], end = first_contact[slot];
    for (const Record& record : sorted(records_[slot])) {
      list.index_[at] = kOrder[slot];
      list.face_[at] = record.face;
      for (const std::uint32_t ordinal : contact(record)) list.contact_[end++] = points.name(ordinal);
      list.first_[++at] = end;
    }
  });
  list.critical_ = {points.size(), records_[0].size(), records_[1].size(), records_[2].size()};
  list.regular_ = {records_[3].size(), records_[4].size(), records_[5].size()};
  return list;
}

}  // namespace flowcert::morse
