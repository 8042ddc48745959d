// Connections by the oracle, on small inputs of all families.
//
// Distances grow along each connection. What flows up from index-1 points is counted in other ways, too: by the
// connecting orbits of index-2 points, and by the two orbits of U2. Whether an input is Morse-Smale is read from the
// limits alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "oracle/connections.h"
#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace oracle::oracle_connections_families_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;

struct Subject {
  explicit Subject(const Rows& rows) : set(rows), all(stationary_points(set).stationary), graph(connections(set, all)) {
    for (const StationaryPoint& z : all) {
      if (z.face_dimension == 2 && z.is_critical()) {
        stable.emplace(z.center, stable_set(set, z));
        orbits.emplace(z.center, unstable_orbits(set, z));
      }
      if (!z.is_critical()) has_tie = true;
      if (z.face_dimension > 0) lists.emplace(z.center, lambda_list(set, z));
    }
    for (const auto& [center, set_of_center] : stable) has_tie = has_tie || oracle::has_tie(set_of_center);
    for (const auto& [center, both] : orbits) {
      for (const Orbit& o : both) has_tie = has_tie || (o.limit && o.limit->face_dimension < 3);
    }
  }

  PointSet set;
  std::vector<StationaryPoint> all;
  std::vector<Connection> graph;
  std::map<Point, std::vector<UnstableEntry>> lists;
  std::map<Point, StableSet> stable;  // of critical points of index 2
  std::map<Point, std::array<Orbit, 2>> orbits;
  bool has_tie = false;  // FC-CHAIN-01, or a regular stationary point
};

struct Count {
  std::size_t inputs = 0, without_ties = 0, morse_smale = 0, connections = 0, isolated = 0, arcs = 0, separators = 0;
  std::map<std::string, std::size_t> kinds;
};

std::string kind_of(const std::optional<StationaryPoint>& z) {
  if (!z) return "infinity";
  return std::to_string(z->face_dimension) + (z->is_critical() ? "" : "-" + std::to_string(z->hull_dimension));
}

// Along a connection d grows, so that there is no cycle.
void expect_upwards(const Subject& subject, Count& count) {
  for (const Connection& c : subject.graph) {
    EXPECT_TRUE(std::ranges::find(subject.all, c.from) != subject.all.end());
    EXPECT_GT(c.directions + c.arcs, 0U);
    if (c.from.face_dimension == 2) {
      EXPECT_EQ(c.arcs, 0U);
    }
    if (c.to) {
      EXPECT_TRUE(std::ranges::find(subject.all, *c.to) != subject.all.end());
      EXPECT_LT(c.from.squared_distance, c.to->squared_distance);
      EXPECT_GT(c.to->hull_dimension, 1);
    }
    ++count.connections;
    count.isolated += c.directions;
    count.arcs += c.arcs;
    ++count.kinds[kind_of(c.from) + " -> " + kind_of(c.to)];
  }
}

// One direction or two, or a list of which each entry is in the graph, or beside one that is.
void expect_numbers(const Subject& subject) {
  for (const StationaryPoint& y : subject.all) {
    std::size_t in_graph = 0, out_of_graph = 0;
    for (const Connection& c : subject.graph) {
      if (c.from == y) in_graph += c.directions + c.arcs;
    }
    if (y.face_dimension == 0 || y.face_dimension == 3) {
      EXPECT_EQ(in_graph, 0U);
      continue;
    }
    const std::vector<UnstableEntry>& list = subject.lists.at(y.center);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const UnstableEntry& before = list[(i + list.size() - 1) % list.size()];
      const UnstableEntry& after = list[(i + 1) % list.size()];
      const bool has_before = i > 0 || y.is_critical(), has_after = i + 1 < list.size() || y.is_critical();
      if (!list[i].is_arc && ((has_before && before.is_arc && before.limit == list[i].limit) ||
                              (has_after && after.is_arc && after.limit == list[i].limit))) {
        ++out_of_graph;
      }
    }
    EXPECT_EQ(in_graph + out_of_graph, list.size());
    if (y.face_dimension == 2) {
      EXPECT_EQ(in_graph, y.is_critical() ? 2U : 1U);
    }
  }
}

bool is_open_limit(const std::optional<StationaryPoint>& z) { return !z || z->face_dimension == 3; }

// Between two arcs whose limits are maxima or infinity there is a direction whose limit is neither.
void expect_separated(const Subject& subject, Count& count) {
  for (const StationaryPoint& y : subject.all) {
    if (y.face_dimension != 1) continue;
    const std::vector<UnstableEntry>& list = subject.lists.at(y.center);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].is_arc || (!y.is_critical() && (i == 0 || i + 1 == list.size()))) continue;
      const auto& limit = list[i].limit;
      const bool separates = limit && (limit->face_dimension == 2 || !limit->is_critical());
      if (y.is_critical()) {
        EXPECT_TRUE(separates);
      }
      const auto &before = list[i > 0 ? i - 1 : list.size() - 1].limit, &after = list[(i + 1) % list.size()].limit;
      if (!is_open_limit(before) || !is_open_limit(after)) continue;
      EXPECT_TRUE(separates);
      ++count.separators;
    }
  }
}

