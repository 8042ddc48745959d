// The cascade kernel in use: the directions that real flows ask of it, which rung decides, what a higher rung hands
// down, and recipes of thousands of crossings.
//
// Guarantees: along orbits of U2, orbits from anywhere and backward walks, over inputs of every family, each direction
// that doubles or the longer precision know is compared with the integer one, in rationals, and so is each sign. The
// test fails too where a kind of start or of crossing was not met. (direction_bounds_test.cpp tests the bounds
// themselves.)
#include "flow/kernels/cascade_kernel.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "flow/flow_operator.h"
#include "flow/kernel_flow_operator.h"
#include "flow/kernels/cascade_moving_point.h"
#include "flow/kernels/exact_kernel.h"
#include "flowcert/flow_complex.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"
#include "morse/backward_walk.h"
#include "morse/record_finder.h"
#include "tests/cites.h"
#include "tests/unit/exact_directions.h"
#include "tests/unit/portable_random.h"
#include "tests/unit/watched_kernel.h"

namespace flowcert::flow::cascade_kernel_test {
namespace {

using flowcert_tests::broken_bound;
using flowcert_tests::PortableRandom;
using flowcert_tests::Seen;
using flowcert_tests::seen_now;
using flowcert_tests::WatchedKernel;
using property::rows_of;

// Flows over one input, by the kernel that watches.
class WatchedFlows {
 public:
  explicit WatchedFlows(const std::vector<Point>& rows)
      : points_(rows), complex_(points_), faces_(complex_.diagram()), flow_(faces_, FacetSearch::kBinary) {}

  // Both orbits of each critical point of index 2.
  void flow_from_saddles() {
    for_each_saddle([&](PolygonRef polygon) {
      for (const std::size_t side : {0U, 1U}) follow(flow_.end_of_edge(polygon, side));
    });
  }
  void flow_from(const RationalPoint& x) {
    Location at{faces_.locate(x), kNoPoint};
    if (at.place.kind != Place::Kind::kVertex) at.point = flow_.add(x);
    follow(at);
  }
  // Against the flow, over the facets that lead to each critical point of index 2, as far as Voronoi vertices or some
  // hundred steps.
  void walk_back() {
    const morse::GabrielEdges gabriel(faces_.diagram(), complex_.stationary());
    morse::BackwardWalk walk(faces_, flow_, gabriel);
    for_each_saddle([&](PolygonRef polygon) {
      std::vector<morse::FrontNumber> fronts = {walk.at_center(faces_.diagram().corners(polygon), polygon)};
      for (std::size_t k = 0; k < fronts.size() && k < 100; ++k) {
        const Place place = walk.place(fronts[k]);
        if (place.kind != Place::Kind::kEdge) continue;
        for (const PolygonSide& side : faces_.diagram().sides(place.edge)) {
          if (side.angle != Sign::kPositive) continue;
          const auto back = walk.step(fronts[k], {side.v0, side.v1});
          if (!back.critical) fronts.push_back(back.front);
        }
      }
      walk.clear();
    });
  }

 private:
  void for_each_saddle(const std::function<void(PolygonRef)>& visit) {
    const StationaryPoints& stationary = complex_.stationary();
    for (std::size_t record = 0; record < stationary.size(); ++record) {
      if (stationary.index(record) != StationaryIndex{2, 2}) continue;
      std::vector<VertexIndex> contact;
      for (const PointId name : stationary.contact(record)) contact.push_back(faces_.diagram().named(name));
      visit(faces_.place_of(contact.front(), std::span(contact).subspan(1)).edge);
    }
  }
  void follow(Location at) {
    while (at.place.kind != Place::Kind::kInfinity) {
      const FlowStep step = flow_.step(at);
      if (step.stationary) break;
      at = step.end;
    }
    flow_.drop_from(0);
  }

