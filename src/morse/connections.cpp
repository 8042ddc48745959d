// Equal limits of one λ-list are counted together. A direction beside an arc of its own limit belongs to that family.
#include "flowcert/connections.h"

#include <algorithm>

#include "geometry/floating_point.h"

namespace flowcert {

namespace {

using Entry = FlowLimits::Entry;

// Leaves out directions that are ends of arcs of their own limit. Only cycles have an arc at the end.
std::vector<Entry> isolated_and_arcs(const std::vector<Entry>& list) {
  std::vector<Entry> kept;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto is_end_of = [&](const Entry& other) { return other.is_arc && other.limit == list[i].limit; };
    const bool has_before = i > 0 || list.back().is_arc;
    const bool is_end = !list[i].is_arc && ((has_before && is_end_of(list[i == 0 ? list.size() - 1 : i - 1])) ||
                                            (i + 1 < list.size() && is_end_of(list[i + 1])));
    if (!is_end) kept.push_back(list[i]);
  }
  return kept;
}

}  // namespace

std::vector<Connection> connections_of(const FlowLimits& limits, std::size_t i) {
  const geometry::IeeeDoubles ieee;
  std::vector<Entry> entries = isolated_and_arcs(limits.entries(i));
  std::ranges::sort(entries, {}, &Entry::limit);
  const auto from = static_cast<std::uint32_t>(limits.record(i));
  std::vector<Connection> all;
  for (const auto& [limit, is_arc] : entries) {
    if (all.empty() || all.back().to != limit) all.push_back({from, limit});
    ++(is_arc ? all.back().families : all.back().orbits);
  }
  return all;
}

std::vector<Connection> connections(const FlowLimits& limits) {
  const geometry::IeeeDoubles ieee;
  std::vector<Connection> all;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const std::vector<Connection> some = connections_of(limits, i);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::size_t orbits_that_end_elsewhere(const StationaryPoints& stationary, const FlowLimits& limits) {
  const geometry::IeeeDoubles ieee;
  std::size_t count = 0;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (stationary.index(limits.record(i)) != StationaryIndex{2, 2}) continue;
    for (const auto& [limit, is_arc] : limits.entries(i)) {
      const bool is_usual = limit == Entry::kInfinity || stationary.index(limit) == StationaryIndex{3, 3};
      if (!is_usual) ++count;
    }
  }
  return count;
}

bool is_morse_smale(const StationaryPoints& stationary, const FlowLimits& limits, const StableManifolds& stable) {
  const geometry::IeeeDoubles ieee;
  return stationary.regular_counts() == RegularCounts{} && stable.statistics().with_interval == 0 &&
         orbits_that_end_elsewhere(stationary, limits) == 0;
}

}  // namespace flowcert
