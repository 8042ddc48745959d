// What is told of stable sets beyond the sets themselves: the connecting orbits of sets made by hand, and the
// statistics, which are compared with counts taken one set at a time.
//
// (tests/property/stable_agreement_test.cpp tests that the sets are right.)
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/stable_manifolds.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"

namespace flowcert::stable_sets_test {
namespace {

RationalPoint at(int x) { return {Rational(x), Rational(0), Rational(0)}; }

BackwardSegment<> segment(int front, int back, BackKind kind) {
  BackwardSegment<> made;
  made.front = {at(front)};
  made.back = {at(back)};
  made.back_kind = kind;
  return made;
}

using Orbits = std::vector<std::vector<std::size_t>>;

TEST(ConnectingOrbits, GoFromTheStationaryPointDown) {
  CITES("FC-STAB-06");
  StableSet<> set;
  set.segments = {segment(2, 3, BackKind::kCritical), segment(0, 1, BackKind::kEdge), segment(1, 2, BackKind::kEdge),
                  segment(0, 4, BackKind::kCritical), segment(1, 5, BackKind::kRegular)};
  EXPECT_EQ(connecting_orbits(set, at(0)), (Orbits{{1, 2, 0}, {3}}));
}

// A front at which no segment has its back is reached through an interval.
TEST(ConnectingOrbits, ThoseThroughIntervalsAreLeftOut) {
  CITES("FC-STAB-06");
  StableSet<> set;
  set.segments = {segment(0, 1, BackKind::kEdge), segment(1, 2, BackKind::kCritical), segment(7, 8, BackKind::kEdge),
                  segment(8, 9, BackKind::kCritical), segment(7, 6, BackKind::kCritical)};
  EXPECT_EQ(connecting_orbits(set, at(0)), (Orbits{{0, 1}}));
}

BackwardSegment<> leading(const std::vector<PointId>& front, int front_at, PointId a, PointId b,
                          BackKind kind = BackKind::kCritical, int back_at = 9) {
  BackwardSegment<> made = segment(front_at, back_at, kind);
  made.samples = {std::min(a, b), std::max(a, b)};
  made.front_contact = front;
  return made;
}

using Walk = std::vector<PointId>;

TEST(BoundaryWalk, StartsAtTheLeastSampleTowardsTheLesserNeighbour) {
  CITES("FC-STAB-07", "FC-STAB-10");
  StableSet<> triangle;
  const Walk of_three{0, 1, 2};
  triangle.segments = {leading(of_three, 0, 0, 2), leading(of_three, 0, 0, 1), leading(of_three, 0, 1, 2)};
  EXPECT_EQ(boundary_walk(triangle, {2, 2}, of_three), of_three);
  StableSet<> square;
  const Walk of_four{0, 1, 2, 3};
  square.segments = {leading(of_four, 0, 0, 3), leading(of_four, 0, 0, 2), leading(of_four, 0, 1, 2),
                     leading(of_four, 0, 1, 3)};
  EXPECT_EQ(boundary_walk(square, {2, 2}, of_four), (Walk{0, 2, 1, 3}));
}

// Where a branch crosses a Voronoi edge, the walk goes around the other sides of the edge's polygon.
TEST(BoundaryWalk, GoesAroundWhatABranchCrosses) {
  CITES("FC-STAB-07");
  StableSet<> set;
  const Walk contact{0, 1, 2}, beyond{1, 2, 5, 7};
  set.segments = {leading(contact, 0, 0, 1), leading(contact, 0, 0, 2), leading(contact, 0, 1, 2, BackKind::kEdge, 1),
                  leading(beyond, 1, 1, 7),  leading(beyond, 1, 5, 7),  leading(beyond, 1, 2, 5)};
  EXPECT_EQ(boundary_walk(set, {2, 2}, contact), (Walk{0, 1, 7, 5, 2}));
}

// The side whose midpoint is the stationary point has no segment. The walk may begin with that side, or not.
TEST(BoundaryWalk, OfARegularPoint) {
  CITES("FC-STAB-07");
  const Walk contact{0, 1, 2};
  StableSet<> set;
  set.segments = {leading(contact, 0, 0, 2), leading(contact, 0, 1, 2)};
  EXPECT_EQ(boundary_walk(set, {1, 2}, contact), (Walk{0, 1, 2}));
  set.segments = {leading(contact, 0, 0, 1), leading(contact, 0, 1, 2)};
  EXPECT_EQ(boundary_walk(set, {1, 2}, contact), (Walk{0, 1, 2}));
  set.segments = {leading(contact, 0, 0, 1), leading(contact, 0, 0, 2)};
  EXPECT_EQ(boundary_walk(set, {1, 2}, contact), (Walk{0, 1, 2}));
}

TEST(BoundaryWalk, OfWhatHasNone) {
  CITES("FC-STAB-07");
  const Walk contact{0, 1, 2};
  StableSet<> set;
  set.segments = {leading(contact, 0, 0, 1), leading(contact, 0, 0, 2), leading(contact, 0, 1, 2, BackKind::kVertex)};
  EXPECT_EQ(boundary_walk(set, {2, 2}, contact), std::nullopt);
  EXPECT_EQ(boundary_walk(set, {2, 3}, contact), std::nullopt);
}

// The counts of the sets of index 2, which come first.
struct Counts {
  Distribution orbits, triangles;
  std::size_t triangle_count = 0, with_vertex = 0, with_interval = 0;
  std::optional<std::size_t> largest;
};

Counts count_sets(const PointSet& points, const StableManifolds& stable, const StationaryPoints& stationary) {
  Counts counts;
  for (std::size_t i = 0; i < stable.size() && stationary.index(stable.record(i)).is_critical(); ++i) {
    const RationalPoint center = exact_sphere(points, stationary.contact(stable.record(i))).center;
    for (const auto& orbit : connecting_orbits(stable.set(i), center)) counts.orbits.add(orbit.size());
    counts.with_vertex += stable.has_vertex(i) ? 1 : 0;
    counts.with_interval += stable.has_interval(i) ? 1 : 0;
    if (stable.has_interval(i)) continue;
    const std::size_t triangles = 2 * stable.segment_count(i);
    if (!counts.largest || triangles > counts.triangles.max()) counts.largest = i;
    counts.triangles.add(triangles);
    counts.triangle_count += triangles;
  }
  return counts;
}

TEST(StableStatistics, AreTheSumsOverTheSets) {
  CITES("FC-STAB-06", "FC-STAT-01");
  std::size_t with_interval = 0, with_vertex = 0, ties_for_largest = 0;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const PointSet points = property::point_set_of(fuzz::draw(family, seed, static_cast<int>(20 + 4 * seed)));
      const FlowComplex complex(points);
      const StationaryPoints& stationary = complex.stationary();
      const StableManifolds& stable = complex.stable();
      const Counts expected = count_sets(points, stable, stationary);
      const StableStatistics& told = stable.statistics();
      EXPECT_EQ(told.n_s2.count(), expected.orbits.count());
      EXPECT_EQ(told.n_s2.max(), expected.orbits.max());
      EXPECT_EQ(told.n_s2.mean(), expected.orbits.mean());
      EXPECT_EQ(told.triangle_count, expected.triangle_count);
      EXPECT_EQ(told.triangles.count(), expected.triangles.count());
      EXPECT_EQ(told.triangles.max(), expected.triangles.max());
      EXPECT_EQ(told.triangles.mean(), expected.triangles.mean());
      EXPECT_EQ(told.with_vertex, expected.with_vertex);
      EXPECT_EQ(told.with_interval, expected.with_interval);
      EXPECT_EQ(told.largest, expected.largest);
      with_interval += expected.with_interval;
      with_vertex += expected.with_vertex;
      ties_for_largest +=
          expected.largest && expected.triangles.median() == static_cast<double>(expected.triangles.max()) ? 1 : 0;
    }
  }
  // Otherwise nothing of this was tested.
  EXPECT_GT(with_interval, 5u);
  EXPECT_GT(with_vertex, 10u);
  EXPECT_GT(ties_for_largest, 10u);
}

}  // namespace
}  // namespace flowcert::stable_sets_test
