// Tells that two edges, or two triangles, are congruent without a number that is not a double. Where values are equal,
// as on lattices, that is mostly why.
//
// Guarantees: exact. Those with equal keys have the same lengths of edges, and so circles of the same radius. Others
// may have them as well. There is no key where the difference of two coordinates is no double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "flowcert/point_set.h"
#include "geometry/double_double.h"

namespace flowcert::geometry {

// The absolute differences of coordinates, ascending, of each of three edges. A single edge has zeros behind its own.
using CongruenceKey = std::array<std::array<double, 3>, 3>;

// Takes two different points, or three. O(1).
[[nodiscard]] inline std::optional<CongruenceKey> congruence_key(std::span<const Point* const> points) {
  CongruenceKey key{};
  bool is_exact = true;
  const auto differences = [&is_exact](const Point& p, const Point& q) {
    std::array<double, 3> edge{};
    const std::array<DoubleDouble, 3> exact{DoubleDouble::sum(p.x, -q.x), DoubleDouble::sum(p.y, -q.y),
                                            DoubleDouble::sum(p.z, -q.z)};
    for (std::size_t k = 0; k < 3; ++k) {
      is_exact = is_exact && exact[k].low() == 0;
      edge[k] = std::fabs(exact[k].high());
    }
    std::ranges::sort(edge);
    return edge;
  };
  if (points.size() == 2) {
    key[0] = differences(*points[0], *points[1]);
  } else {
    key = {differences(*points[0], *points[1]), differences(*points[0], *points[2]),
           differences(*points[1], *points[2])};
    std::ranges::sort(key);
  }
  return is_exact ? std::optional(key) : std::nullopt;
}

}  // namespace flowcert::geometry
