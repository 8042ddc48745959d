// The oracle's stable sets, worked out by hand: what leads to a point, branches that end at a midpoint, cross
// a Voronoi edge or meet a Voronoi vertex, intervals and sectors, the regular stationary points of all kinds,
// boundary walks, and which points belong to a set.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/vectors/manifold_fields.h"

namespace oracle::oracle_stable_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;
using Edges = std::vector<std::array<std::size_t, 2>>;
using Segments = std::vector<BackwardSegment>;
using Intervals = std::vector<EdgePart>;
using Sectors = std::vector<Region>;

Rational ratio(long numerator, long denominator) { return Rational(numerator) / denominator; }

struct Example {
  explicit Example(const Rows& rows, const Names& contact) : set(rows) {
    for (const StationaryPoint& point : stationary_points(rows).stationary) {
      if (point.contact == contact) z = point;
    }
    if (z.contact.empty()) throw std::logic_error("no such stationary point");
    stable = stable_set(set, z);
  }
  bool has(const Point& x) const { return contains(set, stable, x); }

  PointSet set;
  StationaryPoint z;
  StableSet stable;
};

// The segments of a skeleton, without their contact sets.
struct Branch {
  std::array<std::size_t, 2> samples;
  Point front, back;
  BackKind kind;

  friend bool operator==(const Branch&, const Branch&) = default;
};

std::vector<Branch> branches(const StableSet& stable) {
  std::vector<Branch> result;
  result.reserve(stable.segments.size());
  for (const BackwardSegment& s : stable.segments) {
    result.push_back({s.samples, s.front.position, s.back.position, s.back_kind});
  }
  return result;
}

constexpr BackKind kCritical = BackKind::kCritical;

TEST(OracleStable, OfAnAcuteTriangle) {
  CITES("FC-STAB-02", "FC-STAB-03", "FC-STAB-04", "FC-STAB-06", "FC-STAB-07");
  // The circumcentre (2,y) of a triangle that contains it: 4 + y^2 = (3 - y)^2.
  const Example t({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}, {0, 1, 2});
  const Point z = {2, ratio(5, 6), 0};
  const Names all = {0, 1, 2};
  const Point m01 = {2, 0, 0}, m02 = {1, ratio(3, 2), 0}, m12 = {3, ratio(3, 2), 0};
  EXPECT_EQ(t.stable.segments, (Segments{{{{0, 1}, z, m01}, all, {0, 1}, kCritical},
                                         {{{0, 2}, z, m02}, all, {0, 2}, kCritical},
                                         {{{1, 2}, z, m12}, all, {1, 2}, kCritical}}));
  EXPECT_EQ(t.stable.points, (std::vector<SkeletonPoint>{{z, all}}));
  EXPECT_TRUE(t.stable.intervals.empty());
  EXPECT_TRUE(t.stable.sectors.empty());
  EXPECT_FALSE(t.stable.has_vertex);
  const Point p0 = {0, 0, 0}, p1 = {4, 0, 0}, p2 = {2, 3, 0};
  EXPECT_EQ(
      triangles(t.set, t.stable),
      (std::vector<Triangle>{{p0, z, m01}, {p1, z, m01}, {p0, z, m02}, {p2, z, m02}, {p1, z, m12}, {p2, z, m12}}));
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), all);
  EXPECT_EQ(boundary_edges(t.stable), (Edges{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(OracleStable, ContainsTheOpenTriangle) {
  CITES("FC-STAB-01", "FC-STAB-02", "FC-STAB-04");
  const Example t({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}, {0, 1, 2});
  EXPECT_TRUE(t.has({2, ratio(5, 6), 0}));                 // z
  EXPECT_TRUE(t.has({1, ratio(5, 12), 0}));                // between a sample and z
  EXPECT_TRUE(t.has({2, ratio(1, 2), 0}));                 // on a segment
  EXPECT_TRUE(t.has({ratio(1, 100), ratio(1, 1000), 0}));  // near a corner
  EXPECT_FALSE(t.has({0, 0, 0}));                          // a sample
  EXPECT_FALSE(t.has({2, 0, 0}));                          // a saddle of index 1
  EXPECT_FALSE(t.has({1, 0, 0}));                          // on the way to that
  EXPECT_FALSE(t.has({2, ratio(-1, 1000), 0}));
  EXPECT_FALSE(t.has({2, ratio(1, 2), ratio(1, 1000)}));
  EXPECT_FALSE(t.has({2, ratio(5, 6), 1}));
}

TEST(OracleStable, OfASquareUnderAPoint) {
  CITES("FC-STAB-03", "FC-STAB-04", "FC-STAB-07");
  // Named crosswise: 0 and 1 are opposite corners. The diagonals do not lead to the centre.
  const Example t({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 3}}, {0, 1, 2, 3});
  const Point z = {1, 1, 0};
  EXPECT_EQ(branches(t.stable), (std::vector<Branch>{{{0, 2}, z, {1, 0, 0}, kCritical},
                                                     {{0, 3}, z, {0, 1, 0}, kCritical},
                                                     {{1, 2}, z, {2, 1, 0}, kCritical},
                                                     {{1, 3}, z, {1, 2, 0}, kCritical}}));
  EXPECT_EQ(triangles(t.set, t.stable).size(), 8U);
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), (Names{0, 2, 1, 3}));
  EXPECT_EQ(boundary_edges(t.stable), (Edges{{0, 2}, {0, 3}, {1, 2}, {1, 3}}));
}

