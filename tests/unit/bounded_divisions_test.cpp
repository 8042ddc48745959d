// Points of divisions in doubled doubles, against the same points in rationals.
//
// Guarantees: every bound is held against the exact error. Inputs are thin, so that numbers cancel and errors are much
// larger than a roundoff; a bound that left one of them out would be contradicted. Each test counts what was decided.
#include "morse/bounded_divisions.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "flowcert/flow_complex.h"
#include "morse/exact_divisions.h"
#include "tests/cites.h"
#include "tests/unit/exact_directions.h"
#include "tests/unit/portable_random.h"

namespace flowcert::morse::bounded_divisions_test {
namespace {

using flowcert_tests::exact_number;
using flowcert_tests::exact_vector;
using flowcert_tests::PortableRandom;

Rational power_of_two(int exponent) { return Rational(std::ldexp(1.0, exponent)); }

// Points of a plate that is 2^thinness times as long as it is thick, in a unit that is a power of two.
std::vector<Point> plate(std::size_t count, int thinness, int unit, PortableRandom& random) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = random.coordinate(), y = random.coordinate(), z = random.coordinate();
    points.push_back(
        {std::ldexp(x, unit), std::ldexp(y, unit), std::ldexp(x + y, unit) + std::ldexp(z, unit - thinness)});
  }
  return points;
}

struct Count {
  std::size_t crossings = 0, open = 0, turned = 0, decided = 0, spheres = 0, determinants = 0;
};

// Volumes are in units.
void expect_within(const BoundedNumber& number, const Rational& exact, const BoundedDivisions& divisions,
                   std::size_t& known) {
  if (!(number.error < HUGE_VAL)) return;
  const Rational error = abs(exact_number(number.value) - exact / power_of_two(3 * divisions.unit()));
  EXPECT_LE(error, Rational(number.error));
  ++known;
}

void expect_right_points(const LimitPartition& partition, const BoundedDivisions& bounded, ExactDivisions& exact,
                         Count& count) {
  for (PointOfDivision number = 0; number < partition.point_count(); ++number) {
    const DivisionPoint& point = partition.point(number);
    if (point.kind != DivisionPoint::Kind::kCrossing) continue;
    count.open += bounded.parameter(number).error < HUGE_VAL ? 0 : 1;
    expect_within(bounded.parameter(number), exact.parameter(number), bounded, count.crossings);
    count.turned += exact.parameter(number) < 0 ? 1 : 0;
    const auto decided = bounded.rounded(number);
    if (!decided) continue;
    EXPECT_EQ(*decided, rounded_point(exact.position(number)));
    ++count.decided;
  }
}

// Of the cells of the triangulation.
void expect_right_volumes(const VoronoiDiagram& diagram, const BoundedDivisions& bounded, Count& count) {
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) {
    const auto& v = diagram.delaunay().vertices(cell);
    const auto at = [&](std::size_t k) {
      return exact_vector(diagram.point(v[k])) - exact_vector(diagram.point(v[0]));
    };
    const auto e = at(1), d = at(2), w = at(3);
    expect_within(bounded.determinant(v), dot(e, cross(d, w)), bounded, count.determinants);
    const auto r = vertex_parameter(ApexPair<Rational>(e, d, w), d);
    expect_within(bounded.parameter_of_sphere(v[0], v[1], v[2], v[3]), Rational(r.num / r.den), bounded, count.spheres);
  }
}

TEST(BoundedDivisions, BoundsHoldTheExactNumbers) {
  CITES("FC-NUM-02", "FC-UNST-02");
  PortableRandom random(41);
  Count count;
  for (int k = 0; k < 240; ++k) {
    const int thinness = random.between(0, 26), unit = random.between(-300, 300);
    const FlowComplex complex(plate(30, thinness, unit, random));
    const VoronoiDiagram& diagram = complex.diagram();
    const LimitPartition& partition = LimitPartition::of(complex.limits());
    const BoundedDivisions bounded(diagram, partition);
    ExactDivisions exact(diagram, partition);
    expect_right_points(partition, bounded, exact, count);
    expect_right_volumes(diagram, bounded, count);
  }
  EXPECT_GT(count.crossings, 3000U);
  EXPECT_GT(count.turned, 1500U);
  EXPECT_GT(count.decided, 3000U);
  EXPECT_GT(count.determinants, 5000U);
  EXPECT_GT(count.spheres, 5000U);
}

// Polygons with more than three samples are left to exact numbers, and so is all that comes from them. Here they are
// arcs of circles, at whose chords they are obtuse.
TEST(BoundedDivisions, LargePolygonsAreLeftOpen) {
  CITES("FC-NUM-02");
  PortableRandom random(42);
  Count count;
  for (int k = 0; k < 800; ++k) {
    const auto coordinate = [&](int size) { return static_cast<double>(random.between(-size, size)); };
    std::vector<Point> rows;
    for (int arc = 0; arc < 3; ++arc) {
      const double x = coordinate(3), y = coordinate(3), z = coordinate(4);
      for (const auto& [u, v] : {std::pair{-4, 3}, {-3, 4}, {0, 5}, {3, 4}, {4, 3}}) rows.push_back({x + u, y + v, z});
    }
    for (int other = 0; other < 8; ++other) rows.push_back({coordinate(9), coordinate(9), coordinate(9)});
    const FlowComplex complex(rows);
    const LimitPartition& partition = LimitPartition::of(complex.limits());
    const BoundedDivisions bounded(complex.diagram(), partition);
    ExactDivisions exact(complex.diagram(), partition);
    expect_right_points(partition, bounded, exact, count);
  }
  EXPECT_GT(count.open, 5U);
  EXPECT_GT(count.crossings, 2000U);
}

}  // namespace
}  // namespace flowcert::morse::bounded_divisions_test
