// Ordinals ascend with names (PointSet), so sorting by ordinals sorts by names. The search for stationary points is
// in another file, because it is compiled better alone.
#include "morse/ordered_records.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flowcert::morse {

// Makes room for what scans have: for each sample, about 3 critical points of index 1 and 2 of index 2.
OrderedRecords::OrderedRecords(std::span<const std::uint32_t> ordinals) : ordinals_(ordinals) {
  records_[0].reserve(3 * ordinals.size());
  records_[1].reserve(2 * ordinals.size());
}

void OrderedRecords::add(StationaryIndex index, std::span<const VertexIndex> contact, std::uint32_t face) {
  const auto slot = static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), index) - kOrder.begin());
  Record record{static_cast<std::uint32_t>(contact.size()), face, {}};
  if (contact.size() <= record.small.size()) {
    for (std::size_t k = 0; k < contact.size(); ++k) record.small[k] = ordinals_[contact[k]];
    std::sort(record.small.begin(), record.small.begin() + static_cast<std::ptrdiff_t>(contact.size()));
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
    std::sort(result.begin() + start[k], result.begin() + start[k + 1], [this](const Record& a, const Record& b) {
      return std::ranges::lexicographical_compare(contact(a), contact(b));
    });
  }
  return result;
}

StationaryPoints OrderedRecords::list(const PointSet& points) const {
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
    if (records_[slot].empty()) continue;
    for (const Record& record : sorted(records_[slot])) {
      names.clear();
      for (const std::uint32_t ordinal : contact(record)) names.push_back(points.name(ordinal));
      list.append(kOrder[slot], names, record.face);
    }
  }
  return list;
}

}  // namespace flowcert::morse
