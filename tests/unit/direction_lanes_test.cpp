// The directions in lanes against the plain functions of direction.h, to the bit: their signs, and the directions
// behind all sorts of crossings, with the wide instructions and without them. What the bounds guarantee is tested with
// those functions (direction_bounds_test).
#include "flow/direction_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::flow::direction_lanes_test {
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::kTupleKinds;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;
using geometry::MaybeSign;

constexpr std::size_t kLanes = DirectionLanes::kLanes;

struct Met {
  std::size_t signs = 0, open = 0, kept_first = 0, kept_second = 0, unrelated = 0, unknown = 0;
};

// Equal, where -0 and 0 are one value, as they are for every sign.
void expect_same(const Direction<double>& a, const Direction<double>& b) {
  ASSERT_EQ(a.is_known(), b.is_known());
  if (!a.is_known()) return;
  EXPECT_EQ(a.u.x, b.u.x);
  EXPECT_EQ(a.u.y, b.u.y);
  EXPECT_EQ(a.u.z, b.u.z);
  EXPECT_EQ(a.error, b.error);
}

// A moving point, and what the plain functions say of it.
struct Walker {
  std::array<Point, 12> points;
  FacetEdge facet;
  Direction<double> direction;
};

void expect_same_signs(DirectionLanes& lanes, const std::vector<Walker>& walkers, std::size_t step, Met& met) {
  const auto qi = [&](const Walker& w) -> const Point& { return w.points[4 + step]; };
  const auto qj = [&](const Walker& w) -> const Point& { return w.points[(5 + step) % 12]; };
  for (std::size_t k = 0; k < kLanes; ++k) lanes.ask_order(k, qi(walkers[k]), qj(walkers[k]));
  lanes.order();
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Walker& w = walkers[k];
    const MaybeSign sign = order_sign(w.direction, w.facet, qi(w), qj(w));
    EXPECT_EQ(lanes.sign(k), sign ? static_cast<int>(*sign) : 0);
    ++(sign ? met.signs : met.open);
  }
}

// The next facet's edge mostly has q and one of this facet's two ends, in either order. A larger polygon may have a
// side that has none of them, and some lanes cross nothing.
void expect_same_crossings(DirectionLanes& lanes, std::vector<Walker>& walkers, std::size_t step,
                           PortableRandom& random, Met& met) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    Walker& w = walkers[k];
    const Point &q = w.points[4 + step], &r = w.points[(5 + step) % 12], &s = w.points[(6 + step) % 12];
    const std::size_t way = random.below(5);
    if (way == 0) {
      ++met.unrelated;
      const FacetEdge to{&r, &s};
      w.direction = direction_across(w.direction, w.facet, q, to);
      w.facet = to;
      lanes.set(k, w.direction, to);
    } else if (way < 4) {
      const bool keeps_first = random.coin(), ends_at_q = random.coin();
      ++(keeps_first ? met.kept_first : met.kept_second);
      const Point* const kept = keeps_first ? w.facet.p0 : w.facet.p1;
      const FacetEdge to = ends_at_q ? FacetEdge{kept, &q} : FacetEdge{&q, kept};
      lanes.ask_crossing(k, keeps_first, q, ends_at_q);
      w.direction = direction_across(w.direction, w.facet, q, to);
      w.facet = to;
    }
  }
  lanes.cross();
  for (std::size_t k = 0; k < kLanes; ++k) {
    expect_same(lanes.direction(k), walkers[k].direction);
    EXPECT_EQ(lanes.is_known(k), walkers[k].direction.is_known());
  }
}

void follow_chains(DirectionLanes& lanes, TupleKind kind, PortableRandom& random, Met& met) {
  std::vector<Walker> walkers(kLanes);
  for (std::size_t k = 0; k < kLanes; ++k) {
    Walker& w = walkers[k];
    w.points = draw_tuple<12>(kind, random);
    const auto& p = w.points;
    w.facet = {&p[0], &p[1]};
    w.direction = direction_from_vertex<double>({&p[0], &p[1], &p[2], &p[3]}, w.facet);
    lanes.set(k, w.direction, w.facet);
  }
  for (std::size_t step = 0; step < 6; ++step) {
    expect_same_signs(lanes, walkers, step, met);
    expect_same_crossings(lanes, walkers, step, random, met);
  }
  for (const Walker& w : walkers) met.unknown += w.direction.is_known() ? 0 : 1;
}

class DirectionLanesTest : public testing::TestWithParam<bool> {};

TEST_P(DirectionLanesTest, AreThePlainFunctionsToTheBit) {
  CITES("FC-NUM-01");
  if (GetParam() && !DirectionLanes::processor_has_wide()) GTEST_SKIP() << "this processor has no wide instructions";
  DirectionLanes lanes;
  lanes.use_wide_instructions(GetParam());
  Met met;
  for (const TupleKind kind : kTupleKinds) {
    PortableRandom random(static_cast<std::uint64_t>(kind) + 1);
    for (int round = 0; round < 150; ++round) follow_chains(lanes, kind, random, met);
  }
  // Otherwise nothing of this was tested.
  EXPECT_GT(met.signs, 5000U);
  EXPECT_GT(met.open, 50U);
  EXPECT_GT(met.kept_first, 3000U);
  EXPECT_GT(met.kept_second, 3000U);
  EXPECT_GT(met.unrelated, 2000U);
  EXPECT_GT(met.unknown, 500U);
}

INSTANTIATE_TEST_SUITE_P(Instructions, DirectionLanesTest, testing::Bool(),
                         [](const auto& info) { return std::string(info.param ? "Wide" : "Plain"); });

}  // namespace
}  // namespace flowcert::flow::direction_lanes_test
