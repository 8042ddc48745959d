#include "io/clip_box.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "geometry/ring.h"

namespace flowcert {

namespace {

constexpr std::array<double Point::*, 3> kAxes = {&Point::x, &Point::y, &Point::z};

// The nearest double, also of numbers beyond the largest one.
double clamped(const Rational& value) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  if (const auto nearest = nearest_double(value)) return *nearest;
  return value < 0 ? -kLargest : kLargest;
}

}  // namespace

ClipBox::ClipBox(const PointSet& points, const Rational& factor) {
  const geometry::IeeeDoubles ieee;
  FLOWCERT_REQUIRES(!points.empty());
  if (factor < 1) throw InvalidInput("the box of --clip is less than that of the input");
  Point low = points[0], high = points[0];
  for (const Point& point : points.points()) {
    for (const auto axis : kAxes) {
      low.*axis = std::min(low.*axis, point.*axis);
      high.*axis = std::max(high.*axis, point.*axis);
    }
  }
  const auto length = [&](double Point::* axis) { return Rational(high.*axis) - Rational(low.*axis); };
  const Rational longest = std::max({length(&Point::x), length(&Point::y), length(&Point::z)});
  for (const auto axis : kAxes) {
    const Rational center = (Rational(low.*axis) + Rational(high.*axis)) / 2;
    const Rational half = factor * (length(axis) > 0 ? length(axis) : longest) / 2;
    low_.*axis = clamped(center - half);
    high_.*axis = clamped(center + half);
  }
}

bool ClipBox::contains(const Point& position) const {
  const geometry::IeeeDoubles ieee;
  return std::ranges::all_of(
      kAxes, [&](const auto axis) { return position.*axis >= low_.*axis && position.*axis <= high_.*axis; });
}

Point ClipBox::exit(const Point& from, const RationalPoint& direction) const {
  const geometry::IeeeDoubles ieee;
  // In multiples of the direction.
  std::optional<Rational> way;
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    if (direction[k] == 0) continue;
    const auto axis = kAxes[k];
    const Rational to_side = Rational(direction[k] > 0 ? high_.*axis : low_.*axis) - Rational(from.*axis);
    const Rational along = to_side / direction[k];
    if (!way || along < *way) way = along;
  }
  FLOWCERT_REQUIRES(way && *way >= 0);
  Point end;
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    const auto axis = kAxes[k];
    end.*axis = clamped(Rational(from.*axis) + *way * direction[k]) + 0.0;
  }
  return end;
}

}  // namespace flowcert

namespace flowcert::io {

// ---- Convex polygons and straight lines ----
// Each half space cuts what the ones before have left (Sutherland and Hodgman).

namespace {

// Positive inside, 0 on the plane.
Rational height(const ProjectiveCorner& corner, const HalfSpace& half_space) {
  return dot(half_space.normal, corner.x) - half_space.offset * corner.w;
}

// Where the line between both meets the plane. One height is positive, the other one negative.
ProjectiveCorner crossing(const ProjectiveCorner& a, const Rational& height_of_a, const ProjectiveCorner& b,
                          const Rational& height_of_b) {
  const Rational u = abs(height_of_b), v = abs(height_of_a);
  return {u * a.x + v * b.x, u * a.w + v * b.w};
}

bool are_opposite(const ProjectiveCorner& a, const ProjectiveCorner& b) { return a.w == 0 && b.w == 0 && a.x == -b.x; }

// A half plane that is cut along its border has opposite ends there. A point of the cut gets between them: it lies on
// the way from a corner inside to one outside.
void part_opposite_ends(const std::vector<ProjectiveCorner>& corners, const std::vector<Rational>& heights,
                        std::vector<ProjectiveCorner>& kept) {
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (!are_opposite(kept[k], kept[(k + 1) % kept.size()])) continue;
    std::size_t inner = 0, outer = 0;
    while (heights[inner].sign() <= 0 || corners[inner].w == 0) ++inner;
    while (heights[outer].sign() >= 0) ++outer;
    kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                crossing(corners[inner], heights[inner], corners[outer], heights[outer]));
    return;
  }
}

}  // namespace

ProjectiveCorner finite_corner(const RationalPoint& position, std::uint32_t number) { return {position, 1, number}; }
ProjectiveCorner corner_at_infinity(const RationalPoint& direction, std::uint32_t number) {
  return {direction, 0, number};
}

std::vector<HalfSpace> half_spaces(const Point& low, const Point& high) {
  std::vector<HalfSpace> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    HalfSpace above{{0, 0, 0}, Rational(low.*kAxes[k])}, below{{0, 0, 0}, -Rational(high.*kAxes[k])};
    above.normal[k] = 1;
    below.normal[k] = -1;
    sides.push_back(std::move(above));
    sides.push_back(std::move(below));
  }
  return sides;
}

std::vector<ProjectiveCorner> cut(const std::vector<ProjectiveCorner>& corners, Outline outline,
                                  const HalfSpace& half_space) {
  std::vector<Rational> heights;
  heights.reserve(corners.size());
  for (const ProjectiveCorner& corner : corners) heights.push_back(height(corner, half_space));
  const auto is_below = [](const Rational& h) { return h < 0; };
  if (std::ranges::none_of(heights, is_below)) return corners;
  if (std::ranges::none_of(heights, [](const Rational& h) { return h > 0; })) return {};
  std::vector<ProjectiveCorner> kept;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!is_below(heights[k])) kept.push_back(corners[k]);
    const std::size_t next = (k + 1) % n;
    if (next == 0 && outline == Outline::kOpen) break;
    if (heights[k].sign() * heights[next].sign() >= 0) continue;
    kept.push_back(crossing(corners[k], heights[k], corners[next], heights[next]));
  }
  if (outline == Outline::kClosed) part_opposite_ends(corners, heights, kept);
  return kept;
}

std::vector<ProjectiveCorner> clipped(std::vector<ProjectiveCorner> corners, Outline outline, const ClipBox& box) {
  return clipped(std::move(corners), outline, half_spaces(box.low(), box.high()));
}

std::vector<ProjectiveCorner> clipped(std::vector<ProjectiveCorner> corners, Outline outline,
                                      const std::vector<HalfSpace>& half_spaces) {
  for (const HalfSpace& side : half_spaces) {
    if (corners.empty()) return corners;
    corners = cut(corners, outline, side);
  }
  for (ProjectiveCorner& corner : corners) {
    corner.x = Rational(1 / corner.w) * corner.x;
    corner.w = 1;
  }
  const auto is_same = [](const ProjectiveCorner& a, const ProjectiveCorner& b) { return a.x == b.x; };
  if (outline == Outline::kClosed) {
    merge_repeated(corners, is_same);
  } else {
    corners.erase(std::unique(corners.begin(), corners.end(), is_same), corners.end());
  }
  return corners;
}

}  // namespace flowcert::io