  PointSet points_;
  FlowComplex complex_;
  VoronoiFaces faces_;
  KernelFlowOperator<WatchedKernel> flow_;
};

void watch_all_flows(const std::vector<Point>& rows) {
  if (rows.empty()) return;
  WatchedFlows flows(rows);
  flows.flow_from_saddles();
  flows.walk_back();
  for (std::size_t k = 0; k + 1 < rows.size() && k < 2; ++k) {
    const RationalPoint x{(2 * Rational(rows[k].x) + Rational(rows[k + 1].x)) / 3,
                          (3 * Rational(rows[k].y) + 4 * Rational(rows[k + 1].y)) / 7,
                          (Rational(rows[k].z) + Rational(rows[k + 1].z)) / 2};
    flows.flow_from(x);
  }
}

// Points of one circle, which make a polygon of the Delaunay triangulation, turned by an integer quaternion.
class Circle {
 public:
  // In cyclic order; `low` to `high` are places among all sixteen.
  Circle(std::size_t low, std::size_t high, PortableRandom& random) : random_(random) {
    constexpr std::array<std::array<int, 2>, 16> kAll = {{{63, 16},
                                                          {60, 25},
                                                          {56, 33},
                                                          {52, 39},
                                                          {39, 52},
                                                          {33, 56},
                                                          {25, 60},
                                                          {16, 63},
                                                          {-16, 63},
                                                          {-25, 60},
                                                          {-33, 56},
                                                          {-39, 52},
                                                          {-60, -25},
                                                          {-33, -56},
                                                          {16, -63},
                                                          {56, -33}}};
    for (std::size_t k = low; k <= high; ++k) {
      if (random.below(3) != 0) on_circle_.push_back({double(kAll[k][0]), double(kAll[k][1]), 0});
    }
  }
  [[nodiscard]] std::size_t size() const { return on_circle_.size(); }
  [[nodiscard]] const std::vector<Point>& rows() const { return rows_; }

  // Points above and below, outside of the circle's ball.
  void add_caps() {
    for (const Point& p : on_circle_) rows_.push_back(turned(p));
    for (const int side : {-1, 1}) {
      for (int k = 0; k < 2; ++k)
        add(random_.between(-20, 20), random_.between(-20, 20), side * random_.between(70, 90));
    }
  }
  // Two points just outside of each side.
  void add_neighbors_of_sides() {
    for (std::size_t k = 0; k < size(); ++k) {
      const Point m = middle(k);
      if (std::hypot(m.x, m.y) < 1) continue;
      const double factor = 65.0 * (1.01 + 0.02 * random_.coordinate()) / std::hypot(m.x, m.y);
      for (const double z : {5.0, -5.0})
        add(std::round(64 * factor * m.x) / 64, factor * m.y, z + random_.coordinate());
    }
  }
  // A position on the facet of side k, between the side and the circle's centre, or a little above or below.
  [[nodiscard]] RationalPoint inside(std::size_t k) {
    const Point m = middle(k);
    const double share = std::ldexp(1.0, -random_.between(0, 4));
    return exact(turned({share * m.x, share * m.y, 0.125 * random_.between(-8, 8)}));
  }

