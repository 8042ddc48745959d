// Cells side by side against tetrahedron_signs() and on_sphere(), to the bit, with the wide instructions and without
// them: the same signs, and certain of all of them exactly where that filter is. On a coarse grid the zeros are
// certain, too, and are those of exact arithmetic.
#include "geometry/tetrahedron_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::geometry::tetrahedron_lanes_test {
namespace {

using flowcert_tests::draw_cell;
using flowcert_tests::kTupleKinds;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

constexpr std::size_t kLanes = TetrahedronLanes::kLanes;

// A positively oriented cell, and four samples to compare with its sphere.
using CellAndSamples = std::array<Point, 8>;

TetrahedronPoints cell_of(const CellAndSamples& points) { return {&points[0], &points[1], &points[2], &points[3]}; }

struct Met {
  int known = 0, unknown = 0, off = 0, close = 0, exact = 0, exactly_on = 0, exactly_off = 0;
};

// Where the lane is exact it knows the sides that the one cell's filter leaves open.
void compare_signs(const TetrahedronLanes& lanes, std::size_t lane, const CellAndSamples& points,
                   const TetrahedronSigns& signs) {
  const TetrahedronSigns in_lane = lanes.signs(lane);
  EXPECT_EQ(in_lane.angle_negative, signs.angle_negative);
  EXPECT_EQ(in_lane.angle_zero, signs.angle_zero);
  EXPECT_EQ(in_lane.side_open, 0);
  for (unsigned facet = 0; facet < 4; ++facet) {
    const Sign side = side_exactly(cell_of(points), facet);
    EXPECT_EQ((in_lane.side_negative >> facet & 1) != 0, side == Sign::kNegative);
    EXPECT_EQ((in_lane.side_zero >> facet & 1) != 0, side == Sign::kZero);
  }
}

void compare_samples(const TetrahedronLanes& lanes, std::size_t lane, const CellAndSamples& points,
                     const CellSphere& sphere, Met& met) {
  for (std::size_t i = 0; i < 4; ++i) {
    FilterTally tally;
    const bool is_on = on_sphere(cell_of(points), sphere, points[4 + i], tally);
    const bool is_off = tally[Predicate::kCospherical].failures == 0;
    EXPECT_EQ((lanes.off_sphere(lane) >> i & 1u) != 0, is_off);
    ++(is_off ? met.off : met.close);
    if ((lanes.exactly_on_sphere(lane) >> i & 1u) != 0) {
      EXPECT_TRUE(is_on);
      ++met.exactly_on;
    }
    if ((lanes.exactly_off_sphere(lane) >> i & 1u) != 0) {
      EXPECT_FALSE(is_on);
      ++met.exactly_off;
    }
  }
}

void compare_lane(const TetrahedronLanes& lanes, std::size_t lane, const CellAndSamples& points, Met& met) {
  CellSphere sphere;
  FilterTally tally;
  const TetrahedronSigns signs = tetrahedron_signs(cell_of(points), sphere, tally);
  EXPECT_EQ(lanes.angle_failures(lane), tally[Predicate::kAngle].failures);
  EXPECT_EQ(lanes.side_failures(lane), tally[Predicate::kSideOfPlane].failures);
  const bool is_certain = tally[Predicate::kAngle].failures + tally[Predicate::kSideOfPlane].failures == 0;
  ASSERT_EQ(lanes.is_known(lane), is_certain || lanes.sphere(lane).is_exact);
  ++(lanes.is_known(lane) ? met.known : met.unknown);
  met.exact += lanes.sphere(lane).is_exact ? 1 : 0;
  if (lanes.is_known(lane)) compare_signs(lanes, lane, points, signs);
  ASSERT_EQ(lanes.sphere(lane).in_range, sphere.in_range);
  if (!sphere.in_range) return;
  EXPECT_EQ(lanes.sphere(lane).numerator.x, sphere.numerator.x);
  EXPECT_EQ(lanes.sphere(lane).numerator.y, sphere.numerator.y);
  EXPECT_EQ(lanes.sphere(lane).numerator.z, sphere.numerator.z);
  EXPECT_EQ(lanes.sphere(lane).determinant, sphere.determinant);
  EXPECT_EQ(lanes.sphere(lane).norm_product, sphere.norm_product);
  EXPECT_EQ(lanes.sphere(lane).norm_sum, sphere.norm_sum);
  compare_samples(lanes, lane, points, sphere, met);
}

// As many cells as there are lanes. scaled() changes each of their points.
template <class Scaled>
void compare_block(TetrahedronLanes& lanes, TupleKind kind, PortableRandom& random, Scaled scaled, Met& met) {
  std::vector<CellAndSamples> cells;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    cells.push_back(draw_cell<8>(kind, random));
    for (Point& p : cells.back()) p = scaled(p);
    lanes.set(lane, cell_of(cells.back()));
    for (std::size_t i = 0; i < 4; ++i) lanes.set_sample(lane, i, cells.back()[4 + i]);
  }
  lanes.compute();
  lanes.compare();
  for (std::size_t lane = 0; lane < kLanes; ++lane) compare_lane(lanes, lane, cells[lane], met);
}

