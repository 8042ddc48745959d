// The error bounds of the double filters, compared with what is proved of the errors (spec/proofs/filters/Proved.v): a
// filter must leave a sign open where the double is within the proven error of zero.
//
// Random inputs seldom have rounding errors near the worst case, so a bound ten times too small hardly ever
// contradicts the next rung. Here it fails on every near tie. Each test counts the values within the
// bound, and those of them beyond a fifth of it, which alone can tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/nearest_samples.h"
#include "geometry/predicates.h"
#include "geometry/rational_point.h"
#include "geometry/tetrahedron_signs.h"
#include "geometry/vector3.h"
#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::filter_bounds_test {

using namespace geometry;
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

using Vector = Vector3<double>;

double norm(const Vector& v) { return std::sqrt(dot(v, v)); }

// A polynomial's value in doubles, and the error that is proven for it.
struct Value {
  double value = 0, error = 0;
};

// How many values lay within the proven error, and how many of them beyond a fifth of it.
struct Seen {
  int within = 0, telling = 0;

  void add(const Value& v) {
    ++within;
    telling += std::fabs(v.value) > v.error / 5 ? 1 : 0;
  }
};

template <std::size_t N>
std::array<Vector, N - 1> vectors_from_first(const std::array<Point, N>& t) {
  std::array<Vector, N - 1> vectors;
  for (std::size_t k = 1; k < N; ++k) vectors[k - 1] = vector_between(t[0], t[k]);
  return vectors;
}

// Generic points, moved towards a tie by Newton steps on the last point's x. They are ties up to rounding,
// and use all their bits. `f` must be smooth.
template <std::size_t N, class Function>
std::array<Point, N> near_tie(PortableRandom& random, const Function& f) {
  for (;;) {
    std::array<Point, N> t = draw_tuple<N>(TupleKind::kGeneric, random);
    Point& last = t[N - 1];
    for (int round = 0; round < 30; ++round) {
      constexpr double kStep = 1e-6;
      const double here = f(t);
      std::array<Point, N> beside = t;
      beside[N - 1].x += kStep;
      const double slope = (f(beside) - here) / kStep;
      if (!(std::fabs(slope) > 1e-3)) break;
      last.x -= here / slope;
    }
    if (!(std::fabs(last.x) < 8)) continue;
    const double far = random.coin() ? 16 : -16;
    for (int ulps = 1 << random.below(7); ulps > 1; --ulps) last.x = std::nextafter(last.x, far);
    return t;
  }
}

constexpr double u = kUnitRoundoff;  // NOLINT(readability-identifier-naming): as in formulas

Value angle_value(const std::array<Point, 3>& t) {
  const Vector a = vector_between(t[1], t[0]), b = vector_between(t[1], t[2]);
  return {dot(a, b), 5 * u * norm(a) * norm(b)};
}
Value orientation_value(const std::array<Point, 4>& t) {
  const auto [a, b, c] = vectors_from_first(t);
  return {dot(a, cross(b, c)), 8.414 * u * norm(a) * norm(b) * norm(c)};
}
// <a x b, numerator>
Value side_value(const std::array<Point, 4>& t) {
  const auto [a, b, c] = vectors_from_first(t);
  const auto sphere = circumsphere(a, b, c);
  const double abc = norm(a) * norm(b) * norm(c);
  return {dot(sphere.ab, sphere.numerator), 19.828 * u * norm(a) * norm(b) * abc * (norm(a) + norm(b) + norm(c))};
}
// |v|^2 det - <numerator, v>
Value sphere_value(const std::array<Point, 5>& t) {
  const auto [a, b, c, v] = vectors_from_first(t);
  const auto sphere = circumsphere(a, b, c);
  const double product = norm(a) * norm(b) * norm(c) * norm(v);
  return {dot(v, v) * sphere.determinant - dot(sphere.numerator, v),
          17.414 * u * product * (norm(a) + norm(b) + norm(c) + norm(v))};
}
// For points with z = 0.
Value circle_value(const std::array<Point, 4>& t) {
  const Vector aq = vector_between(t[2], t[0]), bq = vector_between(t[2], t[1]);
  const Vector ar = vector_between(t[3], t[0]), br = vector_between(t[3], t[1]);
  return {dot(aq, bq) * std::fabs(cross(ar, br).z) + dot(ar, br) * std::fabs(cross(aq, bq).z),
          22.828 * u * norm(aq) * norm(bq) * norm(ar) * norm(br)};
}

constexpr int kTies = 3000;

