// What follows from where directions lead.
#include "certify/truth.h"

#include <map>

namespace flowcert {

namespace {

using Entry = FlowLimits::Entry;

// Such a direction belongs to the arc (FC-CONN-01). In a cycle, the last entry is beside the first one.
bool is_beside_arc_of_its_limit(const std::vector<Entry>& entries, std::size_t k, bool is_cycle) {
  const auto is_such_arc = [&](std::size_t i) { return entries[i].is_arc && entries[i].limit == entries[k].limit; };
  const std::size_t last = entries.size() - 1;
  return ((k > 0 || is_cycle) && is_such_arc(k > 0 ? k - 1 : last)) ||
         ((k < last || is_cycle) && is_such_arc(k < last ? k + 1 : 0));
}

}  // namespace

std::vector<Connection> Truth::connections(std::size_t i) {
  std::map<std::uint32_t, Connection> by_limit;
  const std::vector<Entry> entries = lambda_entries(i);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto& [limit, is_arc] = entries[k];
    if (!is_arc && is_beside_arc_of_its_limit(entries, k, index(i) == StationaryIndex{1, 1})) continue;
    Connection& one = by_limit.try_emplace(limit, Connection{static_cast<std::uint32_t>(i), limit}).first->second;
    ++(is_arc ? one.families : one.orbits);
  }
  std::vector<Connection> all;
  all.reserve(by_limit.size());
  for (const auto& [limit, one] : by_limit) all.push_back(one);
  return all;
}

bool Truth::is_morse_smale() {
  for (std::size_t i = 0; i < size(); ++i) {
    const StationaryIndex from = index(i);
    if (!from.is_critical()) return false;
    if (from.face_dimension != 1 && from.face_dimension != 2) continue;
    for (const auto& [limit, is_arc] : lambda_entries(i)) {
      const bool is_at_top = limit == Entry::kInfinity || index(limit) == StationaryIndex{3, 3};
      const bool is_right =
          is_arc || from.face_dimension == 2 ? is_at_top : !is_at_top && index(limit) == StationaryIndex{2, 2};
      if (!is_right) return false;
    }
  }
  return true;
}

}  // namespace flowcert
