// Doubles that are decided within bounds, against the doubles nearest to exact numbers.
//
// Guarantees: every bound is held against the exact error, in rationals. It is also at least what src/flow/cascades.md
// derives: random errors are seldom near the worst case, so a bound that is ten times too small would hardly ever
// contradict the exact numbers. Each test counts what was decided.
#include "geometry/bounded_sphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/exact_directions.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::geometry::bounded_sphere_test {
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::exact_number;
using flowcert_tests::exact_vector;
using flowcert_tests::is_zero;
using flowcert_tests::PortableRandom;
using flowcert_tests::RationalVector;
using flowcert_tests::squared;
using flowcert_tests::TupleKind;

// ---- Numbers ----

TEST(BoundedNumber, TheDoubleIsNearestToAllThatIsWithinTheBound) {
  CITES("FC-NUM-02");
  PortableRandom random(1);
  std::size_t decided = 0, open = 0;
  for (int k = 0; k < 40000; ++k) {
    // Half of them lie near the middle between two doubles, at distances like the error.
    const int exponent = k % 3 == 0 ? random.between(-1074, -1000) : random.between(-60, 60);
    const double high = std::ldexp(random.coordinate(), exponent);
    const double half = (std::nextafter(high, HUGE_VAL) - high) / 2;
    const double off = std::ldexp(half, -random.between(1, 60)) * random.coordinate();
    const DoubleDouble value = random.coin() ? DoubleDouble::sum(high, half + off) : DoubleDouble::sum(high, off);
    const double error = std::ldexp(half, -random.between(1, 60));
    const auto nearest = decided_double({value, error});
    const auto least = nearest_double(Rational(exact_number(value) - Rational(error)));
    const auto greatest = nearest_double(Rational(exact_number(value) + Rational(error)));
    ASSERT_TRUE(least && greatest);
    ++(nearest ? decided : open);
    if (nearest) {
      EXPECT_EQ(*nearest, *least);
      EXPECT_EQ(*nearest, *greatest);
    }
    if (*least != *greatest) {
      EXPECT_EQ(nearest, std::nullopt);
    }
  }
  EXPECT_GT(decided, 10000U);
  EXPECT_GT(open, 5000U);
}

TEST(BoundedNumber, WhatIsExactIsRoundedToEven) {
  CITES("FC-NUM-02");
  EXPECT_EQ(decided_double({DoubleDouble::sum(1, 0x1p-53), 0}), 1.0);
  EXPECT_EQ(decided_double({DoubleDouble::sum(1 + 0x1p-52, 0x1p-53), 0}), 1 + 0x1p-51);
  EXPECT_EQ(decided_double({DoubleDouble::sum(1, 0x1p-53), 0x1p-200}), std::nullopt) << "a tie, if it is known so well";
  EXPECT_EQ(decided_double({DoubleDouble(1), 0x1p-60}), 1.0);
  const auto zero = decided_double({DoubleDouble(-0.0), 0});
  ASSERT_TRUE(zero);
  EXPECT_FALSE(std::signbit(*zero));
}

TEST(BoundedNumber, ZeroAndInfinityAreLeftOpen) {
  CITES("FC-NUM-02");
  constexpr double kLargest = std::numeric_limits<double>::max();
  EXPECT_EQ(decided_double({DoubleDouble(0), 0x1p-1074}), std::nullopt);
  EXPECT_EQ(decided_double({DoubleDouble(0), 0x1p-1060}), std::nullopt);
  EXPECT_EQ(decided_double({DoubleDouble(1), HUGE_VAL}), std::nullopt);
  EXPECT_EQ(decided_double({}), std::nullopt);
  EXPECT_EQ(decided_double({DoubleDouble(HUGE_VAL), 0}), std::nullopt);
  EXPECT_EQ(decided_double({DoubleDouble(NAN), 0}), std::nullopt);
  EXPECT_EQ(decided_double({DoubleDouble::sum(kLargest, 0x1p969), 0x1p960}), kLargest);
  EXPECT_EQ(decided_double({DoubleDouble::sum(kLargest, 0x1p970), 0x1p960}), std::nullopt);
}

