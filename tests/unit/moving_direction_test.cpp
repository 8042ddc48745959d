// The moving direction against the plain functions of direction.h, to the bit: their signs, and the directions behind
// all sorts of crossings. What the bounds guarantee is tested with those functions (direction_bounds_test).
#include "flow/kernels/moving_direction.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::flow {
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::kTupleKinds;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

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

void expect_same_signs(const MovingDirection& moving, const Point& q, const Point& r, Met& met) {
  const auto sign = moving.order(moving.see(q), moving.see(r));
  EXPECT_EQ(sign, order_sign(moving.direction(), moving.facet(), q, r));
  EXPECT_EQ(moving.approach(q), approach_sign(moving.direction(), moving.facet(), q));
  ++(sign ? met.signs : met.open);
}

// Of the three points of the polygon, the next facet's edge has q and one of the two ends, in either order. Of a larger
// polygon, it may have none of them.
FacetEdge next_edge(FacetEdge facet, const Point& q, const Point& r, const Point& s, PortableRandom& random, Met& met) {
  if (random.below(4) == 0) {
    ++met.unrelated;
    return {&r, &s};
  }
  const bool keeps_first = random.coin();
  ++(keeps_first ? met.kept_first : met.kept_second);
  const Point* const kept = keeps_first ? facet.p0 : facet.p1;
  return random.coin() ? FacetEdge{kept, &q} : FacetEdge{&q, kept};
}

void follow_chain(const std::array<Point, 12>& points, PortableRandom& random, Met& met) {
  MovingDirection moving;
  const FacetEdge first{&points[0], &points[1]};
  moving.begin(direction_from_vertex<double>({&points[0], &points[1], &points[2], &points[3]}, first), first);
  for (std::size_t step = 0; step < 6 && moving.is_known(); ++step) {
    const Point &q = points[4 + step], &r = points[(5 + step) % 12], &s = points[(6 + step) % 12];
    expect_same_signs(moving, q, r, met);
    const FacetEdge from = moving.facet(), to = next_edge(from, q, r, s, random, met);
    const Direction<double> expected = direction_across(moving.direction(), from, q, to);
    moving.cross(moving.see(q), to);
    EXPECT_EQ(moving.facet(), to);
    expect_same(moving.direction(), expected);
  }
  met.unknown += moving.is_known() ? 0 : 1;
}

TEST(MovingDirection, IsThatOfThePlainFunctionsToTheBit) {
  CITES("FC-NUM-01");
  Met met;
  for (const TupleKind kind : kTupleKinds) {
    PortableRandom random(static_cast<std::uint64_t>(kind) + 1);
    for (int round = 0; round < 2000; ++round) follow_chain(draw_tuple<12>(kind, random), random, met);
  }
  // Otherwise nothing of this was tested.
  EXPECT_GT(met.signs, 5000U);
  EXPECT_GT(met.open, 50U);
  EXPECT_GT(met.kept_first, 3000U);
  EXPECT_GT(met.kept_second, 3000U);
  EXPECT_GT(met.unrelated, 2000U);
  EXPECT_GT(met.unknown, 500U);
}

}  // namespace
}  // namespace flowcert::flow
