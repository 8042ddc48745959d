// The box at which lines to infinity end: its sides, also of flat and of huge inputs, and where rays leave it.
#include "io/clip_box.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/cites.h"

namespace flowcert::clip_box_test {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

ClipBox box_of(const std::vector<Point>& points, const Rational& factor) { return {PointSet(points), factor}; }

TEST(ClipBox, IsScaledAboutTheCentre) {
  CITES("FC-NUM-02");
  const ClipBox box = box_of({{0, 0, 0}, {2, 4, 1}, {1, 1, 1}}, 3);
  EXPECT_EQ(box.low(), (Point{-2, -4, -1}));
  EXPECT_EQ(box.high(), (Point{4, 8, 2}));
  const ClipBox same = box_of({{0.1, -7, 1e-300}, {0.3, 4, 2e-300}}, 1);
  EXPECT_EQ(same.low(), (Point{0.1, -7, 1e-300}));
  EXPECT_EQ(same.high(), (Point{0.3, 4, 2e-300}));
}

TEST(ClipBox, ASideOfLengthZeroIsAsLongAsTheLongest) {
  const ClipBox plane = box_of({{0, 0, 5}, {2, 4, 5}}, 3);
  EXPECT_EQ(plane.low(), (Point{-2, -4, -1}));
  EXPECT_EQ(plane.high(), (Point{4, 8, 11}));
  const ClipBox line = box_of({{1, 1, 1}, {1, 3, 1}}, 2);
  EXPECT_EQ(line.low(), (Point{-1, 0, -1}));
  EXPECT_EQ(line.high(), (Point{3, 4, 3}));
  const ClipBox point = box_of({{1, 2, 3}, {1, 2, 3}}, 3);
  EXPECT_EQ(point.low(), (Point{1, 2, 3}));
  EXPECT_EQ(point.high(), (Point{1, 2, 3}));
}

TEST(ClipBox, WhatIsBeyondTheDoublesIsTheLargest) {
  const ClipBox box = box_of({{-1e308, 0, 0}, {1.5e308, 1, 1}}, 3);
  EXPECT_EQ(box.low().x, -kLargest);
  EXPECT_EQ(box.high().x, kLargest);
  EXPECT_TRUE(box.contains({kLargest, 0, 0}));
  EXPECT_FALSE(box.contains({HUGE_VAL, 0, 0}));
  EXPECT_EQ(box.exit({0, 0, 0}, {1, 0, 0}), (Point{kLargest, 0, 0}));
}

TEST(ClipBox, ALesserBoxIsRefused) {
  EXPECT_THROW((void)box_of({{0, 0, 0}, {1, 1, 1}}, Rational(999, 1000)), InvalidInput);
  EXPECT_NO_THROW((void)box_of({{0, 0, 0}, {1, 1, 1}}, 1));
}

TEST(ClipBox, RaysLeaveAtTheNearestSide) {
  const ClipBox box = box_of({{-1, -1, -1}, {1, 1, 1}}, 1);
  EXPECT_EQ(box.exit({0, 0, 0}, {1, 0, 0}), (Point{1, 0, 0}));
  EXPECT_EQ(box.exit({0, 0, 0}, {0, -7, 0}), (Point{0, -1, 0}));
  EXPECT_EQ(box.exit({0.5, 0, 0}, {1, 4, 0}), (Point{0.75, 1, 0}));
  EXPECT_EQ(box.exit({0, 0, 0}, {1, 1, -1}), (Point{1, 1, -1}));
  // A third is rounded once.
  EXPECT_EQ(box.exit({0, 0, 0}, {1, 3, 0}), (Point{1.0 / 3, 1, 0}));
  // From a side outwards there is no way, and along it there is.
  EXPECT_EQ(box.exit({1, 0.25, 0}, {1, 1, 0}), (Point{1, 0.25, 0}));
  EXPECT_EQ(box.exit({1, 0.25, 0}, {0, 1, 0}), (Point{1, 1, 0}));
}

}  // namespace
}  // namespace flowcert::clip_box_test
