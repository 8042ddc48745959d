#include "certify/closed_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "certify/claimed_geometry.h"
#include "certify/layer.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

// Whether the ray from x meets the triangle. Nothing if it meets an edge, or could.
std::optional<bool> is_met(const std::array<Point, 3>& triangle, const RationalPoint& x,
                           const RationalPoint& direction) {
  std::array<RationalPoint, 3> from;
  for (std::size_t k = 0; k < 3; ++k) from.at(k) = exact_position(triangle.at(k)) - x;
  std::array<int, 3> signs{};
  for (std::size_t k = 0; k < 3; ++k) {
    signs.at(k) = dot(direction, cross(from.at(k), from.at((k + 1) % 3))).sign();
  }
  const auto [least, greatest] = std::ranges::minmax(signs);
  if (least < 0 && greatest > 0) return false;
  if (std::ranges::count(signs, 0) > 0) return std::nullopt;
  // The line meets it, in front of x or behind.
  return dot(from[0], cross(from[1], from[2])).sign() == least;
}

}  // namespace

ClosedTriangles::ClosedTriangles(std::vector<std::array<Point, 3>> triangles) : triangles_(std::move(triangles)) {
  for (const std::array<Point, 3>& triangle : triangles_) {
    const auto a = triangle[0].coordinates(), b = triangle[1].coordinates(), c = triangle[2].coordinates();
    Box box{};
    for (std::size_t k = 0; k < 3; ++k)
      std::tie(box.low.at(k), box.high.at(k)) = std::minmax({a.at(k), b.at(k), c.at(k)});
    boxes_.push_back(box);
  }
}

bool ClosedTriangles::encloses(const RationalPoint& x) const {
  const std::array<double, 3> rounded = as_doubles(x);
  std::array<double, 3> below{}, above{};
  for (std::size_t k = 0; k < 3; ++k) {
    below.at(k) = std::nextafter(rounded.at(k), -HUGE_VAL);
    above.at(k) = std::nextafter(rounded.at(k), HUGE_VAL);
  }
  // Along an axis most triangles are beside the ray.
  const auto is_beside = [&](const Box& box, std::size_t k) {
    return box.high.at(k) < below.at(k) || above.at(k) < box.low.at(k);
  };
  const auto parity = [&](const RationalPoint& direction) -> std::optional<bool> {
    bool is_odd = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      bool is_passed = false;
      for (std::size_t k = 0; k < 3; ++k) is_passed = is_passed || (direction.at(k) == 0 && is_beside(boxes_[t], k));
      if (is_passed) continue;
      const auto met = is_met(triangles_[t], x, direction);
      if (!met) return std::nullopt;
      is_odd = is_odd != *met;
    }
    return is_odd;
  };
  for (const RationalPoint& axis : {RationalPoint{0, 0, 1}, RationalPoint{0, 1, 0}, RationalPoint{1, 0, 0}}) {
    if (const auto found = parity(axis)) return *found;
  }
  // An edge whose line has x excludes no direction, and any other one excludes two of these at most.
  for (int k = 1;; ++k) {
    if (const auto found = parity({1, k, k * k})) return *found;
  }
}

}  // namespace flowcert::certify
