// The order of two samples by their distance from a position.
//
// Guarantees: it is held against squared distances in rationals, with last bits that differ, and with lengths beyond
// the range of the filter. Ties are counted.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/nearest_samples.h"
#include "geometry/rational_point.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::geometry::distance_order_test {
namespace {

Sign exact_order(const RationalPoint& x, const Point& p, const Point& q) {
  return sign_of(Rational(squared_distance(x, p) - squared_distance(x, q)));
}

TEST(DistanceOrder, IsTheExactOne) {
  CITES("FC-DIST-01");
  flowcert_tests::PortableRandom random(20081);
  std::size_t ties = 0;
  for (int round = 0; round < 4000; ++round) {
    // A length of all sizes, and last bits that differ.
    const double unit = round % 2 == 0 ? 1 : std::ldexp(1.0, random.between(-160, 160) * (round % 4 == 1 ? 1 : 6));
    const auto number = [&] { return unit * random.between(-2, 2) * (1 + random.between(-2, 2) * 0x1p-52); };
    const RationalPoint x{Rational(number()) / 3, Rational(number()), Rational(number())};
    const Point p{number(), number(), number()};
    // Mirrored in half of the rounds, but for its last bits.
    const double z = 2 * static_cast<double>(x[2]) - p.z;
    const Point q = random.coin() ? Point{number(), number(), number()} : Point{p.x, p.y, z};
    const Sign truth = exact_order(x, p, q);
    const DistanceOrder order(x);
    EXPECT_EQ(order.compare(p, q), truth) << round;
    EXPECT_EQ(order.compare(p, p), Sign::kZero);
    if (truth == Sign::kZero) ++ties;
  }
  EXPECT_GT(ties, 100U);
}

TEST(DistanceOrder, AsksRationalsWhereDoublesOverflow) {
  CITES("FC-DIST-01");
  const double far = 0x1p1000;
  const RationalPoint beyond{Rational(far) * Rational(far), 0, 0};  // has no nearest double
  EXPECT_EQ(DistanceOrder(beyond).compare({1, 0, 0}, {0, 0, 0}), Sign::kNegative);
  EXPECT_EQ(DistanceOrder(beyond).compare({0, 1, 0}, {0, -1, 0}), Sign::kZero);
  const RationalPoint x{0, 0, 0};
  EXPECT_EQ(DistanceOrder(x).compare({far, 0, 0}, {0, 2 * far, 0}), Sign::kNegative);
  EXPECT_EQ(DistanceOrder(x).compare({far, 0, 0}, {0, far, 0}), Sign::kZero);
}

}  // namespace
}  // namespace flowcert::geometry::distance_order_test
