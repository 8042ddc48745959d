// Convex polygons and straight lines that may reach to infinity, cut at a box.
//
// Guarantees: exact, for the given corners. Corners in the box stay what they are.
#pragma once

#include <cstdint>
#include <vector>

#include "io/clip_box.h"
#include "io/layer.h"

namespace flowcert::io {

// The point x / w, or where w = 0 the end at infinity in the direction x.
struct ProjectiveCorner {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  RationalPoint x;
  Rational w;
  std::uint32_t number = kNone;  // the caller's; kNone where the box cuts
};

[[nodiscard]] ProjectiveCorner finite_corner(const RationalPoint& position, std::uint32_t number);
[[nodiscard]] ProjectiveCorner corner_at_infinity(const RationalPoint& direction, std::uint32_t number);

// Points <x, normal> >= offset.
struct HalfSpace {
  RationalPoint normal;
  Rational offset;
};
[[nodiscard]] std::vector<HalfSpace> half_spaces(const ClipBox& box);

enum class Outline : bool { kOpen, kClosed };

// What is in a half space. Two neighbours at infinity must not be opposite, and will not be. Empty if it only touches
// the half space.
[[nodiscard]] std::vector<ProjectiveCorner> cut(const std::vector<ProjectiveCorner>& corners, Outline outline,
                                                const HalfSpace& half_space);
// What is in all half spaces, whose intersection is bounded: finite corners, with w = 1. Neighbours are different.
[[nodiscard]] std::vector<ProjectiveCorner> clipped(std::vector<ProjectiveCorner> corners, Outline outline,
                                                    const std::vector<HalfSpace>& half_spaces);
// What is in the box.
[[nodiscard]] std::vector<ProjectiveCorner> clipped(std::vector<ProjectiveCorner> corners, Outline outline,
                                                    const ClipBox& box);

}  // namespace flowcert::io
