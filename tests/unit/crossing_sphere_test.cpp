// Positions of crossings in doubles, against those of exact numbers.
//
// Guarantees: along random chains of crossings the bounds of both precisions hold the exact position and squared
// distance, and are at least what src/flow/cascades.md derives. The doubles are the nearest ones. Each rung is met on
// inputs that were made for it.
#include "flow/kernels/crossing_sphere.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "flow/kernels/cascade_kernel.h"
#include "geometry/rational_point.h"
#include "tests/cites.h"
#include "tests/unit/exact_directions.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::flow::crossing_sphere_test {
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::exact_number;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

struct Met {
  std::size_t crossings = 0;
  std::size_t known_doubled = 0, known_extended = 0;  // with finite bounds
  std::size_t by_doubled = 0, by_extended = 0, by_integers = 0;
};

void expect_within(const BoundedNumber& number, const Rational& exact) {
  if (!std::isfinite(number.error)) return;
  EXPECT_LE(abs(exact_number(number.value) - exact), Rational(number.error));
}

// |h|/|A| (t + 12 u) (1 + |g|/|A|), from the length of the direction and of what leaves its plane alone.
template <class Number>
Number derived_error(const Direction<Number>& x, FacetEdge facet, const Point& q) {
  using std::abs;
  const Bisector<Number> seen = bisector<Number>(facet, q);
  const Number approach = abs(dot(x.u, seen.g)), turn = x.error + Number(12 * Precision<Number>::kRoundoff);
  return abs(seen.h) / approach * turn * (Number(1) + length(seen.g) / approach);
}

// Returns whether the bounds are finite.
template <class Number>
bool check_bounds(const Direction<Number>& x, FacetEdge facet, const Point& q, const ExactSphere& truth) {
  const BoundedSphere sphere = sphere_at_crossing(x, facet, q);
  if (!std::isfinite(sphere.center[0].error)) return false;
  const Number derived = derived_error(x, facet, q);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expect_within(sphere.center[axis], truth.center[axis]);
    EXPECT_GE(sphere.center[axis].error, static_cast<double>(derived));
  }
  using std::abs;
  const Bisector<Number> seen = bisector<Number>(facet, q);
  const Number from_middle = abs(Number(seen.h / dot(x.u, seen.g))) * length(x.u);
  expect_within(sphere.squared_radius, truth.squared_radius);
  EXPECT_GE(sphere.squared_radius.error, static_cast<double>(Number(derived * Number(2) * from_middle)));
  return true;
}

class Chain {
 public:
  Chain(std::vector<Point> points, PortableRandom& random, Met& met)
      : points_(std::move(points)), random_(random), met_(met) {}

  // From the centre of a sphere, or from the point given.
  bool start() {
    facet_ = {&any(), &any()};
    if (*facet_.p0 == *facet_.p1) return false;
    std::array<const Point*, 4> v = {facet_.p0, facet_.p1, &any(), &any()};
    const auto in = [](const Point& p) { return flowcert_tests::exact_vector(p); };
    const Rational volume = dot(in(*v[1]) - in(*v[0]), cross(in(*v[2]) - in(*v[0]), in(*v[3]) - in(*v[0])));
    if (volume == 0) return false;
    if (volume < 0) std::swap(v[2], v[3]);
    at_ = kernel_.add_circumcenter(v, Stay::kPassing);
    (void)exact_.add_circumcenter(v, Stay::kPassing);
    return true;
  }
  void cross_a_facet() {
    const Point& q = any();
    if (q == *facet_.p0 || q == *facet_.p1) return;
    const IntegerDirection u = exact_.direction_in_integers(at_, facet_);
    const ExactBisector seen(facet_, q);
    const BigInteger approach = dot(u, seen.g);
    if (approach == 0 || seen.h == 0 || (approach > 0) != (seen.h > 0)) return;
    const PointNumber next = kernel_.add_crossing(at_, *facet_.p0, *facet_.p1, q);
    ASSERT_EQ(next, exact_.add_crossing(at_, *facet_.p0, *facet_.p1, q));
    check(next, q);
    // The point must not be the midpoint of the next facet's edge.
    const FacetEdge to = random_.coin() ? FacetEdge{facet_.p0, &q} : FacetEdge{&q, facet_.p1};
    const IntegerDirection beyond = exact_.direction_in_integers(next, to);
    if (beyond.x == 0 && beyond.y == 0 && beyond.z == 0) return;
    at_ = next;
    facet_ = to;
  }

 private:
  const Point& any() { return points_[random_.below(points_.size())]; }

  void check(PointNumber next, const Point& q) {
    const RationalPoint x = exact_.exact(next);
    const ExactSphere exact{x, geometry::squared_distance(x, *facet_.p0)};
    EXPECT_EQ(exact.squared_radius, geometry::squared_distance(x, q));
    ++met_.crossings;
    if (check_bounds(kernel_.direction_in<DoubleDouble>(at_, facet_), facet_, q, exact)) ++met_.known_doubled;
    if (check_bounds(kernel_.direction_in<Extended>(at_, facet_), facet_, q, exact)) ++met_.known_extended;
    const RoundedSphere truth = rounded_sphere(exact);
    bool is_decided = false;
    for (const KernelRung rung : {KernelRung::kDoubled, KernelRung::kExtended}) {
      const auto decided = kernel_.rounded_on_rung(next, rung);
      if (!decided) continue;
      EXPECT_EQ(decided->center, truth.center);
      EXPECT_EQ(decided->squared_radius, truth.squared_radius);
      if (!is_decided) ++(rung == KernelRung::kDoubled ? met_.by_doubled : met_.by_extended);
      is_decided = true;
    }
    if (!is_decided) ++met_.by_integers;
    EXPECT_EQ(kernel_.rounded(next).has_value(), is_decided);
  }

