// Connections by the oracle, worked out by hand: single orbits and families, one from index 2 to index 2, orbits that
// meet, and sets that are Morse-Smale or not.
#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/connections.h"
#include "oracle/orbit.h"
#include "tests/cites.h"

namespace oracle::oracle_connections_test {
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

std::vector<Connection> all_connections(const PointSet& set) {
  return connections(set, stationary_points(set).stationary);
}

bool is_smale(const PointSet& set) { return is_morse_smale(set, stationary_points(set).stationary); }

std::vector<Named> named(const Rows& rows) {
  std::vector<Named> result;
  for (const Connection& c : all_connections(PointSet(rows))) {
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
  EXPECT_FALSE(is_smale(PointSet(kWithSector)));
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
  EXPECT_TRUE(is_smale(PointSet(Rows{})));
  EXPECT_TRUE(is_smale(PointSet({{0, 0, 0}, {2, 0, 0}, {6, 0, 0}})));
  EXPECT_TRUE(is_smale(PointSet({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}})));
  EXPECT_FALSE(is_smale(PointSet({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}})));
  EXPECT_FALSE(is_smale(PointSet(kChain)));
}

// A backward segment of the triangle 0, 1, 4 comes to the centre (0,1,0) of the sphere of the points 0 to 3. The
// triangles 0, 2, 3 and 1, 2, 3 lead there. The ways along their Voronoi edges come from further Voronoi vertices,
// because the last three points are near. These intervals alone keep the set from being Morse-Smale.
TEST(OracleConnections, AnIntervalAloneIsNotMorseSmale) {
  CITES("FC-CONN-03");
  const PointSet set({{-2, 0, 0},
                      {2, 0, 0},
                      {0, -1, 1},
                      {0, -1, -1},
                      {0, 5, 0},
                      {-0.625, -1.5, 0},
                      {0.625, -1.5, 0},
                      {0, -1.3125, 0}});
  for (const StationaryPoint& z : stationary_points(set).stationary) {
    EXPECT_TRUE(z.is_critical());
    if (z.face_dimension < 2) continue;
    EXPECT_EQ(z.contact, (Names{0, 1, 4}));
    for (const Orbit& o : unstable_orbits(set, z)) EXPECT_FALSE(o.limit);
  }
  EXPECT_FALSE(is_smale(set));
  // Families of index-1 points lead to this triangle.
  EXPECT_TRUE(std::ranges::any_of(
      all_connections(set), [](const Connection& c) { return c.arcs > 0 && c.to && c.to->contact == Names{0, 1, 4}; }));
}

}  // namespace
}  // namespace oracle::oracle_connections_test
