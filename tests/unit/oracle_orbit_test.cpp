// The oracle's flow: orbits worked out by hand, one for each kind of flow segment of the paper's Table 1, and
// what every orbit must keep, on inputs of all families and rational starts that hit Voronoi faces of every
// dimension; the two orbits of index-2 points; positions as text.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "fuzz/inputs/families.h"
#include "oracle/orbit.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"

namespace oracle::oracle_orbit_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;

std::vector<std::string> types_of(const PointSet& set, const Orbit& path) {
  std::vector<std::string> types;
  types.reserve(path.segments.size());
  for (const FlowSegment& segment : path.segments) types.push_back(segment_type(set, segment));
  return types;
}

using Types = std::vector<std::string>;

TEST(OracleOrbit, FromACellStraightIntoTheMaximum) {
  CITES("FC-FLOW-01", "FC-FLOW-02");
  // A regular tetrahedron with its centre at (1/2,1/2,1/2).
  const PointSet set(Rows{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}});
  // The origin repels (t,t,t) along the diagonal, straight to the centre, where all four meet.
  const Orbit path = orbit(set, {Rational(1, 8), Rational(1, 8), Rational(1, 8)});
  ASSERT_EQ(types_of(set, path), (Types{"C-C-V"}));
  EXPECT_EQ(path.segments[0].driver, (Point{0, 0, 0}));
  EXPECT_EQ(*path.segments[0].end, (Point{Rational(1, 2), Rational(1, 2), Rational(1, 2)}));
  EXPECT_EQ(path.segments[0].end_contact, (std::vector<std::size_t>{0, 1, 2, 3}));
  ASSERT_TRUE(path.limit);
  EXPECT_EQ(path.limit->face_dimension, 3);
  EXPECT_EQ(path.limit->hull_dimension, 3);
}

