// Connections by the oracle: named examples, and laws on small inputs of all families. Distances grow along each
// connection. What flows up from index-1 points is counted in other ways: by connecting orbits, by the two orbits of
// index-2 points.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/stable_configurations.h"
#include "oracle/connections.h"
#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/property/property_parameters.h"

namespace oracle {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;

// From, to (empty for infinity), directions, arcs.
struct Named {
  Names from, to;
  std::size_t directions, arcs;
  friend bool operator==(const Named&, const Named&) = default;
};
void PrintTo(const Named& c, std::ostream* out) {
  *out << testing::PrintToString(c.from) << " -> " << testing::PrintToString(c.to) << ": " << c.directions
       << " directions, " << c.arcs << " arcs";
}

std::vector<Named> named(const Rows& rows) {
  std::vector<Named> result;
  for (const Connection& c : connections(PointSet(rows))) {
    result.push_back({c.from.contact, c.to ? c.to->contact : Names{}, c.directions, c.arcs});
  }
  return result;
}

// Only those that lead from the point of this contact set.
std::vector<Named> named_from(const Rows& rows, const Names& contact) {
  std::vector<Named> result = named(rows);
  std::erase_if(result, [&](const Named& c) { return c.from != contact; });
  return result;
}

const Rows kChain = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}};
const Rows kWithSector = {{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}};

TEST(OracleConnections, OfSmallSets) {
  CITES("FC-CONN-01", "FC-CONN-02");
  EXPECT_TRUE(named({}).empty());
  EXPECT_TRUE(named({{1, 2, 3}}).empty());
  EXPECT_EQ(named({{0, 0, 0}, {2, 0, 0}}), (std::vector<Named>{{{0, 1}, {}, 0, 1}}));
  // An acute triangle: from each edge one orbit leads to the triangle, and the others to infinity.
  EXPECT_EQ(named({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}), (std::vector<Named>{{{0, 1}, {0, 1, 2}, 1, 0},
                                                                          {{0, 1}, {}, 0, 1},
                                                                          {{0, 2}, {0, 1, 2}, 1, 0},
                                                                          {{0, 2}, {}, 0, 1},
                                                                          {{1, 2}, {0, 1, 2}, 1, 0},
                                                                          {{1, 2}, {}, 0, 1},
                                                                          {{0, 1, 2}, {}, 2, 0}}));
  // Kind (1,2): all of the closed half circle is one family.
  EXPECT_EQ(named_from({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}}, {0, 1, 2}), (std::vector<Named>{{{0, 1, 2}, {}, 0, 1}}));
}

TEST(OracleConnections, FromOnePointOfIndexTwoToAnother) {
  CITES("FC-CONN-01", "FC-CONN-03");
  EXPECT_EQ(named_from(kWithSector, {0, 1, 2}),
            (std::vector<Named>{{{0, 1, 2}, {0, 3, 4}, 1, 0}, {{0, 1, 2}, {}, 1, 0}}));
  EXPECT_FALSE(is_morse_smale(PointSet(kWithSector)));
}

// The direction towards {1,2,3,4} is an end of the arc of the same limit: both are one family of orbits.
TEST(OracleConnections, ADirectionBesideAnArcOfItsLimitIsNoneOfItsOwn) {
  CITES("FC-CONN-02");
  EXPECT_EQ(named_from(kChain, {1, 2}), (std::vector<Named>{{{1, 2}, {0, 1, 2}, 1, 0},
                                                            {{1, 2}, {1, 2, 3}, 1, 0},
                                                            {{1, 2}, {0, 1, 2, 3}, 0, 1},
                                                            {{1, 2}, {1, 2, 3, 4}, 0, 1},
                                                            {{1, 2}, {}, 0, 1}}));
}

// The edge {0,1} dangles inside of the polygon of the other edges. Both of its orbits come to the triangle 0, 4, 5,
// which is obtuse, and go on from its centre as one: (x,0,0) with x^2 = (x - 69)^2 + 90^2.
TEST(OracleConnections, OrbitsOfTwoDirectionsMayMeet) {
  CITES("FC-CONN-02");
  const Rows rows = {{0, 0, 0}, {-10, 0, 0}, {-11, 30, 0}, {-11, -30, 0}, {69, 90, 0}, {69, -90, 0}, {300, 0, 0}};
  EXPECT_EQ(named_from(rows, {0, 1}), (std::vector<Named>{{{0, 1}, {4, 5, 6}, 2, 0}, {{0, 1}, {}, 0, 2}}));
  const PointSet set(rows);
  const Point meeting = {Rational(12861, 138), 0, 0};
  for (const int side : {-1, 1}) {
    const Orbit path = orbit(set, {-5, side, 0});
    EXPECT_TRUE(std::ranges::any_of(path.segments, [&](const FlowSegment& s) { return s.end == meeting; }));
    EXPECT_EQ(path.limit->contact, (Names{4, 5, 6}));
  }
}

TEST(OracleConnections, MorseSmaleSets) {
  CITES("FC-CONN-03");
  EXPECT_TRUE(is_morse_smale(PointSet(Rows{})));
  EXPECT_TRUE(is_morse_smale(PointSet({{0, 0, 0}, {2, 0, 0}, {6, 0, 0}})));
  EXPECT_TRUE(is_morse_smale(PointSet({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}})));
  EXPECT_FALSE(is_morse_smale(PointSet({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}})));
  EXPECT_FALSE(is_morse_smale(PointSet(kChain)));
}

struct Subject {
  explicit Subject(const Rows& rows) : set(rows), all(stationary_points(set).stationary), graph(connections(set)) {
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
void add_chains(const StableSet& stable, const Point& front, std::map<Point, std::size_t>& found) {
  for (const BackwardSegment& segment : stable.segments) {
    if (segment.front != front) continue;
    if (segment.back_kind == BackKind::kCritical) ++found[segment.back];
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
  const double scale = flowcert::property::scale_of_run();
  const std::uint64_t seeds = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(4 * scale));
  const auto visit_drawn = [&](const flowcert::fuzz::Family& family, std::uint64_t seed, int size) {
    SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
    Rows rows = flowcert::fuzz::draw(family, seed, size).rows;
    rows.resize(std::min<std::size_t>(rows.size(), scale < 1 ? 7 : 10));
    visit(Subject(rows));
  };
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    for (const auto& family : flowcert::fuzz::families()) visit_drawn(family, seed, 12 + static_cast<int>(8 * seed));
    for (const auto& family : flowcert::fuzz::stable_families()) visit_drawn(family, seed, 100);
  }
}

TEST(OracleConnections, HoldsToItsLawsInAllFamilies) {
  CITES("FC-CONN-01", "FC-CONN-02", "FC-CONN-03", "FC-STAB-06", "FC-CHAIN-01");
  Count count;
  for_each_drawn([&](const Subject& subject) {
    expect_upwards(subject, count);
    expect_numbers(subject);
    expect_separated(subject, count);
    expect_connecting_orbits(subject);
    if (!subject.has_tie) expect_boundaries(subject);
    const bool morse_smale = is_morse_smale(subject.set);
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
  EXPECT_GT(count.without_ties, 10 * scale);
  EXPECT_GT(count.morse_smale, 20 * scale);
  EXPECT_GT(count.inputs - count.morse_smale, 50 * scale);
  EXPECT_GT(count.separators, 200 * scale);
  if (scale >= 1) {
    EXPECT_GT(count.kinds["2 -> 2"], 0U);
  }
}

}  // namespace
}  // namespace oracle