TEST(OracleStable, CrossesTheVoronoiEdgeOfAnObtuseNeighbour) {
  CITES("FC-STAB-03", "FC-STAB-04", "FC-STAB-06", "FC-STAB-07");
  // The acute triangle again. (2,-3/2) is outside of its circle and sees its lower side at an obtuse angle.
  // Their circumcentre (2,y), with 4 + y^2 = (y + 3/2)^2, is in the way to the middle of that side.
  const Example t({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -1.5, 0}}, {0, 1, 2});
  const Point z = {2, ratio(5, 6), 0}, crossing = {2, ratio(7, 12), 0};
  EXPECT_EQ(branches(t.stable), (std::vector<Branch>{{{0, 1}, z, crossing, BackKind::kEdge},
                                                     {{0, 2}, z, {1, ratio(3, 2), 0}, kCritical},
                                                     {{0, 3}, crossing, {1, ratio(-3, 4), 0}, kCritical},
                                                     {{1, 2}, z, {3, ratio(3, 2), 0}, kCritical},
                                                     {{1, 3}, crossing, {3, ratio(-3, 4), 0}, kCritical}}));
  EXPECT_EQ(t.stable.segments[0].back_contact, (Names{0, 1, 3}));
  EXPECT_EQ(t.stable.points, (std::vector<SkeletonPoint>{{crossing, {0, 1, 3}}, {z, {0, 1, 2}}}));
  EXPECT_FALSE(t.stable.has_vertex);
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), (Names{0, 3, 1, 2}));
  EXPECT_EQ(boundary_edges(t.stable), (Edges{{0, 2}, {0, 3}, {1, 2}, {1, 3}}));
  EXPECT_TRUE(t.has({1, 0, 0}));
  EXPECT_TRUE(t.has({2, 0, 0}));
  EXPECT_TRUE(t.has({2, -1, 0}));
}

TEST(OracleStable, EndsAtTheHypotenuseOfARightNeighbour) {
  CITES("FC-STAB-04", "FC-STAB-07");
  // (2,-2) sees the lower side at a right angle, so the side's middle is regular stationary.
  const Rows rows = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -2, 0}};
  const Example t(rows, {0, 1, 2});
  const BackwardSegment& down = t.stable.segments[0];
  EXPECT_EQ(down.samples, (std::array<std::size_t, 2>{0, 1}));
  EXPECT_EQ(down.back, (Point{2, 0, 0}));
  EXPECT_EQ(down.back_contact, (Names{0, 1, 3}));
  EXPECT_EQ(down.back_kind, BackKind::kRegular);
  EXPECT_EQ(t.stable.segments.size(), 3U);
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), (Names{0, 1, 2}));
  // The right triangle and the hypotenuse itself flow to that middle.
  const Example right(rows, {0, 1, 3});
  EXPECT_TRUE(right.has({2, 0, 0}));
  EXPECT_TRUE(right.has({1, 0, 0}));
  EXPECT_TRUE(right.has({2, -1, 0}));
  EXPECT_FALSE(right.has({2, ratio(1, 100), 0}));
}