TEST(OracleOrbit, FromACellThroughAFacetAndAnEdge) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-04");
  // The right triangle (0,0,0) (4,0,0) (0,4,0) is obtuse nowhere; its line of centres is (2,2,z), its
  // circumcentre the middle of the hypotenuse.
  const PointSet set(Rows{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  // The origin is nearest to (1,1/2,1). The way (1,1/2,1)t meets the plane x = 2 at t = 2, in (2,1,2). From
  // there it leads away from the middle (2,0,0), in the direction (0,1,2), to the line of centres in (2,2,4).
  // There the driver is (2,2,0), and the way goes up the line for ever.
  const Orbit path = orbit(set, {1, Rational(1, 2), 1});
  ASSERT_EQ(types_of(set, path), (Types{"C-C-F", "F-F-E", "E-E-inf"}));
  EXPECT_EQ(*path.segments[0].end, (Point{2, 1, 2}));
  EXPECT_EQ(path.segments[1].driver, (Point{2, 0, 0}));
  EXPECT_EQ(*path.segments[1].end, (Point{2, 2, 4}));
  EXPECT_EQ(path.segments[2].driver, (Point{2, 2, 0}));
  EXPECT_FALSE(path.limit);
}

TEST(OracleOrbit, FromAnEdgeOfAnObtuseTriangleAcrossTheFacetOfItsLongSide) {
  CITES("FC-FLOW-01", "FC-FLOW-02");
  // The triangle is obtuse at (0,1,0). The middle of its long side, the origin, drives the points of its line
  // of centres, which is over (0,-3/2).
  const PointSet set(Rows{{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  const FlowSegment segment = *flow_segment(set, {0, Rational(-3, 2), 1});
  EXPECT_EQ(segment_type(set, segment), "E-F-inf");
  EXPECT_EQ(segment.driver, (Point{0, 0, 0}));
  EXPECT_EQ(segment.start_contact, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(segment.crossed_contact, (std::vector<std::size_t>{0, 1}));
}

TEST(OracleOrbit, FromAVertexOfARightAngleAlongItsEdge) {
  CITES("FC-FLOW-01", "FC-FLOW-02");
  // Figure 6: the base has a right angle, so its Voronoi edge goes straight up from the middle of the
  // hypotenuse. The fourth point ends that edge above. Below the base the flow goes down the edge.
  const PointSet set(Rows{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}});
  // The orbit from (0,0,-1) goes down the edge's lower part, which is a ray, for ever. Its driver is the
  // middle of the hypotenuse.
  const Orbit down = orbit(set, {0, 0, -1});
  ASSERT_EQ(types_of(set, down), (Types{"E-E-inf"}));
  EXPECT_EQ(down.segments[0].driver, (Point{0, 0, 0}));
  // From (0,0,1) it goes up to the Voronoi vertex, where (0,0,3) is as near: 1 + z^2 = (3-z)^2, z = 4/3.
  const Orbit up = orbit(set, {0, 0, 1});
  ASSERT_FALSE(up.segments.empty());
  EXPECT_EQ(segment_type(set, up.segments[0]), "E-E-V");
  EXPECT_EQ(*up.segments[0].end, (Point{0, 0, Rational(4, 3)}));
}

// The facet of the edge from (-2,0,0) to (2,0,0) lies in x = 0, round its midpoint: two obtuse points make
// its vertex (0,1,0), two acute ones its vertex (0,3,0), on the same ray from the midpoint.
const Rows kTwoVerticesOnARay = {{-2, 0, 0}, {2, 0, 0}, {0, -1, 1}, {0, -1, -1}, {0, 1, 3}, {0, 1, -3}};

TEST(OracleOrbit, FromAVertexAcrossAFacetIntoAVertex) {
  CITES("FC-FLOW-01", "FC-FLOW-02");
  const PointSet set(kTwoVerticesOnARay);
  const FlowSegment segment = *flow_segment(set, {0, 1, 0});
  EXPECT_EQ(segment_type(set, segment), "V-F-V");
  EXPECT_EQ(segment.driver, (Point{0, 0, 0}));
  EXPECT_EQ(segment.start_contact, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(segment.crossed_contact, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(*segment.end, (Point{0, 3, 0}));
  EXPECT_EQ(segment.end_contact, (std::vector<std::size_t>{0, 1, 4, 5}));
}

TEST(OracleOrbit, AStationaryPointStays) {
  CITES("FC-FLOW-03");
  const PointSet set(Rows{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}});
  for (const StationaryPoint& point : stationary_points({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}).stationary) {
    const Orbit path = orbit(set, point.center);
    EXPECT_TRUE(path.segments.empty());
    ASSERT_TRUE(path.limit);
    EXPECT_EQ(*path.limit, point);
  }
}

const std::set<std::string> kTableOne = {"V-E-V",   "V-E-inf", "E-E-V", "E-E-inf", "V-F-V",  "V-F-E",
                                         "V-F-inf", "E-F-V",   "E-F-E", "E-F-inf", "F-F-V",  "F-F-E",
                                         "F-F-inf", "C-C-V",   "C-C-E", "C-C-F",   "C-C-inf"};

// Centres of random small subsets hit Voronoi vertices, edges and facets. A mixture of two such centres
// seldom hits any of them.
Point random_start(const PointSet& set, rc::Random& random) {
  const auto next = [&random](std::size_t bound) { return static_cast<std::size_t>(random.next() % bound); };
  const auto centre = [&]() -> Point {
    std::vector<Point> simplex;
    const std::size_t size = 1 + next(4);
    simplex.reserve(size);
    for (std::size_t k = 0; k < size; ++k) simplex.push_back(set.points[next(set.points.size())]);
    return circumcentre(spanning_subset(simplex))->center;
  };
  Point a = centre();
  if (next(2) == 0) return a;
  const Point b = centre();
  const Rational weight(static_cast<long>(next(7)), 3);
  Point mixed;
  for (std::size_t axis = 0; axis < 3; ++axis) mixed[axis] = a[axis] + weight * (b[axis] - a[axis]);
  return mixed;
}

void expect_segment_keeps_its_promises(const PointSet& set, const FlowSegment& segment) {
  EXPECT_TRUE(kTableOne.contains(segment_type(set, segment))) << segment_type(set, segment);
  EXPECT_TRUE(std::includes(segment.start_contact.begin(), segment.start_contact.end(), segment.crossed_contact.begin(),
                            segment.crossed_contact.end()));
  if (!segment.end) return;
  // The middle of the segment has the crossed face's contact set, and the start's driver.
  Point middle;
  for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = (segment.start[axis] + (*segment.end)[axis]) / 2;
  EXPECT_EQ(contact_set(set, middle), segment.crossed_contact);
  EXPECT_EQ(driver(set, set.nearest_places(middle), middle), segment.driver);
  EXPECT_NE(segment.end_contact, segment.crossed_contact);
  const auto distance = [&set](const Point& x) { return squared_distance(x, set.points[set.nearest_places(x)[0]]); };
  EXPECT_LT(distance(segment.start), distance(middle));
  EXPECT_LT(distance(middle), distance(*segment.end));
}

// The squared radius of the ball that encloses C(x), by Pythagoras: x is equally far from all of C(x).
Rational squared_ball_radius(const PointSet& set, const FlowSegment& segment) {
  const Rational distance = squared_distance(segment.start, set.points[set.nearest_places(segment.start)[0]]);
  return distance - squared_distance(segment.start, segment.driver);
}

void expect_growing_balls(const PointSet& set, const Orbit& path) {
  for (std::size_t k = 1; k < path.segments.size(); ++k) {
    if (path.segments[k].driver == path.segments[k - 1].driver) continue;
    EXPECT_LT(squared_ball_radius(set, path.segments[k - 1]), squared_ball_radius(set, path.segments[k]));
  }
}

TEST(OracleOrbit, EveryOrbitKeepsItsPromises) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-04", "FC-FLOW-05");
  std::map<std::string, int> seen;
  std::size_t orbits = 1;
  const PointSet made(kTwoVerticesOnARay);  // V-F-V is too rare to wait for
  for (const FlowSegment& segment : orbit(made, {0, 1, 0}).segments) {
    expect_segment_keeps_its_promises(made, segment);
    ++seen[segment_type(made, segment)];
  }
  for (const flowcert::fuzz::Family& family : flowcert::fuzz::families()) {
    rc::Random random(7);
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const PointSet set(flowcert::fuzz::draw(family, seed, 20).rows);
      if (set.points.empty()) continue;
      for (int k = 0; k < 4; ++k, ++orbits) {
        const Orbit path = orbit(set, random_start(set, random));
        for (const FlowSegment& segment : path.segments) {
          expect_segment_keeps_its_promises(set, segment);
          ++seen[segment_type(set, segment)];
        }
        expect_growing_balls(set, path);
        if (!path.limit) {
          ASSERT_FALSE(path.segments.back().end);
        } else if (!path.segments.empty()) {
          EXPECT_EQ(path.limit->contact, path.segments.back().end_contact);
        }
      }
    }
  }
  std::printf("%zu orbits; segments by type:", orbits);
  for (const auto& [type, count] : seen) std::printf(" %s %d", type.c_str(), count);
  std::printf("\n");
  // Every entry of Table 1 was met.
  EXPECT_EQ(seen.size(), kTableOne.size());
}

// The signed permutation (x,y,z) -> (-z, x, y), and doubling.
TEST(OracleOrbit, IsEquivariant) {
  CITES("FC-FLOW-06");
  const auto turned = [](const auto& p) { return std::decay_t<decltype(p)>{-2 * p[2], 2 * p[0], 2 * p[1]}; };
  for (const flowcert::fuzz::Family& family : flowcert::fuzz::families()) {
    if (family.name == "extreme-scale" || family.name == "mixed-magnitudes") continue;  // doubling would overflow
    rc::Random random(11);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Rows rows = flowcert::fuzz::draw(family, seed, 20).rows;
      if (rows.empty()) continue;
      Rows other;
      for (const auto& row : rows) other.push_back(turned(row));
      const PointSet set(rows), image(other);
      const Point start = random_start(set, random);
      const Orbit path = orbit(set, start), turned_path = orbit(image, turned(start));
      ASSERT_EQ(path.segments.size(), turned_path.segments.size());
      for (std::size_t k = 0; k < path.segments.size(); ++k) {
        const FlowSegment &a = path.segments[k], &b = turned_path.segments[k];
        EXPECT_EQ(turned(a.start), b.start);
        EXPECT_EQ(turned(a.driver), b.driver);
        EXPECT_EQ(a.start_contact, b.start_contact);
        EXPECT_EQ(a.crossed_contact, b.crossed_contact);
        EXPECT_EQ(a.end_contact, b.end_contact);
      }
    }
  }
}

// The critical point of index 2 with this contact set.
StationaryPoint saddle_of(const Rows& rows, const std::vector<std::size_t>& contact) {
  for (const StationaryPoint& point : stationary_points(rows).stationary) {
    if (point.contact == contact && point.face_dimension == 2) return point;
  }
  throw std::logic_error("no such saddle");
}

TEST(OracleUnstableOrbit, OfATetrahedronsFacetGoesToTheMaximumAndToInfinity) {
  CITES("FC-FLOW-07", "FC-FLOW-02");
  const Rows rows = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  const PointSet set(rows);
  const StationaryPoint saddle = saddle_of(rows, {1, 2, 3});
  // (b - a) x (c - a) = (-1,-1,-1): side 1 is that of the origin.
  const auto orbits = unstable_orbits(set, saddle);
  ASSERT_EQ(types_of(set, orbits[1]), (Types{"E-E-V"}));
  const FlowSegment& inwards = orbits[1].segments[0];
  EXPECT_EQ(inwards.start, saddle.center);
  EXPECT_EQ(inwards.driver, saddle.center);
  EXPECT_EQ(inwards.start_contact, saddle.contact);
  EXPECT_EQ(inwards.crossed_contact, saddle.contact);
  EXPECT_EQ(inwards.end_contact, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(*inwards.end, (Point{Rational(1, 2), Rational(1, 2), Rational(1, 2)}));
  ASSERT_TRUE(orbits[1].limit);
  EXPECT_EQ(orbits[1].limit->hull_dimension, 3);
  ASSERT_EQ(types_of(set, orbits[0]), (Types{"E-E-inf"}));
  EXPECT_FALSE(orbits[0].segments[0].end);
  EXPECT_TRUE(orbits[0].segments[0].end_contact.empty());
  EXPECT_FALSE(orbits[0].limit);
}

TEST(OracleUnstableOrbit, OfCocircularContacts) {
  CITES("FC-FLOW-07");
  // The bottom of the unit cube, named in an order that is not that of the circle; side 1 is up.
  const Rows rows = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const PointSet set(rows);
  const StationaryPoint saddle = saddle_of(rows, {0, 1, 2, 3});
  const Orbit up = unstable_orbit(set, saddle, 1), down = unstable_orbit(set, saddle, 0);
  ASSERT_EQ(types_of(set, up), (Types{"E-E-V"}));
  EXPECT_EQ(up.segments[0].crossed_contact, (std::vector<std::size_t>{0, 1, 2, 3}));
  ASSERT_TRUE(up.limit);
  EXPECT_EQ(up.limit->center, (Point{Rational(1, 2), Rational(1, 2), Rational(1, 2)}));
  EXPECT_EQ(types_of(set, down), (Types{"E-E-inf"}));
}

TEST(OracleUnstableOrbit, TheOrderOfTheNamesTellsTheSides) {
  CITES("FC-FLOW-07");
  // Repeated rows: the classes are 0, 1, 3 and 4, so names are not places.
  const Rows rows = {{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {2, 3, 0}, {2, 1, 9}};
  Rows other = rows;
  std::swap(other[1], other[3]);
  const PointSet set(rows), swapped(other);
  const auto orbits = unstable_orbits(set, saddle_of(rows, {0, 1, 3}));
  const auto exchanged = unstable_orbits(swapped, saddle_of(other, {0, 1, 3}));
  ASSERT_TRUE(orbits[1].segments[0].end);
  EXPECT_GT((*orbits[1].segments[0].end)[2], 0);
  EXPECT_EQ(orbits[1].segments[0].end_contact, (std::vector<std::size_t>{0, 1, 3, 4}));
  EXPECT_FALSE(orbits[0].segments[0].end);
  EXPECT_EQ(exchanged[0].segments[0].end, orbits[1].segments[0].end);
  EXPECT_FALSE(exchanged[1].segments[0].end);
}

TEST(OracleUnstableOrbit, OfCoplanarPointsGoesToInfinityBothWays) {
  CITES("FC-FLOW-07");
  const Rows rows = {{0, 0, 1}, {4, 0, 1}, {2, 3, 1}, {9, 9, 1}};
  const PointSet set(rows);
  for (const Orbit& path : unstable_orbits(set, saddle_of(rows, {0, 1, 2}))) {
    EXPECT_EQ(types_of(set, path), (Types{"E-E-inf"}));
    EXPECT_FALSE(path.limit);
  }
}

TEST(OracleUnstableOrbit, OnlyOfIndexTwoAndTwoSides) {
  const Rows rows = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  const PointSet set(rows);
  for (const StationaryPoint& point : stationary_points(rows).stationary) {
    if (point.hull_dimension == 2) continue;
    EXPECT_THROW(unstable_orbits(set, point), std::invalid_argument);
  }
  EXPECT_THROW(unstable_orbit(set, saddle_of(rows, {1, 2, 3}), 2), std::invalid_argument);
  EXPECT_THROW(unstable_orbit(set, saddle_of(rows, {1, 2, 3}), -1), std::invalid_argument);
  // Kind (2,3): its centre lies in a triangle, as that of an index-2 point, but there is a fourth contact.
  const Rows centred = {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}};
  const StationaryPoint regular = saddle_of(centred, {0, 1, 2, 3});
  EXPECT_EQ(regular.hull_dimension, 3);
  EXPECT_THROW(unstable_orbits(PointSet(centred), regular), std::invalid_argument);
}

// The saddle drives the points of the first segment. The orbit of such a point is the rest of the saddle's orbit.
void expect_an_orbit_of_its_points(const PointSet& set, const StationaryPoint& saddle, int side) {
  const Orbit path = unstable_orbit(set, saddle, side);
  FlowSegment first = path.segments.front();
  expect_segment_keeps_its_promises(set, first);
  Point start = saddle.center;  // moved below to a point before the segment's end
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (first.end) start[axis] += ((*first.end)[axis] - start[axis]) / 3;
  }
  if (!first.end) {
    std::vector<Point> p;
    for (const std::size_t place : set.nearest_places(saddle.center)) p.push_back(set.points[place]);
    const Point u = minus(p[1], p[0]), v = minus(p[2], p[0]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
      start[axis] += (2 * side - 1) * (u[y] * v[z] - u[z] * v[y]);
    }
  }
  const Orbit rest = orbit(set, start);
  ASSERT_EQ(rest.segments.size(), path.segments.size());
  first.start = start;
  for (std::size_t k = 0; k < rest.segments.size(); ++k) {
    const FlowSegment &a = rest.segments[k], &b = k == 0 ? first : path.segments[k];
    EXPECT_EQ(a.start, b.start);
    EXPECT_EQ(a.driver, b.driver);
    EXPECT_EQ(a.start_contact, b.start_contact);
    EXPECT_EQ(a.crossed_contact, b.crossed_contact);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.end_contact, b.end_contact);
  }
  EXPECT_EQ(rest.limit, path.limit);
}

TEST(OracleUnstableOrbit, IsTheOrbitOfThePointsOfItsFirstSegment) {
  CITES("FC-FLOW-07", "FC-FLOW-01", "FC-FLOW-04", "FC-FLOW-05");
  std::size_t orbits = 0, to_infinity = 0, long_ones = 0, cocircular = 0;
  for (const flowcert::fuzz::Family& family : flowcert::fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Rows rows = flowcert::fuzz::draw(family, seed, 12).rows;
      const PointSet set(rows);
      for (const StationaryPoint& point : stationary_points(rows).stationary) {
        if (point.face_dimension != 2 || point.hull_dimension != 2) continue;
        for (const int side : {0, 1}) {
          expect_an_orbit_of_its_points(set, point, side);
          const Orbit path = unstable_orbit(set, point, side);
          ++orbits;
          if (!path.limit) ++to_infinity;
          if (path.segments.size() > 1) ++long_ones;
          if (point.contact.size() > 3) ++cocircular;
        }
      }
    }
  }
  std::printf("%zu orbits, %zu to infinity, %zu of several segments, %zu from cocircular contacts\n", orbits,
              to_infinity, long_ones, cocircular);
  EXPECT_GE(to_infinity, 100U);
  EXPECT_GE(orbits - to_infinity, 100U);
  EXPECT_GE(long_ones, 100U);
  EXPECT_GE(cocircular, 50U);
}