 private:
  static RationalPoint exact(const Point& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
  void add(double x, double y, double z) { rows_.push_back(turned({x, y, z})); }
  [[nodiscard]] Point middle(std::size_t k) const {
    const Point &p = on_circle_[k], &q = on_circle_[(k + 1) % size()];
    return {(p.x + q.x) / 2, (p.y + q.y) / 2, 0};
  }
  // By the quaternion (7,3,5,2), whose square is 87.
  static Point turned(const Point& p) {
    return {29 * p.x + 2 * p.y + 82 * p.z, 58 * p.x + 61 * p.y - 22 * p.z, -58 * p.x + 62 * p.y + 19 * p.z};
  }

  PortableRandom& random_;
  std::vector<Point> on_circle_, rows_;
};

// Flows through polygons of many sides: those with their centre outside, and against the flow those with it inside.
void watch_flows_through_polygons() {
  PortableRandom random(17);
  for (int k = 0; k < 60; ++k) {
    Circle circle(0, k % 2 == 0 ? 7 : 15, random);
    if (circle.size() < 4) continue;
    circle.add_caps();
    if (k % 2 != 0) circle.add_neighbors_of_sides();
    WatchedFlows flows(circle.rows());
    flows.flow_from_saddles();
    flows.walk_back();
    for (std::size_t side = 0; side < circle.size(); ++side) flows.flow_from(circle.inside(side));
  }
}

void print(const Seen& seen) {
  for (const auto& [branch, counts] : seen.directions) {
    std::printf("%-26s %6zu in doubles, %6zu in the longer precision, %5zu unknown, %5zu handed down\n", branch.c_str(),
                counts.doubles, counts.extended, counts.unknown, counts.handed_down);
  }
  std::printf("of %zu signs doubles alone decide %zu, the longer precision %zu\n", seen.signs, seen.by_doubles,
              seen.by_extended);
}

TEST(CascadeKernel, DirectionsOfRealFlowsAreWithinTheirBounds) {
  CITES("FC-NUM-01", "FC-FLOW-02", "FC-FLOW-07", "FC-STAB-04");
  Seen seen;
  seen_now = &seen;
  for (const fuzz::Family& family : fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 2 && seen.failures == 0; ++seed) {
      for (const int size : {30, 100}) watch_all_flows(rows_of(fuzz::draw(family, seed, size)));
    }
  }
  watch_all_flows(rows_of(fuzz::long_cascade(40, 2)));
  watch_all_flows(rows_of(fuzz::half_shell(60, 3)));
  watch_all_flows(rows_of(fuzz::high_degree_facet(24, false, 1)));
  watch_all_flows(rows_of(fuzz::high_degree_facet(24, true, 1)));
  watch_flows_through_polygons();
  print(seen);
  EXPECT_EQ(seen.directions.size(), 7U);
  for (const auto& [branch, counts] : seen.directions) {
    EXPECT_GT(counts.doubles, 10U) << branch;
    EXPECT_GT(counts.extended, 10U) << branch;
  }
  EXPECT_GT(seen.by_doubles, seen.signs / 3);
}

// Where the powers of doubles are no doubles, the longer precision is as good as ever.
TEST(CascadeKernel, DirectionsOfFlowsAtTheEndsOfTheRangeAreWithinTheirBounds) {
  CITES("FC-NUM-01", "FC-FLOW-02");
  for (const double scale : {0x1p500, 0x1p-500, std::numeric_limits<double>::denorm_min()}) {
    Seen seen;
    seen_now = &seen;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      PortableRandom random(seed);
      std::vector<Point> rows;
      for (int k = 0; k < 12; ++k) {
        const auto part = [&] { return scale * static_cast<double>(random.between(-1'000'000, 1'000'000)); };
        rows.push_back({part(), part(), part()});
      }
      watch_all_flows(rows);
    }
    print(seen);
    for (const auto& [branch, counts] : seen.directions) {
      EXPECT_EQ(counts.unknown > 0, branch != "position") << branch;
      EXPECT_EQ(counts.handed_down, counts.unknown) << branch;
    }
    EXPECT_GT(seen.directions["triangle"].extended, 0U);
    EXPECT_EQ(seen.by_doubles, 0U);
    EXPECT_GT(seen.by_extended, seen.signs / 2);
  }
}

// ---- Which rung decides ----

// The ends of the edge lie at (+-1,0,0), and the two others make a Voronoi vertex (0,0,4/3): seen from the edge's
// midpoint it lies along the z axis.
struct UpwardDirection {
  explicit UpwardDirection(double scale = 1, MiddleRungs rungs = {}) : kernel(tally, rungs) {
    for (Point& p : v) p = {scale * p.x, scale * p.y, scale * p.z};
    number = kernel.add_circumcenter(std::array<const Point*, 4>{&v[0], &v[1], &v[2], &v[3]}, Stay::kPassing);
  }
  // For a sign of <(0,0,1), q>.
  [[nodiscard]] RayAtInfinity query(const Point& q) const { return {number, v[0], v[1], q}; }
  [[nodiscard]] const FilterCount& count() { return tally[FlowPrimitive::kRayAtInfinity]; }