// (0,7,0), 0 and 1 make an acute triangle with its centre z = (0,20/7,0): 9 + y^2 = (7 - y)^2. Points 2 and 3
// are below, on the sphere of centre (0,1,0) and squared radius 10 through 0 and 1. This centre is a Voronoi
// vertex on the way from the middle of 0 and 1 to z. The tetrahedron's edges 0 3 and 1 2 are the longest
// sides of obtuse triangles: <(-2,2,0),(1,0,-1)> < 0 at 2, <(3,2,1),(-1,0,1)> < 0 at 3.
const Rows kThroughAVertex = {{-3, 0, 0}, {3, 0, 0}, {-1, -2, 0}, {0, -2, -1}, {0, 7, 0}};

TEST(OracleStable, MeetsAVoronoiVertex) {
  CITES("FC-STAB-03", "FC-STAB-04", "FC-STAB-06");
  const Example t(kThroughAVertex, {0, 1, 4});
  const Point z = {0, ratio(20, 7), 0}, vertex = {0, 1, 0};
  EXPECT_EQ(branches(t.stable), (std::vector<Branch>{{{0, 1}, z, vertex, BackKind::kVertex},
                                                     {{0, 2}, vertex, {-2, -1, 0}, kCritical},
                                                     {{0, 4}, z, {ratio(-3, 2), ratio(7, 2), 0}, kCritical},
                                                     {{1, 3}, vertex, {ratio(3, 2), -1, ratio(-1, 2)}, kCritical},
                                                     {{1, 4}, z, {ratio(3, 2), ratio(7, 2), 0}, kCritical},
                                                     {{2, 3}, vertex, {ratio(-1, 2), -2, ratio(-1, 2)}, kCritical}}));
  EXPECT_EQ(t.stable.segments[0].back_contact, (Names{0, 1, 2, 3}));
  EXPECT_TRUE(t.stable.has_vertex);
  EXPECT_TRUE(t.stable.intervals.empty());  // no face of the tetrahedron contains its centre
  EXPECT_EQ(triangles(t.set, t.stable).size(), 12U);
  EXPECT_THROW(boundary_walk(t.set, t.z, t.stable), std::invalid_argument);
  EXPECT_THROW(boundary_edges(t.stable), std::invalid_argument);
}

TEST(OracleStable, AnIndexTwoPointOfDimensionThree) {
  CITES("FC-STAB-05", "FC-STAB-06");
  // Two other points are on the sphere here, whose squared radius is 5. The Voronoi edges of 0 2 3 and 1 2 3
  // now lead from these triangles' centres, (-+4/5,-3/5,0), to the vertex. The first one's plane is
  // x + 2y = -2, and (0,1,0) - 4/5 (1,2,0) lies on it, 3/5 of the way from 0 to the middle of 2 and 3.
  const Example t({{-2, 0, 0}, {2, 0, 0}, {0, -1, 1}, {0, -1, -1}, {0, 5, 0}}, {0, 1, 4});
  ASSERT_EQ(t.z.hull_dimension, 2);
  const Point vertex = {0, 1, 0}, left = {ratio(-4, 5), ratio(-3, 5), 0}, right = {ratio(4, 5), ratio(-3, 5), 0};
  EXPECT_EQ(t.stable.intervals, (Intervals{{{0, 2, 3}, vertex, left}, {{1, 2, 3}, vertex, right}}));
  EXPECT_EQ(t.stable.sectors.size(), 6U);
  EXPECT_EQ(t.stable.segments.size(), 8U);
  EXPECT_THROW(triangles(t.set, t.stable), std::invalid_argument);
}

