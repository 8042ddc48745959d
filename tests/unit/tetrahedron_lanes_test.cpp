// Cells side by side against tetrahedron_signs() and on_sphere(), to the bit, with the wide instructions and without
// them: the same signs, and certain of all of them exactly where that filter is.
#include "geometry/tetrahedron_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::geometry {
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::kTupleKinds;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

constexpr std::size_t kLanes = TetrahedronLanes::kLanes;

// A positively oriented cell, and four samples to compare with its sphere.
using CellAndSamples = std::array<Point, 8>;

CellAndSamples draw_cell(TupleKind kind, PortableRandom& random) {
  for (;;) {
    CellAndSamples points = draw_tuple<8>(kind, random);
    const Sign orientation = unfiltered_sign(Orientation{points[0], points[1], points[2], points[3]});
    if (orientation == Sign::kZero) continue;
    if (orientation == Sign::kNegative) std::swap(points[2], points[3]);
    return points;
  }
}

TetrahedronPoints cell_of(const CellAndSamples& points) { return {&points[0], &points[1], &points[2], &points[3]}; }

struct Met {
  int certain = 0, uncertain = 0, off = 0, close = 0;
};

void compare_lane(const TetrahedronLanes& lanes, std::size_t lane, const CellAndSamples& points, Met& met) {
  CellSphere sphere;
  FilterTally tally;
  const TetrahedronSigns signs = tetrahedron_signs(cell_of(points), sphere, tally);
  const bool is_certain = tally[Predicate::kAngle].failures + tally[Predicate::kSideOfPlane].failures == 0;
  ASSERT_EQ(lanes.is_certain(lane), is_certain);
  ++(is_certain ? met.certain : met.uncertain);
  if (is_certain) {
    EXPECT_EQ(lanes.signs(lane).angle_negative, signs.angle_negative);
    EXPECT_EQ(lanes.signs(lane).side_negative, signs.side_negative);
    EXPECT_EQ(signs.angle_zero | signs.side_zero | signs.side_open, 0);
  }
  ASSERT_EQ(lanes.sphere(lane).in_range, sphere.in_range);
  if (!sphere.in_range) return;
  EXPECT_EQ(lanes.sphere(lane).numerator.x, sphere.numerator.x);
  EXPECT_EQ(lanes.sphere(lane).numerator.y, sphere.numerator.y);
  EXPECT_EQ(lanes.sphere(lane).numerator.z, sphere.numerator.z);
  EXPECT_EQ(lanes.sphere(lane).determinant, sphere.determinant);
  EXPECT_EQ(lanes.sphere(lane).norm_product, sphere.norm_product);
  EXPECT_EQ(lanes.sphere(lane).norm_sum, sphere.norm_sum);
  for (std::size_t i = 0; i < 4; ++i) {
    FilterTally of_sphere;
    (void)on_sphere(cell_of(points), sphere, points[4 + i], of_sphere);
    const bool is_off = of_sphere[Predicate::kCospherical].failures == 0;
    EXPECT_EQ((lanes.off_sphere(lane) >> i & 1u) != 0, is_off);
    ++(is_off ? met.off : met.close);
  }
}

TEST(TetrahedronLanesTest, AreTheOneCellsFilterToTheBit) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-VOR-01", "FC-NUM-01");
  for (const bool wide : {false, true}) {
    PortableRandom random(21);
    TetrahedronLanes lanes;
    lanes.use_wide_instructions(wide);
    Met all;
    for (const TupleKind kind : kTupleKinds) {
      Met met;
      for (int block = 0; block < 60; ++block) {
        std::vector<CellAndSamples> cells;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          cells.push_back(draw_cell(kind, random));
          lanes.set(lane, cell_of(cells.back()));
          for (std::size_t i = 0; i < 4; ++i) lanes.set_sample(lane, i, cells.back()[4 + i]);
        }
        lanes.compute();
        lanes.compare();
        for (std::size_t lane = 0; lane < kLanes; ++lane) compare_lane(lanes, lane, cells[lane], met);
        if (HasFatalFailure()) return;
      }
      EXPECT_GT(met.certain + met.uncertain, 0);
      all.certain += met.certain, all.uncertain += met.uncertain, all.off += met.off, all.close += met.close;
    }
    EXPECT_GT(all.certain, 1000);
    EXPECT_GT(all.uncertain, 1000);
    EXPECT_GT(all.off, 1000);
    EXPECT_GT(all.close, 1000);
  }
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
    EXPECT_EQ(met.certain, 1);
    EXPECT_EQ(lanes.off_sphere(at), 7u) << "the last sample is a vertex of the cell";
    EXPECT_FALSE(lanes.is_certain((at + 1) % kLanes));
    EXPECT_FALSE(lanes.is_certain((at + 2) % kLanes));
  }
}

}  // namespace
}  // namespace flowcert::geometry
