// The graph is counted from the λ-lists; is_morse_smale() looks at stable sets and orbits, as the definition does.
#include "oracle/connections.h"

#include <algorithm>
#include <map>

#include "oracle/orbit.h"
#include "oracle/stable_set.h"

namespace oracle {

namespace {

// Whether the entry is a direction beside no arc of its own limit. A list of index 1 goes around a circle. In a list of
// one entry, or of directions alone, nothing is beside an arc.
bool is_isolated(const std::vector<UnstableEntry>& list, std::size_t i, bool is_cyclic) {
  const auto is_arc_of_limit = [&](std::size_t k) { return list[k].is_arc && list[k].limit == list[i].limit; };
  const std::size_t last = list.size() - 1;
  if (list[i].is_arc) return false;
  if ((i > 0 || is_cyclic) && is_arc_of_limit(i > 0 ? i - 1 : last)) return false;
  if ((i < last || is_cyclic) && is_arc_of_limit(i < last ? i + 1 : 0)) return false;
  return true;
}

// The connections of the λ-list of y. They are in the order of `all`, and infinity is last.
std::vector<Connection> connections_from(const std::vector<StationaryPoint>& all, const StationaryPoint& y,
                                         const std::vector<UnstableEntry>& list) {
  std::map<std::size_t, Connection> by_place;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& limit = list[i].limit;
    const auto place = limit ? std::find(all.begin(), all.end(), *limit) - all.begin() : std::ssize(all);
    const bool isolated = is_isolated(list, i, y.hull_dimension == 1);
    if (!list[i].is_arc && !isolated) continue;
    Connection& sum = by_place.try_emplace(static_cast<std::size_t>(place), Connection{y, limit}).first->second;
    ++(isolated ? sum.directions : sum.arcs);
  }
  std::vector<Connection> connections;
  connections.reserve(by_place.size());
  for (const auto& [place, connection] : by_place) connections.push_back(connection);
  return connections;
}

}  // namespace

std::vector<Connection> connections(const PointSet& set) { return connections(set, stationary_points(set).stationary); }

std::vector<Connection> connections(const PointSet& set, const std::vector<StationaryPoint>& all) {
  std::vector<Connection> graph;
  for (const StationaryPoint& y : all) {
    if (y.face_dimension == 0) continue;
    const std::vector<Connection> from_y = connections_from(all, y, lambda_list(set, y));
    graph.insert(graph.end(), from_y.begin(), from_y.end());
  }
  return graph;
}

bool is_morse_smale(const PointSet& set) { return is_morse_smale(set, stationary_points(set).stationary); }

bool is_morse_smale(const PointSet& set, const std::vector<StationaryPoint>& all) {
  return std::all_of(all.begin(), all.end(), [&](const StationaryPoint& z) {
    if (!z.is_critical()) return false;
    if (z.face_dimension != 2) return true;
    const std::array<Orbit, 2> orbits = unstable_orbits(set, z);
    return stable_set(set, z).intervals.empty() && std::all_of(orbits.begin(), orbits.end(), [](const Orbit& o) {
             return !o.limit || o.limit->face_dimension == 3;
           });
  });
}

}  // namespace oracle