TEST(OraclePosition, NumbersFractionsAndSeparators) {
  CITES("FC-IN-02", "FC-NUM-02");
  const Point expected = {Rational(-1, 2), Rational(1, 4), Rational(3)};
  for (const char* text :
       {"-1/2,0.25,3", " -2/4  0x1p-2\t,6/2 ", "-.5 , 002/8 +9/3", "-0x.8,25e-2,3.", "-1/2\n1/4\n3"}) {
    EXPECT_EQ(parse_position(text, ""), expected) << text;
  }
  EXPECT_EQ(parse_position("0.1 -0/7 1e-400", ""), (Point{Rational(0.1), 0, 0}));
  const std::string digits(40000, '7');
  EXPECT_EQ(parse_position(digits + "0/" + digits + ",0,0", "")[0], Rational(10));
}

TEST(OraclePosition, WhatIsNone) {
  CITES("FC-IN-01", "FC-IN-02");
  const std::pair<const char*, const char*> errors[] = {
      {"", "three coordinates X,Y,Z expected, found 0"},
      {"1,2", "three coordinates X,Y,Z expected, found 2"},
      {"1,2,3,4", "three coordinates X,Y,Z expected, found 4"},
      {"1,2,3,", "three coordinates X,Y,Z expected, found 4"},
      {"1,,3", "'' is not a number"},
      {",1,3", "'' is not a number"},
      {"1/0,0,0", "'1/0' is not a fraction"},
      {"0 0 1/-2", "'1/-2' is not a fraction"},
      {"0 0 +-1/2", "'+-1/2' is not a fraction"},
      {"1.5/2 0 0", "'1.5/2' is not a fraction"},
      {"0x1/2 0 0", "'0x1/2' is not a fraction"},
      {"1/2/3 0 0", "'1/2/3' is not a fraction"},
      {"/ 0 0", "'/' is not a fraction"},
      {"0,nan,0", "'nan' is not a finite double"},
      {"0,-inf,0", "'-inf' is not a finite double"},
      {"0,1e400,0", "'1e400' is not a finite double"},
      {"0x1.00000000000001p0,0,0", "'0x1.00000000000001p0' is not exactly a double"},
      {"0,0,zero", "'zero' is not a number"},
      {"0,0,1#", "'1#' is not a number"}};
  for (const auto& [text, message] : errors) {
    try {
      parse_position(text, "w: ");
      ADD_FAILURE() << text;
    } catch (const UnusableInput& error) {
      EXPECT_EQ(error.what(), std::string("w: ") + message);
    }
  }
}

}  // namespace
}  // namespace oracle::oracle_orbit_test
