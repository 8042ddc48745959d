// Families with right angles on purpose: each input has a regular stationary point by construction, with the
// points around it in every position.
//
// Guarantees: see families.h.
#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

rc::Gen<Input> placed_distinct(const rc::Gen<IntegerPoints>& points) {
  return input_of(rc::gen::map(placed(points), distinct));
}

}  // namespace

std::vector<Family> right_angle_families() {
  return {
      {"right-angle-12",
       "a half circle with its diameter, and points outside its ball",
       [] { return placed_distinct(right_angles_12()); },
       {.four_points = 90, .cluster = 20, .kind12 = 100, .tie = 100}},
      {"right-angle-23",
       "a great-circle polygon, points of the sphere on one side, and points outside",
       [] { return placed_distinct(right_angles_23()); },
       {.four_points = 100, .cluster = 50, .kind23 = 100, .tie = 100}},
      {"right-angle-13",
       "a diameter of a sphere, points of the sphere on one side, and points outside",
       [] { return placed_distinct(right_angles_13()); },
       {.four_points = 100, .cluster = 25, .kind13 = 95, .tie = 95}},
      {"right-angles",
       "any of the three kinds of regular stationary point",
       [] {
         return placed_distinct(rc::gen::oneOf(right_angles_12(), right_angles_23(), right_angles_13()));
       },
       {.four_points = 90, .cluster = 30, .kind12 = 30, .kind23 = 20, .kind13 = 20, .tie = 99}},
  };
}

}  // namespace flowcert::fuzz