template <std::size_t N, class Of, class Query>
void expect_open_within_the_error(const Of& value_of, const Query& query, bool is_flat = false) {
  PortableRandom random(1234);
  Seen seen;
  for (int k = 0; k < kTies; ++k) {
    const auto f = [&](std::array<Point, N> t) {
      for (Point& p : t) p.z = is_flat ? 0 : p.z;
      return value_of(t).value;
    };
    std::array<Point, N> t = near_tie<N>(random, f);
    for (Point& p : t) p.z = is_flat ? 0 : p.z;
    const Value value = value_of(t);
    if (std::fabs(value.value) > value.error) continue;
    seen.add(value);
    EXPECT_EQ(sign_on_rung(query(t), Rung::kDouble), std::nullopt) << value.value << " of " << value.error;
  }
  EXPECT_GT(seen.within, kTies / 5);
  EXPECT_GT(seen.telling, 10);
}

TEST(FilterBounds, OfTheAngle) {
  CITES("FC-NUM-01");
  expect_open_within_the_error<3>(angle_value, [](const auto& t) { return Angle{t[0], t[1], t[2]}; });
}

TEST(FilterBounds, OfTheOrientation) {
  CITES("FC-NUM-01");
  expect_open_within_the_error<4>(orientation_value, [](const auto& t) { return Orientation{t[0], t[1], t[2], t[3]}; });
}

TEST(FilterBounds, OfTheSideOfAPlane) {
  CITES("FC-NUM-01");
  expect_open_within_the_error<4>(side_value, [](const auto& t) { return SideOfPlane{t[0], t[1], t[2], t[3]}; });
}

TEST(FilterBounds, OfTheSphere) {
  CITES("FC-NUM-01");
  expect_open_within_the_error<5>(sphere_value,
                                  [](const auto& t) { return OutsideSphere{t[0], t[1], t[2], t[3], t[4]}; });
}

TEST(FilterBounds, OfTheCircle) {
  CITES("FC-NUM-01");
  expect_open_within_the_error<4>(
      circle_value, [](const auto& t) { return OutsideCircle{t[0], t[1], t[2], t[3]}; }, true);
}

// The filter of a whole cell does not tell which signs it left open, but counts them.
struct CellValues {
  std::array<Value, 12> angles;
  std::array<Value, 4> sides;  // [i]: of the facet opposite vertex i
};

CellValues cell_values(const std::array<Point, 4>& t) {
  const auto [a, b, c] = vectors_from_first(t);
  const double na = norm(a), nb = norm(b), nc = norm(c);
  const double largest = std::max({na, nb, nc});
  CellValues values;
  std::size_t filled = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = k + 1; l < 4; ++l) {
        if (j == k || j == l) continue;
        // An angle at vertex 0 is one dot product. Others are sums of up to four, of which this is another rounding.
        values.angles[filled++] = {dot(vector_between(t[j], t[k]), vector_between(t[j], t[l])),
                                   (j == 0 ? 5 : 20) * u * largest * largest};
      }
    }
  }
  const auto sphere = circumsphere(a, b, c);
  const double s3 = dot(sphere.ab, sphere.numerator), s1 = dot(sphere.bc, sphere.numerator),
               s2 = dot(sphere.ca, sphere.numerator);
  const double total = na * nb * nc * (na + nb + nc);
  values.sides = {Value{2 * sphere.determinant * sphere.determinant - s1 - s2 - s3,
                        27.9 * u * total * (na * nb + nb * nc + nc * na)},
                  {s1, 19.828 * u * total * nb * nc},
                  {s2, 19.828 * u * total * nc * na},
                  {s3, 19.828 * u * total * na * nb}};
  return values;
}