  std::array<Point, 4> v = {Point{-1, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 3}};
  KernelTally tally;
  CascadeKernel kernel;
  PointNumber number = 0;
};

TEST(CascadeKernel, DoublesDecideWhatIsGeneric) {
  CITES("FC-NUM-01");
  UpwardDirection up;
  EXPECT_EQ(up.kernel.sign(up.query({0.3, 5, 1e-9})), Sign::kPositive);
  EXPECT_EQ(up.kernel.sign(up.query({0.3, 5, -1e-9})), Sign::kNegative);
  EXPECT_EQ(up.kernel.sign(OrderOfExits{up.number, up.v[0], up.v[1], Point{0, 7, 2}, Point{0, -8, 3}}),
            Sign::kNegative);
  EXPECT_EQ(up.count().calls, 2U);
  EXPECT_EQ(up.count().failures, 0U);
  EXPECT_EQ(up.tally[FlowPrimitive::kSideOfRay].calls, 1U);
  EXPECT_EQ(up.tally[FlowPrimitive::kSideOfRay].failures, 0U);
  EXPECT_EQ(up.kernel.exact_bytes(up.number), std::nullopt);
}

TEST(CascadeKernel, LongerPrecisionsDecideNearTies) {
  CITES("FC-NUM-01");
  for (const double little : {0x1p-53, 0x1p-60, 0x1p-100, 0x1p-200}) {
    for (const double sign : {-1.0, 1.0}) {
      UpwardDirection up(1, {true, true, 1});
      const Point q{0, 5, sign * little};
      const Sign truth = sign > 0 ? Sign::kPositive : Sign::kNegative;
      EXPECT_EQ(up.kernel.sign_on_rung(up.query(q), KernelRung::kFilter), std::nullopt);
      const MaybeSign doubled = up.kernel.sign_on_rung(up.query(q), KernelRung::kDoubled);
      EXPECT_EQ(doubled.has_value(), little > 0x1p-90);
      EXPECT_EQ(doubled.value_or(truth), truth);
      EXPECT_EQ(up.kernel.sign_on_rung(up.query(q), KernelRung::kExtended), truth);
      EXPECT_EQ(up.kernel.sign(up.query(q)), truth);
      EXPECT_EQ(up.count().failures, 1U);
      EXPECT_EQ(up.kernel.exact_bytes(up.number), std::nullopt) << "no integer was needed";
    }
  }
}

TEST(CascadeKernel, RungsThatAreLeftOutChangeNoSign) {
  CITES("FC-NUM-01");
  using enum KernelRung;
  struct Choice {
    MiddleRungs rungs;
    KernelRung near, nearer;  // what decides two signs, one of them nearer to a tie
  };
  for (const Choice& choice : {Choice{{true, true, 1}, kDoubled, kExtended},
                               {{true, true, 2}, kDoubled, kExact},
                               {{true, false, 1}, kDoubled, kExact},
                               {{false, true, 1}, kExtended, kExtended},
                               {{false, false, 1}, kExact, kExact}}) {
    for (const bool is_nearer : {false, true}) {
      UpwardDirection up(1, choice.rungs);
      EXPECT_EQ(up.kernel.sign(up.query({0.3, 5, -1})), Sign::kNegative);
      EXPECT_EQ(up.kernel.sign(up.query({0, 5, is_nearer ? -0x1p-200 : -0x1p-60})), Sign::kNegative);
      for (const KernelRung rung : {kDoubled, kExtended, kExact}) {
        EXPECT_EQ(up.kernel.decided_beyond_doubles(rung), rung == (is_nearer ? choice.nearer : choice.near) ? 1U : 0U);
      }
      EXPECT_EQ(up.count().failures, 1U);
    }
  }
}

TEST(CascadeKernel, IntegersDecideTiesAndWhatIsNearerThanThat) {
  CITES("FC-NUM-01");
  for (const double beside : {0.0, 0x1p-300, -0x1p-300, std::numeric_limits<double>::denorm_min()}) {
    UpwardDirection up;
    const Point q{0, 5, beside};
    EXPECT_EQ(up.kernel.sign_on_rung(up.query(q), KernelRung::kFilter), std::nullopt);
    EXPECT_EQ(up.kernel.sign_on_rung(up.query(q), KernelRung::kDoubled), std::nullopt);
    EXPECT_EQ(up.kernel.sign_on_rung(up.query(q), KernelRung::kExtended), std::nullopt);
    EXPECT_EQ(up.kernel.exact_bytes(up.number), std::nullopt);
    EXPECT_EQ(up.kernel.sign(up.query(q)), geometry::sign_of(beside));
    EXPECT_TRUE(up.kernel.exact_bytes(up.number).has_value());
    EXPECT_EQ(up.count().calls, 1U);
    EXPECT_EQ(up.count().failures, 1U);
  }
}

TEST(CascadeKernel, TheLongerPrecisionDecidesOutOfRange) {
  CITES("FC-NUM-01");
  for (const double scale : {0x1p500, 0x1p-500, 0x1p1000, 0x1p-1060}) {
    UpwardDirection up(scale, {true, true, 1});
    const Point q{0, 5 * scale, 2 * scale};
    EXPECT_EQ(up.kernel.sign_on_rung(up.query(q), KernelRung::kFilter), std::nullopt);
    EXPECT_EQ(up.kernel.sign(up.query(q)), Sign::kPositive);
    EXPECT_EQ(up.count().failures, 1U);
    const PointNumber beyond = up.kernel.add_crossing(up.number, up.v[0], up.v[1], q);
    EXPECT_EQ(up.tally[FlowPrimitive::kCrossing].calls, 1U);
    EXPECT_EQ(up.kernel.exact_bytes(up.number), std::nullopt) << "no integer was needed";
    // Half way up to the bisector of (1,0,0) and (0,5,2): (0,0,s) with 4 s = 28.
    EXPECT_EQ(up.kernel.exact(beyond), (RationalPoint{0, 0, 7 * Rational(scale)}));
  }
  // The direction is handed down to the doubles, but no crossing is in their range.
  UpwardDirection far(0x1p500);
  const Point q{0, 5 * 0x1p500, 2 * 0x1p500}, r{0, 9 * 0x1p500, 9 * 0x1p500};
  (void)far.kernel.sign(far.query(q));
  const PointNumber beyond = far.kernel.add_crossing(far.number, far.v[0], far.v[1], q);
  EXPECT_EQ(far.tally[FlowPrimitive::kCrossing].failures, 0U) << "the direction before it is known";
  EXPECT_FALSE(far.kernel.direction_in_doubles(beyond, {&far.v[1], &q}).is_known());
  EXPECT_EQ(far.kernel.sign(RayAtInfinity{beyond, far.v[1], q, r}),
            *far.kernel.sign_on_rung(RayAtInfinity{beyond, far.v[1], q, r}, KernelRung::kExact));
}

// ---- Recipes ----

// The recipe of the flow along a cascade: facet k belongs to the teeth k and k+1, and is left through the bisector of
// tooth k+2.
struct Cascade {
  explicit Cascade(std::size_t points) {
    const std::vector<Point> rows = rows_of(fuzz::long_cascade(points, 1));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k != 2 && k != 3) teeth.push_back(rows[k]);
    }
    const Point &p = teeth[0], &q = teeth[1];
    start = {(Rational(p.x) + Rational(q.x)) / 2 + 1, (Rational(p.y) + Rational(q.y)) / 2,
             (Rational(p.z) + Rational(q.z)) / 2};
  }
  [[nodiscard]] FacetEdge facet(std::size_t k) const { return {&teeth[k], &teeth[k + 1]}; }
  [[nodiscard]] std::size_t crossings() const { return teeth.size() - 2; }

  // Point k looks at facet k.
  template <class Kernel>
  std::vector<PointNumber> points(Kernel& kernel, const auto& after_each) const {
    std::vector<PointNumber> numbers = {kernel.add(start)};
    for (std::size_t k = 0; k < crossings(); ++k) {
      numbers.push_back(kernel.add_crossing(numbers.back(), teeth[k], teeth[k + 1], teeth[k + 2]));
      after_each(numbers.back(), facet(k + 1));
    }
    return numbers;
  }

  std::vector<Point> teeth;
  RationalPoint start;
};

