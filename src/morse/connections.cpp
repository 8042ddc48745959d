// Equal limits of one λ-list are counted together.
#include "flowcert/connections.h"

#include <algorithm>

namespace flowcert {

std::vector<Connection> connections(const FlowLimits& limits) {
  std::vector<Connection> all;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    std::vector<FlowLimits::Entry> entries = limits.entries(i);
    std::ranges::sort(entries, {}, &FlowLimits::Entry::limit);
    const auto from = static_cast<std::uint32_t>(limits.record(i));
    for (const auto& [limit, is_arc] : entries) {
      const bool is_new = all.empty() || all.back().from != from || all.back().to != limit;
      if (is_new) all.push_back({from, limit});
      ++(is_arc ? all.back().families : all.back().orbits);
    }
  }
  return all;
}

bool is_morse_smale(const StationaryPoints& stationary, const FlowLimits& limits, const StableManifolds& stable) {
  if (stationary.regular_counts() != RegularCounts{}) return false;
  for (std::size_t i = 0; i < stable.size(); ++i) {
    if (stable.has_interval(i)) return false;
  }
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (stationary.index(limits.record(i)).face_dimension != 2) continue;
    for (const auto& [limit, is_arc] : limits.entries(i)) {
      const bool is_right = limit == FlowLimits::Entry::kInfinity || stationary.index(limit) == StationaryIndex{3, 3};
      if (!is_right) return false;
    }
  }
  return true;
}

}  // namespace flowcert
