// Each half space cuts what the ones before have left (Sutherland and Hodgman).
#include "io/clipped_polygon.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/rational_point.h"
#include "geometry/ring.h"

namespace flowcert::io {

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

std::vector<HalfSpace> half_spaces(const ClipBox& box) {
  const RationalPoint low = exact_position(box.low()), high = exact_position(box.high());
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