const auto kNothing = [](PointNumber, FacetEdge) {};

void expect_same_ray(const IntegerDirection& u, const IntegerDirection& v) {
  const IntegerDirection turn = cross(u, v);
  EXPECT_TRUE(turn.x == 0 && turn.y == 0 && turn.z == 0);
  EXPECT_GT(dot(u, v), 0);
}

constexpr double kRoundoff = Precision<double>::kRoundoff;

TEST(CascadeKernel, WhatAHigherRungComputedIsHandedDown) {
  CITES("FC-NUM-01");
  const Cascade cascade(60);
  KernelTally tally;
  CascadeKernel kernel(tally);
  const std::vector<PointNumber> x = cascade.points(kernel, kNothing);
  const std::size_t last = cascade.crossings();
  const auto error = [&](std::size_t k) { return kernel.direction_in_doubles(x[k], cascade.facet(k)).error; };
  const double before = error(last);
  EXPECT_GT(before, 40 * kRoundoff);
  EXPECT_GT(before, error(1)) << "it grows";
  // By the longer precision.
  const Direction<Extended> extended = kernel.direction_in<Extended>(x[last], cascade.facet(last));
  EXPECT_TRUE(extended.is_known());
  EXPECT_LT(extended.error, Extended(0x1p-200));
  EXPECT_GE(error(last), 2 * kRoundoff);
  EXPECT_LE(error(last), 9 * kRoundoff);
  EXPECT_EQ(kernel.exact_bytes(x[last]), std::nullopt);
  // By integers, to both.
  (void)kernel.direction_in_integers(x[last - 1], cascade.facet(last - 1));
  EXPECT_LE(error(last - 1), 17 * kRoundoff);
  const Direction<Extended> rounded = kernel.direction_in<Extended>(x[last - 1], cascade.facet(last - 1));
  EXPECT_TRUE(rounded.is_known());
  EXPECT_LE(rounded.error, Extended(8 * Precision<Extended>::kRoundoff));
  // What follows begins anew.
  const PointNumber again =
      kernel.add_crossing(x[last - 1], cascade.teeth[last - 1], cascade.teeth[last], cascade.teeth[last + 1]);
  EXPECT_LT(kernel.direction_in_doubles(again, cascade.facet(last)).error, before);
  EXPECT_EQ(broken_bound(kernel.direction_in_doubles(again, cascade.facet(last)),
                         kernel.direction_in_integers(x[last], cascade.facet(last)), cascade.facet(last)),
            "");
}