TEST(BoundedNumber, ADifferenceKeepsBothBounds) {
  CITES("FC-NUM-01");
  PortableRandom random(2);
  for (int k = 0; k < 5000; ++k) {
    const auto drawn = [&] { return DoubleDouble::sum(random.coordinate(), 0x1p-54 * random.coordinate()); };
    const BoundedNumber x{drawn(), 0x1p-90}, y{random.coin() ? drawn() : x.value, 0x1p-95};
    const BoundedNumber difference = x - y;
    const Rational error = abs(exact_number(difference.value) - (exact_number(x.value) - exact_number(y.value)));
    EXPECT_LE(error + Rational(x.error) + Rational(y.error), Rational(difference.error));
  }
}

// ---- Spheres ----

// Nothing if the points are not affinely independent.
std::optional<ExactSphere> exact_sphere_of(const std::vector<Point>& points) {
  const PointSet set(points);
  if (set.size() != points.size()) return std::nullopt;
  const auto from_first = [&](std::size_t k) -> RationalVector {
    return exact_vector(points[k]) - exact_vector(points[0]);
  };
  if (points.size() >= 3) {
    const RationalVector normal = cross(from_first(1), from_first(2));
    if (is_zero(normal)) return std::nullopt;
    if (points.size() == 4 && dot(normal, from_first(3)) == 0) return std::nullopt;
  }
  std::vector<PointId> contact(points.size());
  std::iota(contact.begin(), contact.end(), PointId{0});
  return exact_sphere(set, contact);
}

void expect_within(const BoundedNumber& number, const Rational& exact) {
  if (!std::isfinite(number.error)) return;
  EXPECT_LE(abs(exact_number(number.value) - exact), Rational(number.error));
}

// The error of the centre that the rounding of numerator and denominator may make, to first order.
Rational derived_error(const std::vector<Point>& points, const ExactSphere& sphere) {
  const auto from_first = [&](std::size_t k) -> RationalVector {
    return exact_vector(points[k]) - exact_vector(points[0]);
  };
  const auto size = [](const RationalVector& v) { return std::sqrt(static_cast<double>(squared(v))); };
  const RationalVector a = from_first(1), b = from_first(2);
  const double na = size(a), nb = size(b), radius = std::sqrt(static_cast<double>(sphere.squared_radius));
  if (points.size() == 3) {
    const double area = static_cast<double>(squared(cross(a, b))), square = na * na * nb * nb;
    return Rational(DoubleDouble::kRoundoff * square * (21 * (na + nb) + 29 * radius) / (2 * area));
  }
  const double nc = size(from_first(3)), volume = std::fabs(static_cast<double>(dot(a, cross(b, from_first(3)))));
  return Rational(DoubleDouble::kRoundoff * na * nb * nc * (13.8 * (na + nb + nc) + 19.6 * radius) / (2 * volume));
}

// The rounding of the squared radius alone, to first order. That of a circle's numerator is left out.
double derived_square_error(const std::vector<Point>& points, const ExactSphere& sphere) {
  const auto square = static_cast<double>(sphere.squared_radius);
  if (points.size() == 4) return 2 * static_cast<double>(derived_error(points, sphere)) * std::sqrt(square);
  const RationalVector a = exact_vector(points[1]) - exact_vector(points[0]),
                       b = exact_vector(points[2]) - exact_vector(points[0]);
  return DoubleDouble::kRoundoff * 29 * square * static_cast<double>(squared(a) * squared(b)) /
         (2 * static_cast<double>(squared(cross(a, b))));
}

struct Counts {
  std::size_t spheres = 0, decided = 0, decided_squares = 0;
};

void check_sphere(const std::vector<Point>& points, Counts& counts) {
  const auto exact = exact_sphere_of(points);
  if (!exact) return;
  std::vector<const Point*> given;
  given.reserve(points.size());
  for (const Point& p : points) given.push_back(&p);
  const BoundedSphere sphere = bounded_sphere(given);
  for (std::size_t axis = 0; axis < 3; ++axis) expect_within(sphere.center[axis], exact->center[axis]);
  expect_within(sphere.squared_radius, exact->squared_radius);
  const BoundedNumber alone = bounded_squared_radius(given);
  expect_within(alone, exact->squared_radius);
  if (points.size() >= 3 && std::isfinite(sphere.center[0].error)) {
    const Rational derived = derived_error(points, *exact);
    for (const BoundedNumber& number : sphere.center) {
      EXPECT_GE(Rational(number.error), derived);
    }
    const Rational offset =
        squared(exact_vector(points[0]) - RationalVector{exact->center[0], exact->center[1], exact->center[2]});
    EXPECT_GE(sphere.squared_radius.error, 2 * static_cast<double>(derived) * std::sqrt(static_cast<double>(offset)));
  }
  if (points.size() >= 3 && std::isfinite(alone.error)) {
    EXPECT_GE(alone.error, derived_square_error(points, *exact));
  }
  ++counts.spheres;
  const RoundedSphere truth = rounded_sphere(*exact);
  if (const auto decided = decided_double(alone)) {
    ++counts.decided_squares;
    EXPECT_EQ(*decided, truth.squared_radius);
  }
  if (const auto decided = decided_sphere(sphere)) {
    ++counts.decided;
    EXPECT_EQ(decided->center, truth.center);
    EXPECT_EQ(decided->squared_radius, truth.squared_radius);
  }
  std::vector<PointId> contact(points.size());
  std::iota(contact.begin(), contact.end(), PointId{0});
  const RoundedSphere rounded = rounded_sphere(PointSet(points), contact, points.size() - 1);
  EXPECT_EQ(rounded.center, truth.center);
  EXPECT_EQ(rounded.squared_radius, truth.squared_radius);
  EXPECT_EQ(rounded_squared_radius(PointSet(points), contact, points.size() - 1), truth.squared_radius);
}