  std::vector<Point> points_;
  PortableRandom& random_;
  Met& met_;
  // The integers of the second one would make the directions of the first one better.
  KernelTally tally_;
  CascadeKernel kernel_{tally_}, exact_{tally_};
  FacetEdge facet_;
  PointNumber at_ = 0;
};

Met run_chains(int chains, int crossings, PortableRandom& random, const auto& draw) {
  Met met;
  for (int k = 0; k < chains; ++k) {
    Chain chain(draw(), random, met);
    bool is_started = false;
    for (int tries = 0; tries < 5 && !is_started; ++tries) is_started = chain.start();
    for (int tries = 0; is_started && tries < crossings; ++tries) chain.cross_a_facet();
  }
  return met;
}

std::vector<Point> scene(TupleKind kind, PortableRandom& random, double scale = 1) {
  std::vector<Point> points;
  for (const Point& p : draw_tuple<8>(kind, random)) points.push_back({scale * p.x, scale * p.y, scale * p.z});
  return points;
}

void print(const char* name, const Met& met) {
  std::printf("%-12s %5zu crossings: doubled doubles decide %5zu, the longer precision %4zu, integers %4zu\n", name,
              met.crossings, met.by_doubled, met.by_extended, met.by_integers);
}

TEST(CrossingSphere, DoubledDoublesDecideWhatIsGeneric) {
  CITES("FC-NUM-01", "FC-NUM-02");
  PortableRandom random(5);
  const Met met = run_chains(60, 60, random, [&] { return scene(TupleKind::kGeneric, random); });
  print("generic", met);
  EXPECT_GT(met.crossings, 300U);
  EXPECT_GT(met.by_doubled, met.crossings * 8 / 10);
  EXPECT_EQ(met.known_extended, met.crossings);
}

// Spheres through points that are nearly coplanar have centres that doubled doubles know badly. Out of range, these
// know nothing at all.
TEST(CrossingSphere, TheLongerPrecisionDecidesBadStartsAndOutOfRange) {
  CITES("FC-NUM-01", "FC-NUM-02");
  PortableRandom random(6);
  const Met met = run_chains(200, 10, random, [&] { return scene(TupleKind::kOneUlp, random); });
  print("one ulp", met);
  EXPECT_GT(met.by_extended, 5U);
  for (const double scale : {0x1p120, 0x1p-120, 0x1p500, 0x1p-500}) {
    const Met far = run_chains(20, 40, random, [&] { return scene(TupleKind::kGeneric, random, scale); });
    print("far", far);
    EXPECT_EQ(far.by_doubled, 0U);
    EXPECT_GT(far.known_extended, 50U);
  }
}

// A bound never tells that a coordinate is zero, or half way between two doubles.
TEST(CrossingSphere, IntegersDecideTies) {
  CITES("FC-NUM-01", "FC-NUM-02");
  PortableRandom random(7);
  const Met met = run_chains(200, 30, random, [&] { return scene(TupleKind::kLattice, random); });
  print("lattice", met);
  EXPECT_GT(met.by_integers, 50U);
  // Upward along the z axis.
  const std::array<Point, 4> v = {Point{-1, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 3}};
  const Point q{0, 0, 1 + 0x1p-52};
  KernelTally tally;
  CascadeKernel kernel(tally);
  const PointNumber start = kernel.add_circumcenter(std::array{&v[0], &v[1], &v[2], &v[3]}, Stay::kPassing);
  const PointNumber at = kernel.add_crossing(start, v[0], v[1], q);
  EXPECT_EQ(kernel.exact(at)[0], 0);
  EXPECT_EQ(kernel.rounded(at), std::nullopt);
}

TEST(CrossingSphere, EveryKindOfInputIsRoundedToTheNearestDoubles) {
  CITES("FC-NUM-01", "FC-NUM-02");
  PortableRandom random(8);
  for (const TupleKind kind : flowcert_tests::kTupleKinds) {
    const Met met = run_chains(30, 10, random, [&] { return scene(kind, random); });
    print("kind", met);
    EXPECT_GT(met.crossings, 20U) << static_cast<int>(kind);
  }
}

TEST(CrossingSphere, WithoutADirectionNothingIsKnown) {
  CITES("FC-NUM-01");
  const Point p0{0, 0, -1}, p1{0, 0, 1}, q{3, 1, 0};
  EXPECT_FALSE(std::isfinite(sphere_at_crossing(Direction<DoubleDouble>{}, {&p0, &p1}, q).squared_radius.error));
  // The ray is parallel to the bisector, up to its error.
  const Direction<DoubleDouble> across{{DoubleDouble(-0x1p-50), DoubleDouble(1), DoubleDouble(0)}, 0x1p-50};
  const Point ahead{3, 0, 0};
  EXPECT_FALSE(std::isfinite(sphere_at_crossing(across, {&p0, &p1}, ahead).squared_radius.error));
}

}  // namespace
}  // namespace flowcert::flow::crossing_sphere_test
