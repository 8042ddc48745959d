// Tables of the integer points of spheres and circles, made once, by looking at every point of a cube.
//
// Guarantees: see sphere_points.h.
#include "fuzz/inputs/sphere_points.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace flowcert::fuzz {
namespace {

using Table = std::array<IntegerPoints, static_cast<std::size_t>(kLargestTabulatedNorm) + 1>;

constexpr Integer kReach = 12;  // 13² > kLargestTabulatedNorm

Table points_by_norm(Integer z_reach) {
  Table table;
  for (Integer x = -kReach; x <= kReach; ++x) {
    for (Integer y = -kReach; y <= kReach; ++y) {
      for (Integer z = -z_reach; z <= z_reach; ++z) {
        const Integer norm = x * x + y * y + z * z;
        if (norm <= kLargestTabulatedNorm) {
          table[static_cast<std::size_t>(norm)].push_back({x, y, z});
        }
      }
    }
  }
  return table;
}

template <std::size_t kCount>
rc::Gen<Integer> one_of(const std::array<Integer, kCount>& norms) {
  return rc::gen::map(whole(0, static_cast<Integer>(kCount) - 1),
                      [norms](Integer index) { return norms[static_cast<std::size_t>(index)]; });
}

}  // namespace

const IntegerPoints& sphere_points(Integer norm) {
  static const Table table = points_by_norm(kReach);
  return table.at(static_cast<std::size_t>(norm));
}

const IntegerPoints& circle_points(Integer norm) {
  static const Table table = points_by_norm(0);
  return table.at(static_cast<std::size_t>(norm));
}

rc::Gen<Integer> circle_norm() { return one_of(std::array<Integer, 9>{1, 2, 5, 10, 25, 50, 65, 85, 130}); }

rc::Gen<Integer> sphere_norm() {
  return one_of(std::array<Integer, 12>{5, 6, 9, 14, 17, 26, 29, 41, 65, 89, 101, 146});
}

rc::Gen<std::size_t> raw_index() {
  return rc::gen::map(whole(0, 1'000'000), [](Integer index) { return static_cast<std::size_t>(index); });
}

const IntegerPoint& at_raw_index(const IntegerPoints& list, std::size_t raw) {
  return list[raw % list.size()];
}

IntegerPoints at_raw_indices(IntegerPoints list, const std::vector<std::size_t>& raw) {
  IntegerPoints chosen;
  for (const std::size_t index : raw) {
    if (list.empty()) {
      break;
    }
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(index % list.size());
    chosen.push_back(*at);
    list.erase(at);
  }
  return chosen;
}

IntegerPoints on_positive_side(const IntegerPoints& list, const IntegerPoint& normal) {
  IntegerPoints side;
  std::copy_if(list.begin(), list.end(), std::back_inserter(side),
               [&](const IntegerPoint& point) { return dot(normal, point) > 0; });
  return side;
}

IntegerPoint quarter_turn(const IntegerPoint& flat) { return {-flat[1], flat[0], 0}; }

IntegerPoints polygon_around_origin(Integer norm, std::size_t first, std::size_t third, bool square) {
  const IntegerPoint a = at_raw_index(circle_points(norm), first);
  const IntegerPoint b = quarter_turn(a);
  const IntegerPoint opposite = times(-1, a);
  IntegerPoints between;
  for (const IntegerPoint& point : circle_points(norm)) {
    if (dot(point, a) < 0 && dot(point, b) < 0) {
      between.push_back(point);
    }
  }
  if (square || between.empty()) {
    return {a, b, opposite, times(-1, b)};
  }
  return {a, b, at_raw_index(between, third)};
}

}  // namespace flowcert::fuzz