// A sample is seen at nearly a right angle to the direction: too near for doubles, but not for what a longer precision
// hands down to them.
TEST(CascadeKernel, TheMovingPointTakesTheDirectionThatIsHandedDown) {
  CITES("FC-NUM-01");
  const Cascade cascade(60);
  const FacetEdge facet = cascade.facet(cascade.crossings());
  std::size_t decided_by_doubles_then = 0;
  for (int bits = 40; bits < 56; ++bits) {
    KernelTally tally;
    CascadeKernel kernel(tally);
    const PointNumber last = cascade.points(kernel, kNothing).back();
    const Vector3<double> u = kernel.direction_in_doubles(last, facet).u;
    const Vector3<double> edge = difference<double>(*facet.p0, *facet.p1), across = cross(edge, u);
    const double along = std::ldexp(length(edge), -bits);
    const Point q{facet.p0->x + across.x + along * u.x, facet.p0->y + across.y + along * u.y,
                  facet.p0->z + across.z + along * u.z};
    CascadeKernel::MovingPoint moving(kernel, last, *facet.p0, *facet.p1);
    const Sign sign = moving.sign_of_ray_at_infinity(q);
    const std::uint64_t failures = tally[FlowPrimitive::kRayAtInfinity].failures;
    EXPECT_EQ(moving.sign_of_ray_at_infinity(q), sign);
    if (failures == 1 && tally[FlowPrimitive::kRayAtInfinity].failures == 1) ++decided_by_doubles_then;
  }
  EXPECT_GT(decided_by_doubles_then, 0U);
}

TEST(CascadeKernel, PositionsOfRecipesAreExact) {
  CITES("FC-NUM-01", "FC-FLOW-02");
  for (const std::size_t points : {10U, 100U}) {
    const Cascade cascade(points);
    KernelTally tally;
    CascadeKernel kernel(tally);
    ExactKernel slow(tally);
    const PointNumber last = cascade.points(kernel, kNothing).back();
    EXPECT_EQ(kernel.deepest(), cascade.crossings());
    EXPECT_EQ(kernel.exact(last), slow.exact(cascade.points(slow, kNothing).back()));
  }
}

