// Lattice, cospherical and cocircular configurations; the right-angled ones are in
// right_angle_configurations.cpp.
//
// Guarantees: see configurations.h.
#include "fuzz/inputs/configurations.h"

#include <algorithm>
#include <utility>

#include "fuzz/inputs/sphere_points.h"

namespace flowcert::fuzz {
namespace {

using RawIndices = std::vector<std::size_t>;

// Bits 0 to 2 of the code are signs, the rest says which of the six orders.
IntegerPoint signed_permutation(IntegerPoint vector, std::size_t code) {
  std::sort(vector.begin(), vector.end());
  for (std::size_t step = (code / 8) % 6; step > 0; --step) {
    std::next_permutation(vector.begin(), vector.end());
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((code >> axis & 1U) != 0) {
      vector[axis] = -vector[axis];
    }
  }
  return vector;
}

IntegerPoints lattice(Integer width) {
  IntegerPoints all;
  for (Integer code = 0; code < width * width * width; ++code) {
    all.push_back({code / (width * width), code / width % width, code % width});
  }
  return all;
}

IntegerPoints lifted(IntegerPoints flat, Integer height) {
  for (IntegerPoint& point : flat) {
    point[2] = height;
  }
  return flat;
}

}  // namespace

rc::Gen<IntegerPoints> lattice_points(Integer width, std::size_t least, std::size_t most) {
  const IntegerPoints all = lattice(width);
  return rc::gen::map(list_of(least, most, raw_index()),
                      [all](const RawIndices& raw) { return at_raw_indices(all, raw); });
}

rc::Gen<IntegerPoints> signed_permutations(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](const RawIndices& codes, const IntegerPoint& vector) {
        IntegerPoints points;
        for (const std::size_t code : codes) {
          points.push_back(signed_permutation(vector, code));
        }
        return points;
      },
      list_of(least, most, raw_index()), integer_point(0, 7));
}

rc::Gen<IntegerPoints> points_of_a_sphere(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](const RawIndices& raw, Integer norm) { return at_raw_indices(sphere_points(norm), raw); },
      list_of(least, most, raw_index()), sphere_norm());
}

rc::Gen<IntegerPoints> box_corners(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](IntegerPoints corners, const IntegerPoint& sides) {
        for (auto& [x, y, z] : corners) {
          x *= sides[0];
          y *= sides[1];
          z *= sides[2];
        }
        return corners;
      },
      lattice_points(2, least, most), integer_point(1, 6));
}

rc::Gen<IntegerPoints> points_of_a_circle(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](const RawIndices& raw, Integer norm) { return at_raw_indices(circle_points(norm), raw); },
      list_of(least, most, raw_index()), circle_norm());
}

rc::Gen<IntegerPoints> points_of_two_circles(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](const std::pair<RawIndices, RawIndices>& raw, Integer lower_norm, Integer upper_norm,
         Integer height) {
        IntegerPoints points = at_raw_indices(circle_points(lower_norm), raw.first);
        const IntegerPoints upper = at_raw_indices(circle_points(upper_norm), raw.second);
        for (const IntegerPoint& point : lifted(upper, height)) {
          points.push_back(point);
        }
        return points;
      },
      rc::gen::pair(list_of(least, most, raw_index()), list_of(least, most, raw_index())), circle_norm(),
      circle_norm(), whole(1, 8));
}

rc::Gen<IntegerPoints> any_configuration() {
  const auto any = rc::gen::oneOf(lattice_points(2, 4, 8), lattice_points(3, 4, 8), signed_permutations(4, 8),
                                  points_of_a_sphere(4, 8), box_corners(4, 8), points_of_two_circles(2, 4),
                                  right_angles_12(), right_angles_23(), right_angles_13());
  return rc::gen::map(placed(any), distinct);
}

}  // namespace flowcert::fuzz