TEST(OracleStable, OfKindOneTwo) {
  CITES("FC-STAB-01", "FC-STAB-03", "FC-STAB-04", "FC-STAB-07");
  const Example t({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {0, 1, 2});
  const Point z = {ratio(3, 2), 2, 0}, m01 = {ratio(3, 2), 0, 0}, m02 = {0, 2, 0};
  EXPECT_EQ(branches(t.stable), (std::vector<Branch>{{{0, 1}, z, m01, kCritical}, {{0, 2}, z, m02, kCritical}}));
  EXPECT_EQ(triangles(t.set, t.stable).size(), 4U);
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), (Names{0, 1, 2}));
  EXPECT_EQ(boundary_edges(t.stable), (Edges{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_TRUE(t.has({1, 1, 0}));
  EXPECT_TRUE(t.has({ratio(9, 4), 1, 0}));  // on the hypotenuse, which belongs to the set
  EXPECT_FALSE(t.has({1, 0, 0}));
  EXPECT_FALSE(t.has({ratio(3, 2), 3, 0}));
}

TEST(OracleStable, OfKindTwoThree) {
  CITES("FC-STAB-01", "FC-STAB-03", "FC-STAB-05");
  // The triangle 0 1 2 contains the centre, and does not lead to it; the others do.
  const Example t({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}}, {0, 1, 2, 3});
  const Point z = {0, 0, 0};
  EXPECT_EQ(t.stable.intervals, (Intervals{{{0, 1, 3}, z, Point{ratio(5, 6), ratio(5, 3), ratio(5, 6)}},
                                           {{0, 2, 3}, z, Point{ratio(5, 6), ratio(-5, 3), ratio(5, 6)}},
                                           {{1, 2, 3}, z, Point{ratio(-75, 34), 0, ratio(45, 34)}}}));
  EXPECT_EQ(t.stable.segments.size(), 6U);
  EXPECT_TRUE(std::all_of(t.stable.segments.begin(), t.stable.segments.end(),
                          [](const BackwardSegment& s) { return s.back_kind == kCritical; }));
  EXPECT_EQ(t.stable.sectors.size(), 9U);
  EXPECT_TRUE(t.stable.has_vertex);
  EXPECT_TRUE(t.has({1, 0, 0}));
  EXPECT_TRUE(t.has({1, 0, ratio(1, 100)}));
  EXPECT_FALSE(t.has({1, 0, ratio(-1, 100)}));
}

TEST(OracleStable, OfKindOneThree) {
  CITES("FC-STAB-01", "FC-STAB-03", "FC-STAB-05");
  // The edge 0 1 and the two right triangles on it contain the centre; the two other triangles lead to it.
  const Example t({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3});
  const Rational third = ratio(1, 3), half = ratio(1, 2);
  const Point z = {0, 0, 0}, right = {third, third, third}, left = {-third, third, third};
  const Point m02 = {half, half, 0}, m03 = {half, 0, half}, m12 = {-half, half, 0}, m13 = {-half, 0, half},
              m23 = {0, half, half};
  EXPECT_EQ(branches(t.stable), (std::vector<Branch>{{{0, 2}, z, m02, kCritical},
                                                     {{0, 3}, z, m03, kCritical},
                                                     {{1, 2}, z, m12, kCritical},
                                                     {{1, 3}, z, m13, kCritical},
                                                     {{2, 3}, z, m23, kCritical}}));
  EXPECT_EQ(t.stable.intervals, (Intervals{{{0, 2, 3}, z, right}, {{1, 2, 3}, z, left}}));
  EXPECT_EQ(t.stable.sectors, (Sectors{{{0, 2}, {z, right, m02}},
                                       {{0, 3}, {z, right, m03}},
                                       {{1, 2}, {m12, left, z}},
                                       {{1, 3}, {m13, left, z}},
                                       {{2, 3}, {left, z, m23}},
                                       {{2, 3}, {z, m23, right}}}));
}

// The last example, six times as large, and a fifth point. The facet of 0 and 2 lies in x = y, and the fifth
// point cuts into it: it is nearer where 4x - 6z > 5. That line crosses the way from (3,3,0), the middle of 0
// and 2, to z in (5/4,5/4,0), and the way to (2,2,2), the interval's other end, in (41/16,41/16,7/8).
TEST(OracleStable, ASectorThatLeavesThroughAVoronoiEdge) {
  CITES("FC-STAB-03", "FC-STAB-04", "FC-STAB-05");
  const Example t({{6, 0, 0}, {-6, 0, 0}, {0, 6, 0}, {0, 0, 6}, {4, 4, -3}}, {0, 1, 2, 3});
  const Point z = {0, 0, 0}, right = {2, 2, 2}, left = {-2, 2, 2};
  const Point near = {ratio(5, 4), ratio(5, 4), 0}, far = {ratio(41, 16), ratio(41, 16), ratio(7, 8)};
  const Point m03 = {3, 0, 3}, m04 = {5, 2, ratio(-3, 2)}, m12 = {-3, 3, 0}, m13 = {-3, 0, 3}, m23 = {0, 3, 3},
              m24 = {2, 5, ratio(-3, 2)};
  EXPECT_EQ(t.stable.points, (std::vector<SkeletonPoint>{{z, {0, 1, 2, 3}}, {near, {0, 2, 4}}}));
  EXPECT_EQ(branches(t.stable), (std::vector<Branch>{{{0, 2}, z, near, BackKind::kEdge},
                                                     {{0, 3}, z, m03, kCritical},
                                                     {{0, 4}, near, m04, kCritical},
                                                     {{1, 2}, z, m12, kCritical},
                                                     {{1, 3}, z, m13, kCritical},
                                                     {{2, 3}, z, m23, kCritical},
                                                     {{2, 4}, near, m24, kCritical}}));
  EXPECT_EQ(t.stable.intervals, (Intervals{{{0, 2, 3}, z, right}, {{1, 2, 3}, z, left}}));
  EXPECT_EQ(t.stable.crossed, (Intervals{{{0, 2, 4}, near, far}}));
  EXPECT_EQ(t.stable.sectors, (Sectors{{{0, 2}, {z, near, far, right}},
                                       {{0, 3}, {z, right, m03}},
                                       {{0, 4}, {near, far, m04}},
                                       {{1, 2}, {m12, left, z}},
                                       {{1, 3}, {m13, left, z}},
                                       {{2, 3}, {left, z, m23}},
                                       {{2, 3}, {z, m23, right}},
                                       {{2, 4}, {near, m24, far}}}));
  // Halfway from the crossed interval's middle to that of 0 and 4, and then halfway from there to 4.
  EXPECT_TRUE(t.has({ratio(221, 64), ratio(125, 64), ratio(-17, 32)}));
  EXPECT_TRUE(t.has({ratio(477, 128), ratio(381, 128), ratio(-113, 64)}));
  EXPECT_FALSE(t.has(m04));
  EXPECT_FALSE(t.has({4, 2, -2}));
}

TEST(OracleStable, OfSamplesAndSaddlesOfIndexOne) {
  CITES("FC-STAB-01", "FC-STAB-02");
  const Rows rows = {{0, 0, 0}, {2, 0, 0}, {6, 0, 0}};  // collinear
  const Example sample(rows, {1}), saddle(rows, {1, 2});
  EXPECT_EQ(sample.stable.points, (std::vector<SkeletonPoint>{{{2, 0, 0}, {1}}}));
  EXPECT_EQ(saddle.stable.points, (std::vector<SkeletonPoint>{{{4, 0, 0}, {1, 2}}}));
  for (const Example* example : {&sample, &saddle}) {
    EXPECT_TRUE(example->stable.segments.empty());
    EXPECT_TRUE(example->stable.intervals.empty());
    EXPECT_FALSE(example->stable.has_vertex);
  }
  EXPECT_TRUE(sample.has({2, 0, 0}));
  EXPECT_FALSE(sample.has({3, 0, 0}));
  EXPECT_TRUE(saddle.has({4, 0, 0}));
  EXPECT_TRUE(saddle.has({3, 0, 0}));
  EXPECT_TRUE(saddle.has({ratio(59, 10), 0, 0}));
  EXPECT_FALSE(saddle.has({2, 0, 0}));
  EXPECT_FALSE(saddle.has({6, 0, 0}));
  EXPECT_FALSE(saddle.has({4, 1, 0}));
}

TEST(OracleStable, HasVolumes) {
  CITES("FC-VOL-01");
  const auto volume_of = [](const Rows& rows, const Names& contact) {
    const Example example(rows, contact);
    return volume(example.set, example.stable);
  };
  const Rows cube = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(volume_of(cube, {0, 1, 2, 3, 4, 5, 6, 7}), 1);
  EXPECT_EQ(volume_of(cube, {0, 1, 2, 3}), 0);
  EXPECT_EQ(volume_of(cube, {0, 1}), 0);
  EXPECT_EQ(volume_of(cube, {0}), 0);
  const Rows octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  EXPECT_EQ(volume_of(octahedron, {0, 1, 2, 3, 4, 5}), ratio(4, 3));
  const Rows half(octahedron.begin(), octahedron.end() - 1);
  EXPECT_EQ(volume_of(half, {0, 1, 2, 3, 4}), ratio(2, 3));  // of kind 2-3
  EXPECT_EQ(volume_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}}, {0, 1, 2, 3, 4}), 4);
  // Of the hull's volume, 140, all flows to two maxima and a point of index 2.
  const Rows with_sector = {{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}};
  Rational sum = 0;
  for (const StationaryPoint& z : stationary_points(with_sector).stationary) {
    const PointSet set(with_sector);
    const Rational part = volume(set, stable_set(set, z));
    EXPECT_EQ(part, z.face_dimension == 3 ? 45 : z.contact == Names({0, 3, 4}) ? 50 : 0);
    sum += part;
  }
  EXPECT_EQ(sum, 140);
}

