// The signs that steer the flow, on each rung of each kernel, against their definitions in rationals. The
// definitions are as in the paper, not as linear forms.
//
// Guarantees: a filter and an intermediate precision may leave a sign open, and never contradict the exact rung; all
// are asked on inputs that are degenerate, degenerate up to rounding, and one unit in the last place beside it.
#include "flow/kernels/steering.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "flow/kernels/cascade_kernel.h"
#include "flow/kernels/exact_kernel.h"
#include "flow/kernels/lazy_kernel.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::flow::steering_test {
namespace {

using Vector = Vector3<Rational>;

Vector in(const Point& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Vector in(const RationalPoint& p) { return {p[0], p[1], p[2]}; }

// Samples, a moving point and two points that were constructed.
struct Situation {
  std::array<Point, 4> samples;
  RationalPoint x, b, c;
};

// The definition of each query.
struct Meaning {
  Vector p, q, r, s, x, b, c;
  explicit Meaning(const Situation& all)
      : p(in(all.samples[0])),
        q(in(all.samples[1])),
        r(in(all.samples[2])),
        s(in(all.samples[3])),
        x(in(all.x)),
        b(in(all.b)),
        c(in(all.c)) {}

  [[nodiscard]] Vector m() const { return Rational(1) / 2 * (p + q); }
  // The bisector of p and `one` is reached from m where the way along one - m is half of this.
  [[nodiscard]] Rational excess(const Vector& one) const { return dot(one - m(), one - m()) - dot(p - m(), p - m()); }
  [[nodiscard]] std::vector<Sign> signs() const {
    return {sign_of(dot(cross(x - m(), c - m()), q - p)),
            sign_of(excess(s) * dot(x - m(), r - m()) - excess(r) * dot(x - m(), s - m())),
            sign_of(dot(x - m(), r - m())),
            sign_of(dot(cross(b - x, c - x), q - p)),
            sign_of(dot(b - x, r - m())),
            sign_of(dot(x - m(), c - m())),
            sign_of(dot(x - c, m() - c)),
            sign_of(dot(x - p, cross(q - p, r - p))),
            sign_of(dot(r - p, r - p) * dot(x - p, s - p) - dot(s - p, s - p) * dot(x - p, r - p))};
  }
};

struct Tally {
  std::size_t open = 0, decided = 0, zero = 0;
  std::size_t decided_by_extended = 0;  // of those that are open
};

template <class Kernel>
void expect_rungs(const Situation& all, Tally& tally) {
  KernelTally calls;
  Kernel kernel(calls);
  const PointNumber x = kernel.add(all.x), b = kernel.add(all.b), c = kernel.add(all.c);
  const auto& [p, q, r, s] = all.samples;
  const std::vector<Sign> expected = Meaning(all).signs();
  std::size_t k = 0;
  const auto ask = [&](const auto& query) {
    const Sign truth = expected.at(k++);
    EXPECT_EQ(kernel.sign_on_rung(query, KernelRung::kExact), truth) << k;
    const MaybeSign filtered = kernel.sign_on_rung(query, KernelRung::kFilter);
    EXPECT_EQ(filtered.value_or(truth), truth) << k;
    ++(filtered ? tally.decided : tally.open);
    EXPECT_EQ(kernel.sign_on_rung(query, KernelRung::kDoubled).value_or(truth), truth) << k;
    const MaybeSign extended = kernel.sign_on_rung(query, KernelRung::kExtended);
    EXPECT_EQ(extended.value_or(truth), truth) << k;
    tally.decided_by_extended += extended && !filtered ? 1 : 0;
    tally.zero += truth == Sign::kZero ? 1 : 0;
    EXPECT_EQ(kernel.sign(query), truth) << k;
  };
  ask(SideOfRay{x, p, q, c});
  ask(OrderOfExits{x, p, q, r, s});
  ask(RayAtInfinity{x, p, q, r});
  ask(AroundStart{x, p, q, b, c});
  ask(RayAroundStart{x, p, q, b, r});
  ask(AlongRay{x, p, q, c});
  ask(BeforePoint{x, p, q, c, c});
  ask(AlongEdge{x, p, q, r});
  ask(NearerExit{x, p, r, s});
  EXPECT_EQ(k, expected.size());
}

Rational nudged(const Rational& value, int by) { return value + Rational(by) * Rational(0x1p-80); }

// On a small grid signs are often zero.
Situation drawn(flowcert_tests::PortableRandom& random, double unit, int nudge) {
  const auto number = [&] { return unit * (static_cast<double>(random.below(7)) - 3); };
  const auto point = [&] { return Point{number(), number(), number()}; };
  const auto position = [&] {
    const Rational factor = random.coin() ? Rational(1) : Rational(1) / 3;
    return RationalPoint{factor * Rational(number()), nudged(Rational(number()), nudge), Rational(number())};
  };
  return {{point(), point(), point(), point()}, position(), position(), position()};
}

TEST(Steering, NoRungContradictsTheDefinition) {
  CITES("FC-NUM-01", "FC-FLOW-02", "FC-FLOW-03");
  flowcert_tests::PortableRandom random(7);
  Tally cascade, lazy, exact;
  for (const double unit : {1.0, 0.1, 0x1p-1000, 0x1p500, std::numeric_limits<double>::denorm_min()}) {
    for (const int nudge : {0, 1, -1}) {
      for (int k = 0; k < 200; ++k) {
        const Situation all = drawn(random, unit, nudge);
        expect_rungs<CascadeKernel>(all, cascade);
        expect_rungs<LazyKernel>(all, lazy);
        expect_rungs<ExactKernel>(all, exact);
      }
    }
  }
  EXPECT_EQ(exact.decided, 0U) << "it has no filter";
  EXPECT_EQ(exact.decided_by_extended + lazy.decided_by_extended, 0U) << "they have no such precision";
  EXPECT_GT(cascade.decided, 1000U);
  EXPECT_GT(cascade.open, 1000U);
  EXPECT_GT(cascade.decided_by_extended, 1000U);
  EXPECT_GT(lazy.zero, 300U);
  EXPECT_GT(lazy.decided, 5000U);
  EXPECT_GT(lazy.open, 1000U);
}

// The point that is equally far from p0, p1, qi and qj, if there is one.
std::optional<Vector> equidistant(const Meaning& of) {
  const Vector e = of.q - of.p, gi = Rational(2) * (of.r - of.m()), gj = Rational(2) * (of.s - of.m());
  const Rational det = dot(gi, cross(gj, e));
  if (det == 0) return std::nullopt;
  return of.m() + Rational(1 / det) * (of.excess(of.r) * cross(gj, e) + of.excess(of.s) * cross(e, gi));
}

RationalPoint position(const Vector& v) { return {v.x, v.y, v.z}; }

// x lies in the facet's plane here.
template <class Kernel>
void expect_the_side_of_the_equidistant_point(const Situation& all, std::array<std::size_t, 3>& seen) {
  const Meaning meaning(all);
  const std::optional<Vector> c = equidistant(meaning);
  if (!c) return;
  const Vector m = meaning.m(), e = meaning.q - meaning.p;
  EXPECT_EQ(dot(*c - meaning.p, *c - meaning.p), dot(*c - meaning.s, *c - meaning.s));
  KernelTally calls;
  Kernel kernel(calls);
  const PointNumber x = kernel.add(position(m + cross(meaning.x, e))), center = kernel.add(position(*c));
  const auto& [p, q, r, s] = all.samples;
  const Sign turn = sign_of(dot(cross(meaning.r - m, meaning.s - m), e));
  const auto side = static_cast<int>(kernel.sign(SideOfRay{x, p, q, center})) * static_cast<int>(turn);
  EXPECT_EQ(static_cast<int>(kernel.sign(OrderOfExits{x, p, q, r, s})), side);
  ++seen.at(static_cast<std::size_t>(side + 1));
}

TEST(Steering, TheOrderOfExitsIsTheSideOfTheEquidistantPoint) {
  CITES("FC-NUM-01", "FC-FLOW-02");
  flowcert_tests::PortableRandom random(11);
  std::array<std::size_t, 3> seen{};  // by sign
  for (const double unit : {1.0, 0.1, 0x1p500}) {
    for (const int nudge : {0, 1}) {
      for (int k = 0; k < 600; ++k) {
        const Situation all = drawn(random, unit, nudge);
        expect_the_side_of_the_equidistant_point<CascadeKernel>(all, seen);
        expect_the_side_of_the_equidistant_point<LazyKernel>(all, seen);
        expect_the_side_of_the_equidistant_point<ExactKernel>(all, seen);
      }
    }
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 100U);
}

// A kernel keeps constructed points by number. Those that last are kept apart.
template <class Kernel>
void expect_storage() {
  KernelTally tally;
  Kernel kernel(tally);
  const std::array<Point, 4> p = {Point{0, 0, 0}, Point{2, 0, 0}, Point{0, 2, 0}, Point{0, 0, 2}};
  const std::array<const Point*, 4> all = {&p[0], &p[1], &p[2], &p[3]};
  const PointNumber center = kernel.add_circumcenter(all, Stay::kLasting);
  const PointNumber circle = kernel.add_circumcenter(std::span(all).first(3), Stay::kPassing);
  EXPECT_EQ(circle, 0U);
  EXPECT_NE(center & kLasting, 0U);
  const auto [a, b, c] = std::array{in(p[1]) - in(p[0]), in(p[2]) - in(p[0]), in(p[3]) - in(p[0])};
  EXPECT_GT(dot(a, cross(b, c)), 0) << "four points must be positively oriented";
  EXPECT_EQ(kernel.exact(center), (RationalPoint{1, 1, 1}));
  EXPECT_EQ(kernel.exact(circle), (RationalPoint{1, 1, 0}));
  // The ray from the midpoint of p0 p1 through (1,1/2,0) meets the bisector of p0 and p2 at y = 1.
  const PointNumber x = kernel.add({1, Rational(1) / 2, 0});
  const PointNumber end = kernel.add_crossing(x, p[0], p[1], p[2]);
  EXPECT_EQ(kernel.exact(end), (RationalPoint{1, 1, 0}));
  EXPECT_EQ(kernel.kept(), 3U);
  kernel.drop_from(1);
  EXPECT_EQ(kernel.kept(), 1U);
  EXPECT_EQ(kernel.exact(circle), (RationalPoint{1, 1, 0}));
  EXPECT_EQ(kernel.exact(center), (RationalPoint{1, 1, 1}));
  kernel.drop_all();
  EXPECT_EQ(kernel.kept(), 0U);
  EXPECT_EQ(tally[FlowPrimitive::kCircumcenter].calls, 2U);
  EXPECT_EQ(tally[FlowPrimitive::kCrossing].calls, 1U);
}

TEST(Steering, AKernelKeepsItsPoints) {
  CITES("FC-NUM-01");
  expect_storage<CascadeKernel>();
  expect_storage<LazyKernel>();
  expect_storage<ExactKernel>();
}

// It has integers of a point where doubles and the longer precision left a sign open, and nowhere else.
TEST(Steering, TheCascadeKernelHasIntegersOnlyWhereTheyWereNeeded) {
  CITES("FC-NUM-01");
  KernelTally tally;
  CascadeKernel kernel(tally);
  const std::array<Point, 5> p = {Point{0, 0, 0}, Point{2, 0, 0}, Point{0, 2, 0}, Point{0, 0, 2}, Point{1, 5, 1}};
  const PointNumber center =
      kernel.add_circumcenter(std::array<const Point*, 4>{&p[0], &p[1], &p[2], &p[3]}, Stay::kPassing);
  EXPECT_EQ(kernel.exact_bytes(center), std::nullopt);
  // Seen from the midpoint of p0 p1, the centre lies in the direction (0,1,1).
  EXPECT_EQ(kernel.sign(RayAtInfinity{center, p[0], p[1], p[4]}), Sign::kPositive);
  EXPECT_EQ(kernel.exact_bytes(center), std::nullopt);
  EXPECT_EQ(tally[FlowPrimitive::kRayAtInfinity].failures, 0U);
  const Point across{1, 3, -3};
  EXPECT_EQ(kernel.sign(RayAtInfinity{center, p[0], p[1], across}), Sign::kZero);
  EXPECT_TRUE(kernel.exact_bytes(center).has_value());
  EXPECT_EQ(tally[FlowPrimitive::kRayAtInfinity].calls, 2U);
  EXPECT_EQ(tally[FlowPrimitive::kRayAtInfinity].failures, 1U);
}

}  // namespace
}  // namespace flowcert::flow::steering_test