TEST(FilterBounds, OfTheAnglesAndSidesOfACell) {
  CITES("FC-NUM-01", "FC-SIGN-01", "FC-SIGN-03");
  PortableRandom random(77);
  std::array<Seen, 12> angles;
  std::array<Seen, 4> sides;
  for (int k = 0; k < 16 * 2000; ++k) {
    const auto which = static_cast<std::size_t>(k % 16);
    // Each of the four points may be the one that is moved.
    const auto turn = static_cast<std::ptrdiff_t>(random.below(4));
    const auto turned = [turn](std::array<Point, 4> tuple) {
      std::rotate(tuple.begin(), tuple.begin() + turn, tuple.end());
      return tuple;
    };
    const std::array<Point, 4> t = turned(near_tie<4>(random, [&](const std::array<Point, 4>& tuple) {
      const CellValues values = cell_values(turned(tuple));
      return which < 12 ? values.angles[which].value : values.sides[which - 12].value;
    }));
    if (unfiltered_sign(Orientation{t[0], t[1], t[2], t[3]}) != Sign::kPositive) continue;
    const CellValues values = cell_values(t);
    CellSphere unused;
    FilterTally tally;
    (void)tetrahedron_signs({&t[0], &t[1], &t[2], &t[3]}, unused, tally);
    std::uint64_t open_angles = 0, open_sides = 0;
    for (std::size_t i = 0; i < 12; ++i) {
      if (std::fabs(values.angles[i].value) > values.angles[i].error) continue;
      ++open_angles;
      angles[i].add(values.angles[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::fabs(values.sides[i].value) > values.sides[i].error) continue;
      ++open_sides;
      sides[i].add(values.sides[i]);
    }
    ASSERT_GE(tally[Predicate::kAngle].failures, open_angles);
    ASSERT_GE(tally[Predicate::kSideOfPlane].failures, open_sides);
  }
  for (const Seen& seen : angles) EXPECT_GT(seen.within, 30);
  for (const Seen& seen : sides) EXPECT_GT(seen.telling, 5);
}

TEST(FilterBounds, OfTheCellsSphere) {
  CITES("FC-NUM-01", "FC-VOR-01");
  PortableRandom random(78);
  Seen seen;
  for (int k = 0; k < kTies; ++k) {
    std::array<Point, 5> t =
        near_tie<5>(random, [](const std::array<Point, 5>& tuple) { return sphere_value(tuple).value; });
    if (unfiltered_sign(Orientation{t[0], t[1], t[2], t[3]}) != Sign::kPositive) std::swap(t[2], t[3]);
    const Value value = sphere_value(t);
    if (std::fabs(value.value) > value.error) continue;
    seen.add(value);
    const TetrahedronPoints cell{&t[0], &t[1], &t[2], &t[3]};
    CellSphere sphere;
    FilterTally tally;
    (void)tetrahedron_signs(cell, sphere, tally);
    (void)on_sphere(cell, sphere, t[4], tally);
    ASSERT_EQ(tally[Predicate::kCospherical].failures, 1u) << value.value << " of " << value.error;
  }
  EXPECT_GT(seen.within, kTies / 2);
  EXPECT_GT(seen.telling, 10);
}

// C(x) by exact distances alone.
std::vector<PointId> nearest_by_exact_scan(const PointSet& points, const RationalPoint& x) {
  std::vector<Rational> distances;
  for (const Point& p : points.points()) distances.push_back(squared_distance(x, p));
  const Rational least = *std::ranges::min_element(distances);
  std::vector<PointId> names;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (distances[k] == least) names.push_back(points.name(k));
  }
  return names;
}

// Samples around a centre at offsets that are permutations of one another, up to signs and rounding, and a position
// that is as far from two of them. Every third time the offsets are random. The centre is `far` times the offsets'
// length away.
void expect_nearest_samples(double scale, double far, std::uint64_t seed) {
  PortableRandom random(seed);
  int ties = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const auto draw = [&] { return random.coordinate() * scale; };
    const Point centre{far * draw(), far * draw(), far * draw()};
    std::vector<double> offset = {draw(), draw(), draw()};
    std::vector<Point> rows;
    for (int k = 0; k < 8; ++k) {
      if (trial % 3 == 0) offset = {draw(), draw(), draw()};
      random.shuffle(offset);
      const auto sign = [&] { return random.coin() ? 1 : -1; };
      rows.push_back({centre.x + sign() * offset[0], centre.y + sign() * offset[1], centre.z + sign() * offset[2]});
    }
    const PointSet points(rows);
    const RationalPoint first = exact_position(rows[0]);
    for (const Point& other : rows) {
      RationalPoint x = exact_position(centre);
      if (trial % 2 == 0) {
        // The foot of the centre on the bisector of the two.
        const RationalPoint second = exact_position(other);
        Rational along = 0, length = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Rational d = second[axis] - first[axis];
          along += d * ((first[axis] + second[axis]) / 2 - x[axis]);
          length += d * d;
        }
        if (length == 0) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += along / length * (second[axis] - first[axis]);
      }
      const NearestSamples nearest = nearest_samples(points, x);
      ASSERT_EQ(nearest.names, nearest_by_exact_scan(points, x)) << "scale " << scale << ", far " << far;
      EXPECT_EQ(nearest.squared_distance, squared_distance(x, points[points.ordinal_of_row(nearest.names[0])]));
      if (nearest.names.size() > 1) ++ties;
    }
  }
  EXPECT_GT(ties, 100) << scale << ", " << far;
}

TEST(FilterBounds, OfTheNearestSamples) {
  CITES("FC-NUM-01", "FC-DIST-01");
  std::uint64_t seed = 100;
  // Squares become subnormal near 2^-537, and zero below; they overflow beyond 2^511.
  for (const double scale : {1.0, 0x1p-520, 0x1p-530, 0x1p-536, 0x1p-1060, 0x1p490, 0x1p509, 0x1p900}) {
    for (const double far : {0.0, 1.0, 0x1p20, 0x1p48}) expect_nearest_samples(scale, far, ++seed);
  }
  // This position has no nearest double.
  const PointSet points(std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {1, -1, 0}});
  const Rational beyond = Rational(0x1p1023) * 4;
  EXPECT_EQ(nearest_samples(points, {beyond, 0, 0}).names, (std::vector<PointId>{1, 2}));
}

}  // namespace
}  // namespace flowcert::filter_bounds_test
