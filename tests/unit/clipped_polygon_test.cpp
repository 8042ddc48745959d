// Polygons and lines that may reach to infinity, cut at a box: exact corners, and which of them are kept.
#include <gtest/gtest.h>

#include <vector>

#include "io/clip_box.h"
#include "tests/cites.h"

namespace flowcert::io::clipped_polygon_test {
namespace {

constexpr std::uint32_t kCut = ProjectiveCorner::kNone;
using Corners = std::vector<ProjectiveCorner>;

// From -1 to 1.
ClipBox unit_box() { return {PointSet(std::vector<Point>{{-1, -1, -1}, {1, 1, 1}}), 1}; }

void expect_corners(const Corners& corners, const std::vector<RationalPoint>& positions,
                    const std::vector<std::uint32_t>& numbers) {
  ASSERT_EQ(corners.size(), positions.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    EXPECT_EQ(corners[k].x, positions[k]) << k;
    EXPECT_EQ(corners[k].w, 1) << k;
    EXPECT_EQ(corners[k].number, numbers[k]) << k;
  }
}

TEST(ClippedPolygon, KeepsWhatIsInTheBox) {
  CITES("FC-NUM-02");
  const Corners triangle = {finite_corner({0, 0, 0}, 7), finite_corner({1, 0, 0}, 8), finite_corner({0, 1, 0}, 9)};
  expect_corners(clipped(triangle, Outline::kClosed, unit_box()), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {7, 8, 9});
}

TEST(ClippedPolygon, CutsExactly) {
  CITES("FC-NUM-02");
  const Corners triangle = {finite_corner({0, 0, 0}, 0), finite_corner({3, 1, 0}, 1), finite_corner({0, 1, 0}, 2)};
  expect_corners(clipped(triangle, Outline::kClosed, unit_box()),
                 {{0, 0, 0}, {1, Rational(1) / 3, 0}, {1, 1, 0}, {0, 1, 0}}, {0, kCut, kCut, 2});
}

TEST(ClippedPolygon, CutsWhatReachesToInfinity) {
  CITES("FC-NUM-02");
  // A quarter of a plane, with its two directions; a strip, with one.
  const Corners quarter = {finite_corner({0, 0, 0}, 0), corner_at_infinity({1, 0, 0}, 1),
                           corner_at_infinity({0, 1, 0}, 2)};
  expect_corners(clipped(quarter, Outline::kClosed, unit_box()), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                 {0, kCut, kCut, kCut});
  const Corners strip = {finite_corner({0, 0, 0}, 0), corner_at_infinity({1, 0, 0}, 1),
                         finite_corner({0, Rational(1) / 2, 0}, 2)};
  expect_corners(clipped(strip, Outline::kClosed, unit_box()),
                 {{0, 0, 0}, {1, 0, 0}, {1, Rational(1) / 2, 0}, {0, Rational(1) / 2, 0}}, {0, kCut, kCut, 2});
  // Two directions along sides of the box, and a corner outside.
  const Corners quarter_from_afar = {finite_corner({-5, 0, 0}, 0), corner_at_infinity({1, 0, 0}, 1),
                                     corner_at_infinity({0, 1, 0}, 2)};
  expect_corners(clipped(quarter_from_afar, Outline::kClosed, unit_box()),
                 {{-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}}, {kCut, kCut, kCut, kCut});
}

TEST(ClippedPolygon, CutsLinesThatAreNotClosed) {
  CITES("FC-NUM-02");
  const Corners segment = {finite_corner({0, 0, 0}, 0), finite_corner({0, 0, 5}, 1)};
  expect_corners(clipped(segment, Outline::kOpen, unit_box()), {{0, 0, 0}, {0, 0, 1}}, {0, kCut});
  const Corners line = {corner_at_infinity({0, 0, -1}, 0), finite_corner({0, 0, 9}, 1),
                        corner_at_infinity({0, 0, 1}, 2)};
  expect_corners(clipped(line, Outline::kOpen, unit_box()), {{0, 0, -1}, {0, 0, 1}}, {kCut, kCut});
}

TEST(ClippedPolygon, WhatOnlyTouchesTheBoxIsNotInIt) {
  const Corners beside = {finite_corner({1, 0, 0}, 0), finite_corner({3, 0, 0}, 1), finite_corner({1, 1, 0}, 2)};
  EXPECT_TRUE(clipped(beside, Outline::kClosed, unit_box()).empty());
  // On a side of the box it is.
  const Corners on_side = {finite_corner({1, 0, 0}, 0), finite_corner({1, 1, 0}, 1), finite_corner({1, 0, 1}, 2)};
  expect_corners(clipped(on_side, Outline::kClosed, unit_box()), {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {0, 1, 2});
  const Corners far = {finite_corner({5, 0, 0}, 0), finite_corner({6, 0, 0}, 1), finite_corner({5, 1, 0}, 2)};
  EXPECT_TRUE(clipped(far, Outline::kClosed, unit_box()).empty());
}

}  // namespace
}  // namespace flowcert::io::clipped_polygon_test
