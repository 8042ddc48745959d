// The graph is counted from the λ-lists; is_morse_smale() looks at stable sets and orbits, as the definition does.
#include "oracle/connections.h"

#include <algorithm>
#include <functional>
#include <map>

#include "oracle/merge_tree.h"
#include "oracle/orbit.h"
#include "oracle/stable_set.h"

namespace oracle {

namespace {

// Whether the entry is a direction beside no arc of its own limit. A list of index 1 goes around a circle. In a list of
// one entry, or of directions alone, nothing is beside an arc.
bool is_isolated(const std::vector<UnstableEntry>& list, std::size_t i, bool is_cyclic) {
  const auto is_arc_of_limit = [&](std::size_t k) { return list[k].is_arc && list[k].limit == list[i].limit; };
  const std::size_t count = list.size();
  const bool is_behind_arc = (i > 0 || is_cyclic) && is_arc_of_limit((i + count - 1) % count);
  const bool is_before_arc = (i + 1 < count || is_cyclic) && is_arc_of_limit((i + 1) % count);
  return !list[i].is_arc && !is_behind_arc && !is_before_arc;
}

// The connections of the λ-list of y. They are in the order of `all`, and infinity is last.
std::vector<Connection> connections_from(const std::vector<StationaryPoint>& all, const StationaryPoint& y,
                                         const std::vector<UnstableEntry>& list) {
  std::map<std::size_t, Connection> by_place;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& limit = list[i].limit;
    const bool isolated = is_isolated(list, i, y.hull_dimension == 1);
    if (!list[i].is_arc && !isolated) continue;
    Connection& sum = by_place.try_emplace(place_of(all, limit), Connection{y, limit}).first->second;
    ++(isolated ? sum.directions : sum.arcs);
  }
  std::vector<Connection> connections;
  connections.reserve(by_place.size());
  for (const auto& [place, connection] : by_place) connections.push_back(connection);
  return connections;
}

}  // namespace

std::size_t place_of(const std::vector<StationaryPoint>& all, const std::optional<StationaryPoint>& limit) {
  return static_cast<std::size_t>((limit ? std::find(all.begin(), all.end(), *limit) : all.end()) - all.begin());
}

std::vector<Connection> connections(const PointSet& set, const std::vector<StationaryPoint>& all) {
  std::vector<Connection> graph;
  for (const StationaryPoint& y : all) {
    if (y.face_dimension == 0) continue;
    const std::vector<Connection> from_y = connections_from(all, y, lambda_list(set, y));
    graph.insert(graph.end(), from_y.begin(), from_y.end());
  }
  return graph;
}

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

// A limit has a greater value than the point below it. So the points are asked from the highest one on.
PeaksAbove peaks_above(const PointSet& set, const std::vector<StationaryPoint>& all) {
  PeaksAbove above{std::vector<Peaks>(all.size() + 1), std::vector<std::array<Peaks, 2>>(all.size())};
  const std::vector<std::size_t> maxima = maxima_places(all);
  for (std::size_t leaf = 0; leaf < maxima.size(); ++leaf) above.of[maxima[leaf]] = {leaf};
  above.of[all.size()] = {maxima.size()};
  std::multimap<Rational, std::size_t, std::greater<>> by_value;
  for (std::size_t place = 0; place < all.size(); ++place) by_value.emplace(all[place].squared_distance, place);
  for (const auto& [value, place] : by_value) {
    if (all[place].face_dimension == 0) continue;
    const std::vector<UnstableEntry> list = lambda_list(set, all[place]);
    const auto of_limit = [&](const UnstableEntry& entry) { return above.of[place_of(all, entry.limit)]; };
    for (const UnstableEntry& entry : list) above.of[place].merge(of_limit(entry));
    const bool has_sides = all[place].face_dimension == 2 && all[place].is_critical();
    if (has_sides) above.of_sides[place] = {of_limit(list[0]), of_limit(list[1])};
  }
  return above;
}

}  // namespace oracle