TEST(OracleStable, HasAWalkOnlyWhereItIsADisc) {
  const Example saddle(Rows{{0, 0, 0}, {2, 0, 0}}, {0, 1});
  EXPECT_THROW(boundary_walk(saddle.set, saddle.z, saddle.stable), std::invalid_argument);
  EXPECT_TRUE(boundary_edges(saddle.stable).empty());
}

// The edge from (0,0) to (-10,0) dangles: it lies inside of the polygon of the other edges, and both of its sides flow
// to the centre of 0, 4 and 5. Other edges from 0 are not critical, because 1 sees 0 2 and 0 3 at an obtuse angle, and
// these see 0 4 and 0 5 so: <(10,0),(-1,30)> < 0 and <(11,-30),(80,30)> < 0.
TEST(OracleStable, AnEdgeWithBothSidesInTheSetIsNoBoundary) {
  CITES("FC-STAB-07", "FC-CHAIN-01");
  const Example t({{0, 0, 0}, {-10, 0, 0}, {-11, 30, 0}, {-11, -30, 0}, {69, 60, 0}, {69, -60, 0}}, {0, 4, 5});
  EXPECT_EQ(std::count_if(t.stable.segments.begin(), t.stable.segments.end(),
                          [](const BackwardSegment& s) { return s.samples == std::array<std::size_t, 2>{0, 1}; }),
            2);
  EXPECT_FALSE(has_tie(t.stable));
  const Edges edges = {{1, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 5}};
  EXPECT_EQ(vectors::stable_field(t.set, t.z, t.stable)["boundary"], Json(edges));
  EXPECT_EQ(boundary_edges(t.stable), edges);
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), (Names{0, 1, 2, 4, 5, 3, 1}));
}

TEST(OracleStable, NamesClasses) {
  CITES("FC-STAB-04", "FC-STAB-07");
  // Repeated rows: the classes are 0, 2, 3 and 5, so names are not places.
  const Example t({{0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {4, 0, 0}, {2, -1.5, 0}}, {0, 2, 3});
  EXPECT_EQ(t.stable.segments[0].samples, (std::array<std::size_t, 2>{0, 2}));
  EXPECT_EQ(t.stable.segments[0].back_contact, (Names{0, 2, 5}));
  EXPECT_EQ(boundary_walk(t.set, t.z, t.stable), (Names{0, 5, 2, 3}));
  EXPECT_EQ(boundary_edges(t.stable), (Edges{{0, 3}, {0, 5}, {2, 3}, {2, 5}}));
  EXPECT_TRUE(t.has({1, 0, 0}));
}

}  // namespace
}  // namespace oracle::oracle_stable_test
