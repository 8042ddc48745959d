// Configurations with a regular stationary point at the origin, built rather than searched for: among random
// integer points the kinds (2,3) and (1,3) are rare.
//
// Guarantees: see configurations.h. All boundary points have norm N and all others a norm above N, so the
// open ball is empty and the contact set of the origin is the boundary points.
#include <algorithm>
#include <utility>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/sphere_points.h"

namespace flowcert::fuzz {
namespace {

using RawIndices = std::vector<std::size_t>;

bool strictly_outside(const IntegerPoint& point, Integer norm) { return dot(point, point) > norm; }

// The boundary, and the others, pushed out of the ball where they are in it.
IntegerPoints with_far_points(IntegerPoints boundary, const IntegerPoints& others, Integer norm) {
  for (IntegerPoint point : others) {
    while (!strictly_outside(point, norm)) {
      point = point == IntegerPoint{0, 0, 0} ? IntegerPoint{1, 0, 0} : times(2, point);
    }
    boundary.push_back(point);
  }
  return boundary;
}

rc::Gen<IntegerPoints> further_points(std::size_t least) { return list_of(least, 4, integer_point(-12, 12)); }

void append(IntegerPoints& points, const IntegerPoints& list, const RawIndices& raw) {
  for (const IntegerPoint& point : at_raw_indices(list, raw)) {
    points.push_back(point);
  }
}

// A vector at a right angle to this one, which is not zero.
IntegerPoint any_normal(const IntegerPoint& point) {
  const IntegerPoint normal = cross(point, {0, 0, 1});
  return normal == IntegerPoint{0, 0, 0} ? IntegerPoint{1, 0, 0} : normal;
}

}  // namespace

rc::Gen<IntegerPoints> right_angles_12() {
  return rc::gen::apply(
      [](Integer norm, std::size_t first, const RawIndices& others, const IntegerPoints& far) {
        const IntegerPoint a = at_raw_index(circle_points(norm), first);
        IntegerPoints boundary{a, times(-1, a)};
        append(boundary, on_positive_side(circle_points(norm), quarter_turn(a)), others);
        return with_far_points(boundary, far, norm);
      },
      circle_norm(), raw_index(), list_of(1, 3, raw_index()), further_points(1));
}

rc::Gen<IntegerPoints> right_angles_23() {
  return rc::gen::apply(
      [](Integer norm, const std::pair<std::size_t, std::size_t>& corners, bool square,
         const RawIndices& others, const IntegerPoints& far) {
        IntegerPoints boundary = polygon_around_origin(norm, corners.first, corners.second, square);
        append(boundary, on_positive_side(sphere_points(norm), {0, 0, 1}), others);
        return with_far_points(boundary, far, norm);
      },
      circle_norm(), rc::gen::pair(raw_index(), raw_index()),
      rc::gen::map(whole(0, 2), [](Integer dice) { return dice == 2; }), list_of(1, 3, raw_index()),
      further_points(0));
}

rc::Gen<IntegerPoints> right_angles_13() {
  return rc::gen::apply(
      [](Integer norm, std::size_t first, const RawIndices& others, const IntegerPoints& far) {
        const IntegerPoint a = at_raw_index(sphere_points(norm), first);
        IntegerPoints boundary{a, times(-1, a)};
        append(boundary, on_positive_side(sphere_points(norm), any_normal(a)), others);
        return with_far_points(boundary, far, norm);
      },
      sphere_norm(), raw_index(), list_of(2, 4, raw_index()), further_points(0));
}

}  // namespace flowcert::fuzz