template <std::size_t N>
Counts check_spheres(TupleKind kind, PortableRandom& random) {
  Counts counts;
  for (int k = 0; k < 400; ++k) {
    // A right angle takes three points.
    const auto tuple = draw_tuple<std::max<std::size_t>(N, 3)>(kind, random);
    check_sphere({tuple.begin(), tuple.begin() + N}, counts);
  }
  return counts;
}

TEST(BoundedSphere, IsWithinItsBoundsAndRoundsToTheNearestDoubles) {
  CITES("FC-NUM-01", "FC-NUM-02", "FC-CRIT-02");
  PortableRandom random(3);
  for (const TupleKind kind : flowcert_tests::kTupleKinds) {
    const Counts one = check_spheres<1>(kind, random), two = check_spheres<2>(kind, random),
                 three = check_spheres<3>(kind, random), four = check_spheres<4>(kind, random);
    EXPECT_EQ(one.decided, one.spheres);
    EXPECT_GT(two.spheres, 100U);
    EXPECT_GT(three.spheres, 50U);
    EXPECT_GT(four.spheres, 50U);
    if (kind == TupleKind::kGeneric || kind == TupleKind::kNearRight) {
      EXPECT_GT(two.decided, two.spheres * 9 / 10);
      EXPECT_GT(three.decided, three.spheres * 9 / 10);
      EXPECT_GT(four.decided, four.spheres * 9 / 10);
      EXPECT_GT(three.decided_squares, three.spheres * 9 / 10);
      EXPECT_GT(four.decided_squares, four.spheres * 9 / 10);
    }
  }
}

TEST(BoundedSphere, OutOfRangeNothingIsKnown) {
  CITES("FC-NUM-01");
  for (const double scale : {0x1p90, 0x1p-90, 0x1p1000, 0x1p-1040}) {
    const std::array<Point, 4> p = {Point{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale}};
    const std::array<const Point*, 4> given = {&p[0], &p[1], &p[2], &p[3]};
    for (const std::size_t count : {2U, 3U, 4U}) {
      EXPECT_FALSE(bounded_sphere(std::span(given).first(count)).squared_radius.error < HUGE_VAL) << count;
      EXPECT_FALSE(bounded_squared_radius(std::span(given).first(count)).error < HUGE_VAL) << count;
    }
  }
}

TEST(BoundedSphere, OverflowIsAnInfinity) {
  CITES("FC-NUM-02");
  const PointSet points(std::vector<Point>{{1.7e308, 0, 0}, {-1.7e308, 0, 0}});
  const RoundedSphere sphere = rounded_sphere(points, std::vector<PointId>{0, 1}, 1);
  EXPECT_EQ(sphere.center, (Point{0, 0, 0}));
  EXPECT_EQ(sphere.squared_radius, HUGE_VAL);
  EXPECT_EQ(exact_squared_radius(points, std::vector<PointId>{0, 1}), Rational(1.7e308) * Rational(1.7e308));
}

TEST(RoundedPoint, OverflowsToAnInfinityOfItsSign) {
  CITES("FC-NUM-02");
  const Rational large = 2 * Rational(1.7e308);
  EXPECT_EQ(rounded_point({large, -large, Rational(1) / 3}), (Point{HUGE_VAL, -HUGE_VAL, 1.0 / 3}));
}

}  // namespace
}  // namespace flowcert::geometry::bounded_sphere_test
