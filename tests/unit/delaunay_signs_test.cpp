// The signs under the triangulation, on every kind of input (tests/unit/point_tuples.h), asked of any points and of
// these points alone: they are what the definitions say, which the test writes down in rationals.
#include "voronoi/delaunay_signs.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <ostream>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "geometry/integer_grid.h"
#include "geometry/predicates.h"
#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"
#include "tests/unit/rational_geometry.h"

namespace flowcert::geometry {

// GoogleTest finds this for its messages.
static void PrintTo(Sign sign, std::ostream* out) { *out << static_cast<int>(sign); }

}  // namespace flowcert::geometry

namespace flowcert::delaunay_signs_test {

using namespace voronoi;

namespace {

using flowcert_tests::circle_center;
using flowcert_tests::determinant;
using flowcert_tests::draw_tuple;
using flowcert_tests::exactly;
using flowcert_tests::flatten;
using flowcert_tests::inner;
using flowcert_tests::kTupleKinds;
using flowcert_tests::minus;
using flowcert_tests::normal_of;
using flowcert_tests::PortableRandom;
using flowcert_tests::squared_distance;
using flowcert_tests::TupleKind;

constexpr int kTuples = 120;

Sign sign(const Rational& value) { return static_cast<Sign>(flowcert_tests::sign_of(value)); }

Rational volume(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r, const RationalPoint& s) {
  return determinant(minus(q, p), minus(r, p), minus(s, p));
}

// The determinant of the lifted points, seen from t, by its last column: CGAL's definition, for flat cells too.
Rational lifted(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r, const RationalPoint& s,
                const RationalPoint& t) {
  return squared_distance(p, t) * volume(t, q, r, s) - squared_distance(q, t) * volume(t, p, r, s) +
         squared_distance(r, t) * volume(t, p, q, s) - squared_distance(s, t) * volume(t, p, q, r);
}

Sign turn(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  const RationalPoint normal = normal_of(p, q, r);
  if (normal[2] != 0) return sign(normal[2]);
  if (normal[0] != 0) return sign(normal[0]);
  return sign(-normal[1]);
}

// Calls `check` with signs that may be asked of the points, and draws tuples of each kind for it.
template <std::size_t N>
void for_each_tuple(bool is_flat, const auto& check) {
  PortableRandom random(50);
  for (const TupleKind kind : kTupleKinds) {
    for (int k = 0; k < kTuples; ++k) {
      std::array<Point, N> tuple = draw_tuple<N>(kind, random);
      if (is_flat) flatten(tuple, random);
      check(DelaunaySigns(), tuple);
      check(DelaunaySigns(PointSet(tuple)), tuple);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

// How often each sign was the answer.
using Seen = std::map<Sign, int>;
void expect_all(Seen& seen) {
  for (const Sign sign : {Sign::kNegative, Sign::kZero, Sign::kPositive}) EXPECT_GT(seen[sign], 50);
}

TEST(DelaunaySigns, OrientationsAndSpheresAreThoseOfTheDefinition) {
  CITES("FC-NUM-01");
  Seen orientations, spheres;
  for_each_tuple<5>(false, [&](const DelaunaySigns& signs, const std::array<Point, 5>& t) {
    const RationalPoint p = exactly(t[0]), q = exactly(t[1]), r = exactly(t[2]), s = exactly(t[3]);
    const Sign orientation = sign(volume(p, q, r, s)), sphere = sign(lifted(p, q, r, s, exactly(t[4])));
    ASSERT_EQ(signs.orientation(t[0], t[1], t[2], t[3]), orientation);
    ASSERT_EQ(signs.inside_sphere(t[0], t[1], t[2], t[3], t[4]), sphere);
    ++orientations[orientation];
    ++spheres[sphere];
  });
  expect_all(orientations);
  expect_all(spheres);
}

TEST(DelaunaySigns, ACentreIsInsideItsSphere) {
  CITES("FC-NUM-01");
  const DelaunaySigns signs;
  const Point p{0, 0, 0}, q{2, 0, 0}, r{0, 2, 0}, s{0, 0, 2};
  EXPECT_EQ(signs.orientation(p, q, r, s), Sign::kPositive);
  EXPECT_EQ(signs.inside_sphere(p, q, r, s, {1, 1, 1}), Sign::kPositive);
  EXPECT_EQ(signs.inside_sphere(p, r, q, s, {1, 1, 1}), Sign::kNegative);
}

TEST(DelaunaySigns, TurnsAreThoseOfTheDefinition) {
  CITES("FC-NUM-01");
  Seen turns;
  for_each_tuple<3>(false, [&](const DelaunaySigns& signs, const std::array<Point, 3>& t) {
    const Sign expected = turn(exactly(t[0]), exactly(t[1]), exactly(t[2]));
    ASSERT_EQ(signs.turn(t[0], t[1], t[2]), expected);
    ++turns[expected];
  });
  expect_all(turns);
}

TEST(DelaunaySigns, CirclesAreThoseOfTheDefinition) {
  CITES("FC-NUM-01");
  Seen circles;
  for_each_tuple<4>(true, [&](const DelaunaySigns& signs, const std::array<Point, 4>& t) {
    const RationalPoint p = exactly(t[0]), q = exactly(t[1]), r = exactly(t[2]);
    const RationalPoint normal = normal_of(p, q, r);
    if (inner(normal, normal) == 0) return;
    const RationalPoint center = circle_center(p, q, r);
    const Sign expected = sign(squared_distance(p, center) - squared_distance(exactly(t[3]), center));
    ASSERT_EQ(signs.inside_circle(t[0], t[1], t[2], t[3]), expected);
    ++circles[expected];
  });
  expect_all(circles);
}

// Doubles that nothing was rounded in answer where it is said, and as the integers do.
TEST(DelaunaySigns, LatticesAreKnownInDoubles) {
  CITES("FC-NUM-01");
  int answers = 0, zeros = 0;
  PortableRandom random(51);
  for (const TupleKind kind : kTupleKinds) {
    for (int k = 0; k < kTuples; ++k) {
      const std::array<Point, 5> t = draw_tuple<5>(kind, random);
      const OutsideSphere query{t[0], t[1], t[2], t[3], t[4]};
      const IntegerGrid grid(t);
      const double reach = grid.fits_small() ? grid.exact_reach() : 0;
      const MaybeSign known = unrounded_sign<OutsideSphere>(query.vectors(vector_between<Point>), reach);
      ASSERT_FALSE(known && kind == TupleKind::kGeneric);
      if (!known) continue;
      ASSERT_EQ(*known, *sign_on_rung(query, Rung::kBig));
      ++answers;
      zeros += *known == Sign::kZero ? 1 : 0;
    }
  }
  EXPECT_GT(answers, 150);
  EXPECT_GT(zeros, 50);
  EXPECT_LT(zeros, answers);
}

}  // namespace

}  // namespace flowcert::delaunay_signs_test
