// Each half space cuts what the ones before have left (Sutherland and Hodgman).
#include "io/clipped_polygon.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/rational_point.h"

namespace flowcert::io {

namespace {

// Positive inside, 0 on the plane.
Rational height(const ProjectiveCorner& corner, const HalfSpace& half_space) {
  const auto& [a, b, c] = half_space.normal;
  return a * corner.x[0] + b * corner.x[1] + c * corner.x[2] - half_space.offset * corner.w;
}

// Where the line between both meets the plane. One height is positive, the other one negative.
ProjectiveCorner crossing(const ProjectiveCorner& a, const Rational& height_of_a, const ProjectiveCorner& b,
                          const Rational& height_of_b) {
  const Rational u = abs(height_of_b), v = abs(height_of_a);
  ProjectiveCorner at;
  for (std::size_t k = 0; k < 3; ++k) at.x[k] = u * a.x[k] + v * b.x[k];
  at.w = u * a.w + v * b.w;
  return at;
}

bool are_opposite(const ProjectiveCorner& a, const ProjectiveCorner& b) {
  const auto is_negative = [](const Rational& x, const Rational& y) { return x == -y; };
  return a.w == 0 && b.w == 0 && std::ranges::equal(a.x, b.x, is_negative);
}

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

std::vector<HalfSpace> half_spaces(const ClipBox& box) {
  const RationalPoint low = geometry::exact_position(box.low()), high = geometry::exact_position(box.high());
  std::vector<HalfSpace> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    HalfSpace above{{0, 0, 0}, low[k]}, below{{0, 0, 0}, -high[k]};
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
  return clipped(std::move(corners), outline, half_spaces(box));
}

std::vector<ProjectiveCorner> clipped(std::vector<ProjectiveCorner> corners, Outline outline,
                                      const std::vector<HalfSpace>& half_spaces) {
  for (const HalfSpace& side : half_spaces) {
    if (corners.empty()) return corners;
    corners = cut(corners, outline, side);
  }
  for (ProjectiveCorner& corner : corners) {
    for (Rational& coordinate : corner.x) coordinate /= corner.w;
    corner.w = 1;
  }
  const auto is_same = [](const ProjectiveCorner& a, const ProjectiveCorner& b) { return a.x == b.x; };
  corners.erase(std::unique(corners.begin(), corners.end(), is_same), corners.end());
  while (outline == Outline::kClosed && corners.size() > 1 && is_same(corners.front(), corners.back())) {
    corners.pop_back();
  }
  return corners;
}

}  // namespace flowcert::io
