// The box at which lines to infinity are cut, and convex polygons that may reach there.
//
// Guarantees: exact, but for the box's sides and the points where rays leave it. Those are the nearest doubles.
#pragma once

#include <cstdint>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"

namespace flowcert {

class ClipBox {
 public:
  // The bounding box of the points, scaled about its centre by the factor, which is at least 1. A side of length 0
  // counts as long as the longest one. Each side lies at the nearest double, or at the largest double if it would be
  // beyond all of them. There must be a point. Throws InvalidInput for a lesser factor.
  ClipBox(const PointSet& points, const Rational& factor);

  [[nodiscard]] const Point& low() const { return low_; }
  [[nodiscard]] const Point& high() const { return high_; }
  // Closed. What has an infinite coordinate is not in the box.
  [[nodiscard]] bool contains(const Point& position) const;
  // Where the ray from a position in the box leaves it, in the nearest doubles; so it is in the box. The direction must
  // not be zero.
  [[nodiscard]] Point exit(const Point& from, const RationalPoint& direction) const;

 private:
  Point low_, high_;
};

}  // namespace flowcert

namespace flowcert::io {

// ---- Convex polygons and straight lines, cut at half spaces ----
// Exact, for the given corners. Corners in the box stay what they are.

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
// What is between two corners of a box.
[[nodiscard]] std::vector<HalfSpace> half_spaces(const Point& low, const Point& high);

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
