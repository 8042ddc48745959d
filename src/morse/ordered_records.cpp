// See ordered_records.h. Positions ascend with names (PointSet), so sorting by positions sorts by names.
#include "morse/ordered_records.h"

#include <algorithm>

namespace flowcert {

// Room for what scans have: about 3 saddles of index 1 and 2 of index 2 a point.
OrderedRecords::OrderedRecords(std::span<const std::uint32_t> positions) : positions_(positions) {
  contacts_.reserve(12 * positions.size());
  records_[0].reserve(3 * positions.size());
  records_[1].reserve(2 * positions.size());
}

void OrderedRecords::add(StationaryIndex index, std::span<const VertexIndex> contact) {
  const auto slot = static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), index) - kOrder.begin());
  const std::size_t first = contacts_.size();
  for (const VertexIndex v : contact) contacts_.push_back(positions_[v]);
  std::sort(contacts_.begin() + static_cast<std::ptrdiff_t>(first), contacts_.end());
  records_[slot].push_back({static_cast<std::uint32_t>(contact.size()), first});
}

std::vector<OrderedRecords::Record> OrderedRecords::sorted(const std::vector<Record>& records,
                                                           std::size_t point_count) const {
  std::vector<std::uint32_t> start(point_count + 1, 0);
  for (const Record& record : records) ++start[contacts_[record.first] + 1];
  for (std::size_t k = 0; k < point_count; ++k) start[k + 1] += start[k];
  std::vector<Record> result(records.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (const Record& record : records) result[next[contacts_[record.first]]++] = record;
  for (std::size_t k = 0; k < point_count; ++k) {
    if (start[k + 1] - start[k] < 2) continue;
    std::sort(result.begin() + start[k], result.begin() + start[k + 1],
              [this](const Record& a, const Record& b) {
                return std::ranges::lexicographical_compare(contact(a), contact(b));
              });
  }
  return result;
}

StationaryPoints OrderedRecords::list(const PointSet& points) const {
  StationaryPoints list;
  std::size_t records = points.size();
  for (const auto& of_one_index : records_) records += of_one_index.size();
  list.reserve(records, points.size() + contacts_.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const PointId name = points.name(k);
    list.append({0, 0}, std::span(&name, 1));
  }
  std::vector<PointId> names;
  for (std::size_t slot = 0; slot < kOrder.size(); ++slot) {
    if (records_[slot].empty()) continue;
    for (const Record& record : sorted(records_[slot], points.size())) {
      names.clear();
      for (const std::uint32_t position : contact(record)) names.push_back(points.name(position));
      list.append(kOrder[slot], names);
    }
  }
  return list;
}

}  // namespace flowcert