// Chains of segments from z down to index-1 points (FC-STAB-06), counted by the index-1 point.
void add_chains(const StableSet& stable, const Corner& front, std::map<Point, std::size_t>& found) {
  for (const BackwardSegment& segment : stable.segments) {
    if (segment.front != front) continue;
    if (segment.back_kind == BackKind::kCritical) ++found[segment.back.position];
    add_chains(stable, segment.back, found);
  }
}

// The directions from index-1 points to z are the connecting orbits of z, if z has no interval.
void expect_connecting_orbits(const Subject& subject) {
  for (const auto& [z, stable] : subject.stable) {
    if (!stable.intervals.empty()) continue;
    std::map<Point, std::size_t> orbits, directions;
    add_chains(stable, z, orbits);
    for (const Connection& c : subject.graph) {
      if (!c.to || c.to->center != z || c.from.hull_dimension != 1) continue;
      EXPECT_EQ(c.arcs, 0U);
      directions[c.from.center] += c.directions;
    }
    EXPECT_EQ(orbits, directions);
  }
}

// Without ties: the arcs beside a direction to x are those of the two orbits of x. So each arc of a maximum M has its
// two ends at directions to points x, and the boundary of the boundary of M is zero.
void expect_boundaries(const Subject& subject) {
  for (const StationaryPoint& y : subject.all) {
    if (y.hull_dimension != 1) continue;
    const std::vector<UnstableEntry>& list = subject.lists.at(y.center);
    std::map<Point, std::size_t> ends, coefficients;  // by the maximum
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].is_arc) continue;
      const auto& before = list[(i + list.size() - 1) % list.size()].limit;
      const auto& after = list[(i + 1) % list.size()].limit;
      const auto& [side_0, side_1] = subject.orbits.at(list[i].limit->center);
      EXPECT_TRUE((before == side_0.limit && after == side_1.limit) ||
                  (before == side_1.limit && after == side_0.limit));
      for (const auto& limit : {before, after}) {
        if (limit) ++ends[limit->center];
      }
      if (side_0.limit == side_1.limit) continue;
      for (const auto& limit : {side_0.limit, side_1.limit}) {
        if (limit) ++coefficients[limit->center];
      }
    }
    for (const auto& [maximum, number] : ends) EXPECT_EQ(number % 2, 0U);
    for (const auto& [maximum, number] : coefficients) EXPECT_EQ(number % 2, 0U);
  }
}

// FC-CONN-03, of limits alone: each connection leads from index k to k + 1 by single orbits, from 1 to 3 by families.
bool has_limits_of_morse_smale(const Subject& subject) {
  return std::ranges::all_of(subject.all, [](const auto& z) { return z.is_critical(); }) &&
         std::ranges::all_of(subject.graph, [](const Connection& c) {
           const int to = c.to ? c.to->face_dimension : 3;
           return (c.directions == 0 || to == c.from.face_dimension + 1) &&
                  (c.arcs == 0 || to == c.from.face_dimension + 2);
         });
}

template <typename Visit>
void for_each_drawn(const Visit& visit) {
  const std::uint64_t seeds = flowcert_tests::scaled_seeds(2);
  const std::size_t most = flowcert::property::scale_of_run() < 1 ? 7 : 10;
  flowcert_tests::for_each_drawn_set({seeds, seeds, most},
                                     [&](const Rows& rows, std::uint64_t) { visit(Subject(rows)); });
}

TEST(OracleConnectionsFamilies, HoldsToItsLawsInAllFamilies) {
  CITES("FC-CONN-01", "FC-CONN-02", "FC-CONN-03", "FC-STAB-06", "FC-CHAIN-01");
  Count count;
  for_each_drawn([&](const Subject& subject) {
    expect_upwards(subject, count);
    expect_numbers(subject);
    expect_separated(subject, count);
    expect_connecting_orbits(subject);
    if (!subject.has_tie) expect_boundaries(subject);
    const bool morse_smale = is_morse_smale(subject.set, subject.all);
    EXPECT_EQ(has_limits_of_morse_smale(subject), morse_smale);
    EXPECT_TRUE(subject.has_tie || morse_smale);
    ++count.inputs;
    count.without_ties += subject.has_tie ? 0 : 1;
    count.morse_smale += morse_smale ? 1 : 0;
  });
  std::printf("%zu inputs, %zu Morse-Smale, %zu without ties; %zu connections: %zu directions, %zu arcs\n",
              count.inputs, count.morse_smale, count.without_ties, count.connections, count.isolated, count.arcs);
  for (const auto& [kind, number] : count.kinds) std::printf("%8zu  %s\n", number, kind.c_str());
  const double scale = flowcert::property::scale_of_run();
  EXPECT_GT(count.without_ties, 5 * scale);
  EXPECT_GT(count.morse_smale, 10 * scale);
  EXPECT_GT(count.inputs - count.morse_smale, 25 * scale);
  EXPECT_GT(count.separators, 100 * scale);
  if (scale >= 1) {
    EXPECT_GT(count.kinds["2 -> 2"], 0U);
  }
}

}  // namespace
}  // namespace oracle::oracle_connections_families_test