TEST(TetrahedronLanesTest, AreTheOneCellsFilterToTheBit) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-VOR-01", "FC-NUM-01");
  for (const bool wide : {false, true}) {
    PortableRandom random(21);
    TetrahedronLanes lanes;
    lanes.use_wide_instructions(wide);
    Met met;
    for (const TupleKind kind : kTupleKinds) {
      for (int block = 0; block < 60; ++block) {
        compare_block(lanes, kind, random, [](const Point& p) { return p; }, met);
        if (HasFatalFailure()) return;
      }
    }
    EXPECT_GT(met.known, 1000);
    EXPECT_GT(met.unknown, 1000);
    EXPECT_GT(met.off, 1000);
    EXPECT_GT(met.close, 1000);
    EXPECT_EQ(met.exact + met.exactly_on + met.exactly_off, 0);
  }
}

// Points of coarse grids: doubles are exact for cells of up to kExactReach units, also where the grid is very fine or
// very coarse, and larger cells are left to the bounds.
TEST(TetrahedronLanesTest, KnowZerosOnACoarseGrid) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-VOR-01", "FC-NUM-01");
  for (const bool wide : {false, true}) {
    PortableRandom random(22);
    for (const int exponent : {0, -20, -130, 90}) {
      for (const double stretch : {1.0, 7.0, 60.0, 100.0}) {
        TetrahedronLanes lanes(std::ldexp(kExactReach, exponent));
        lanes.use_wide_instructions(wide);
        const auto scaled = [&](const Point& p) {
          const double factor = std::ldexp(stretch, exponent);
          return Point{p.x * factor, p.y * factor, p.z * factor};
        };
        Met met;
        for (const TupleKind kind : {TupleKind::kLattice, TupleKind::kSpherical}) {
          for (int block = 0; block < 40; ++block) compare_block(lanes, kind, random, scaled, met);
        }
        if (HasFatalFailure()) return;
        if (stretch <= 7) {
          EXPECT_GT(met.exact, 1000);
          EXPECT_GT(met.exactly_on, 1000);
          EXPECT_GT(met.exactly_off, 200);
        } else {
          EXPECT_GT(met.unknown, 100) << "cells beyond the reach";
        }
      }
    }
  }
}

// At the end of the reach: the longest vectors that are exact, nearly along each other and nearly at right angles, so
// that all forms are near their largest values or near zero.
TEST(TetrahedronLanesTest, AreExactUpToTheEndOfTheReach) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-NUM-01");
  PortableRandom random(23);
  TetrahedronLanes lanes(kExactReach);
  Met met;
  for (int block = 0; block < 400; ++block) {
    std::vector<CellAndSamples> cells;
    while (cells.size() < kLanes) {
      CellAndSamples points;
      points[0] = {0, 0, 0};
      for (std::size_t i = 1; i < points.size(); ++i) {
        const double size = kExactReach - 1 + 2 * random.coordinate(), u = random.coordinate(), v = random.coordinate();
        const double w = random.coordinate(), norm = std::sqrt(u * u + v * v + w * w);
        points[i] = {std::nearbyint(size * u / norm), std::nearbyint(size * v / norm), std::nearbyint(size * w / norm)};
      }
      const Sign sign = unfiltered_sign(Orientation{points[0], points[1], points[2], points[3]});
      if (sign == Sign::kZero) continue;
      if (sign == Sign::kNegative) std::swap(points[2], points[3]);
      cells.push_back(points);
      lanes.set(cells.size() - 1, cell_of(points));
      for (std::size_t i = 0; i < 4; ++i) lanes.set_sample(cells.size() - 1, i, points[4 + i]);
    }
    lanes.compute();
    lanes.compare();
    for (std::size_t lane = 0; lane < kLanes; ++lane) compare_lane(lanes, lane, cells[lane], met);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(met.exact, 500);
  EXPECT_GT(met.known, met.exact) << "cells just beyond the reach are known, too, but by the bounds";
}

// The lanes beside it hold a cell that overflows, one that underflows, and nothing at all.
TEST(TetrahedronLanesTest, DoNotDependOnTheirNeighbours) {
  CITES("FC-NUM-01");
  const CellAndSamples plain{{{0, 0, 0}, {3, 1, 0}, {0, 4, 1}, {1, 0, 5}, {9, 9, 9}, {1, 1, 1}, {-7, 0, 2}, {0, 0, 0}}};
  CellAndSamples huge = plain, tiny = plain;
  for (Point& p : huge) p = {p.x * 0x1p1000, p.y * 0x1p1000, p.z * 0x1p1000};
  for (Point& p : tiny) p = {p.x * 0x1p-1070, p.y * 0x1p-1070, p.z * 0x1p-1070};
  for (std::size_t at = 0; at < kLanes; ++at) {
    TetrahedronLanes lanes;
    std::vector<CellAndSamples> cells(kLanes, plain);
    cells[(at + 1) % kLanes] = huge;
    cells[(at + 2) % kLanes] = tiny;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (lane == (at + 3) % kLanes) continue;
      lanes.set(lane, cell_of(cells[lane]));
      for (std::size_t i = 0; i < 4; ++i) lanes.set_sample(lane, i, cells[lane][4 + i]);
    }
    lanes.compute();
    lanes.compare();
    Met met;
    compare_lane(lanes, at, plain, met);
    EXPECT_EQ(met.known, 1);
    EXPECT_EQ(lanes.off_sphere(at), 7u) << "the last sample is a vertex of the cell";
    EXPECT_FALSE(lanes.is_known((at + 1) % kLanes));
    EXPECT_FALSE(lanes.is_known((at + 2) % kLanes));
  }
}

}  // namespace
}  // namespace flowcert::geometry::tetrahedron_lanes_test