// Follows one flow by two kernels. They end alike, and so does the last point that was constructed.
void expect_the_lazy_flow(std::size_t count) {
  const std::vector<Point> rows = rows_of(fuzz::long_cascade(count, 1));
  const PointSet points(rows);
  const VoronoiDiagram diagram{Delaunay(points)};
  VoronoiFaces faces(diagram);
  const RationalPoint start = Cascade(count).start;
  std::vector<RationalPoint> last;
  std::vector<Place> ends;
  for (const ConstructionKernel kernel : {ConstructionKernel::kCascade, ConstructionKernel::kLazy}) {
    const auto flow = make_flow_operator(faces, {kernel, FacetSearch::kBinary});
    Location at{faces.locate(start), flow->add(start)};
    Location constructed = at;
    for (;;) {
      const FlowStep step = flow->step(at);
      if (step.stationary || step.end.place.kind == Place::Kind::kInfinity) break;
      at = step.end;
      if (at.point != kNoPoint) constructed = at;
    }
    Distribution bytes;
    std::size_t depth = 0;
    flow->count_sizes(bytes, depth);
    EXPECT_GE(depth, kernel == ConstructionKernel::kCascade ? count - 4 : 0);
    last.push_back(flow->exact(constructed));
    ends.push_back(at.place);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(last[0], last[1]);
}

TEST(CascadeKernel, LongCascadesEndWhereTheLazyKernelSays) {
  CITES("FC-NUM-01", "FC-FLOW-05");
  for (const std::size_t count : {10U, 100U, 1000U}) expect_the_lazy_flow(count);
}

TEST(CascadeKernel, FewLongIntegersAreKept) {
  CITES("FC-NUM-01");
  const Cascade cascade(1000);
  KernelTally tally;
  CascadeKernel kernel(tally);
  std::size_t most = 0;
  const auto with_integers = [&] {
    std::size_t count = 0;
    for (PointNumber k = 0; k < kernel.kept(); ++k) count += kernel.exact_bytes(k) ? 1 : 0;
    most = std::max(most, count);
    return count;
  };
  IntegerDirection latest;
  const std::vector<PointNumber> x = cascade.points(kernel, [&](PointNumber number, FacetEdge facet) {
    latest = kernel.direction_in_integers(number, facet);
    if (number % 50 == 0) (void)with_integers();
  });
  EXPECT_EQ(most, 16U);
  EXPECT_TRUE(kernel.exact_bytes(x.back()).has_value());
  EXPECT_EQ(kernel.exact_bytes(x[x.size() - 17]), std::nullopt);
  // A direction that was dropped is computed again.
  const std::size_t middle = x.size() / 2;
  KernelTally other_tally;
  CascadeKernel other(other_tally);
  const std::vector<PointNumber> y = cascade.points(other, kNothing);
  expect_same_ray(kernel.direction_in_integers(x[middle], cascade.facet(middle)),
                  other.direction_in_integers(y[middle], cascade.facet(middle)));
  expect_same_ray(latest, other.direction_in_integers(y.back(), cascade.facet(cascade.crossings())));
  // Numbers that are used again.
  for (int round = 0; round < 3; ++round) {
    kernel.drop_from(5);
    PointNumber at = 4;
    for (std::size_t k = 4; k < 40; ++k) {
      at = kernel.add_crossing(at, cascade.teeth[k], cascade.teeth[k + 1], cascade.teeth[k + 2]);
      expect_same_ray(kernel.direction_in_integers(at, cascade.facet(k + 1)),
                      other.direction_in_integers(y[k + 1], cascade.facet(k + 1)));
    }
    EXPECT_LE(with_integers(), 16U);
  }
}

// In a thread with a small stack, a recursion over 2,000 crossings would not end well.
TEST(CascadeKernel, LongRecipesTakeNoStack) {
  CITES("FC-NUM-01", "FC-FLOW-05");
  struct Work {
    Cascade cascade{2000};
    std::size_t depth = 0;
    bool is_known = false;
    Sign sign = Sign::kZero;

    static void* run(void* self) {
      Work& work = *static_cast<Work*>(self);
      const std::size_t last = work.cascade.crossings();
      KernelTally tally;
      CascadeKernel kernel(tally);
      const PointNumber x = work.cascade.points(kernel, kNothing).back();
      work.depth = kernel.deepest();
      work.is_known = kernel.direction_in<Extended>(x, work.cascade.facet(last)).is_known();
      const IntegerDirection u = kernel.direction_in_integers(x, work.cascade.facet(last));
      work.sign = geometry::sign_of(u.x);
      return nullptr;
    }
  };
  const auto work = std::make_unique<Work>();
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{512} * 1024), 0);
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, &Work::run, work.get()), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
  EXPECT_EQ(work->depth, 1996U);
  EXPECT_TRUE(work->is_known);
  EXPECT_EQ(work->sign, Sign::kPositive) << "the flow goes along the x axis";
}

}  // namespace
}  // namespace flowcert::flow::cascade_kernel_test
