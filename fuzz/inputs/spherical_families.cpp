// Families of cospherical and cocircular integer points: the sets that a Delaunay triangulation cuts
// arbitrarily.
//
// Guarantees: see families.h; the points named as cospherical or cocircular are so exactly.
#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

rc::Gen<IntegerPoints> joined(const rc::Gen<IntegerPoints>& some, const rc::Gen<IntegerPoints>& others) {
  return rc::gen::apply(
      [](IntegerPoints all, const IntegerPoints& more) {
        all.insert(all.end(), more.begin(), more.end());
        return all;
      },
      some, others);
}

rc::Gen<Input> placed_distinct(const rc::Gen<IntegerPoints>& points) {
  return input_of(rc::gen::map(placed(points), distinct));
}

rc::Gen<IntegerPoints> further(std::size_t least, Integer reach) {
  return list_of(least, 4, integer_point(-reach, reach));
}

}  // namespace

std::vector<Family> spherical_families() {
  return {
      {"signed-permutations",
       "signed permutations of one integer vector",
       [] { return input_of(rc::gen::map(signed_permutations(4, 12), distinct)); },
       {.four_points = 80, .cluster = 30, .kind12 = 30, .kind13 = 10, .tie = 50}},
      {"integer-sphere",
       "points of x²+y²+z²=N",
       [] { return input_of(rc::gen::map(points_of_a_sphere(4, 12), distinct)); },
       {.four_points = 90, .cluster = 30, .kind12 = 30, .kind13 = 5, .tie = 50}},
      {"sphere-and-others",
       "points of a turned integer sphere, and others inside, outside or on it",
       [] { return placed_distinct(joined(points_of_a_sphere(4, 8), further(0, 9))); },
       {.four_points = 90, .cluster = 15, .kind12 = 30, .kind13 = 5, .tie = 40}},
      {"box-corners",
       "corners of a turned box, and others: every face a rectangle",
       [] { return placed_distinct(joined(box_corners(4, 10), further(0, 6))); },
       {.four_points = 90, .cluster = 50, .kind12 = 70, .kind23 = 10, .kind13 = 25, .tie = 90}},
      {"tilted-circle",
       "cocircular points in a tilted plane, and others off it",
       [] { return placed_distinct(joined(points_of_a_circle(4, 7), further(1, 11))); },
       {.four_points = 90, .cluster = 60, .kind12 = 20, .tie = 70}},
      {"two-circles",
       "points of two circles about one tilted axis",
       [] { return placed_distinct(points_of_two_circles(3, 6)); },
       {.four_points = 90, .cluster = 50, .kind12 = 50, .tie = 80}},
  };
}

}  // namespace flowcert::fuzz
