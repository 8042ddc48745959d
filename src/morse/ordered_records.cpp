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
    for (Record& record : first_large > 0 ? std::span(added) : std::span<Record>()) {
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
  std::array<std::vector<Record>, kOrder.size()> in_order;
  geometry::parallel_for(kOrder.size(), threads, [&](std::size_t slot) {
    if (!records_[slot].empty()) in_order[slot] = sorted(records_[slot]);
  });
  StationaryPoints list;
  std::size_t records = points.size();
  for (const auto& of_one_index : records_) records += of_one_index.size();
  list.reserve(records, points.size() + 3 * (records - points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const PointId name = points.name(k);
    list.append({0, 0}, std::span(&name, 1), 0);
  }
  std::vector<PointId> names;
  for (std::size_t slot = 0; slot < kOrder.size(); ++slot) {
    for (const Record& record : in_order[slot]) {
      names.clear();
      for (const std::uint32_t ordinal : contact(record)) names.push_back(points.name(ordinal));
      list.append(kOrder[slot], names, record.face);
    }
  }
  return list;
}

}  // namespace flowcert::morse
