// Families whose points span less than space: coplanar, cocircular and coplanar, collinear.
//
// Guarantees: see families.h; the points lie in one plane or on one line exactly, whatever its direction.
#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

IntegerPoint or_else(const IntegerPoint& vector, const IntegerPoint& instead) {
  return vector == IntegerPoint{0, 0, 0} ? instead : vector;
}

// Integer combinations of two vectors, in any plane.
rc::Gen<IntegerPoints> points_of_a_plane() {
  return rc::gen::apply(
      [](const IntegerPoints& coordinates, const IntegerPoint& u, const IntegerPoint& v,
         const IntegerPoint& origin) {
        IntegerPoints points;
        for (const auto& [s, t, unused] : coordinates) {
          points.push_back(
              plus(origin, plus(times(s, or_else(u, {1, 0, 0})), times(t, or_else(v, {0, 1, 0})))));
        }
        return points;
      },
      list_of(4, 12, integer_point(-2, 2)), integer_point(-3, 3), integer_point(-3, 3), integer_point(-3, 3));
}

rc::Gen<IntegerPoints> points_of_a_line() {
  return rc::gen::apply(
      [](const std::vector<Integer>& coordinates, const IntegerPoint& direction, const IntegerPoint& origin) {
        IntegerPoints points;
        for (const Integer t : coordinates) {
          points.push_back(plus(origin, times(t, or_else(direction, {1, 0, 0}))));
        }
        return points;
      },
      list_of(4, 10, whole(-9, 9)), integer_point(-3, 3), integer_point(-3, 3));
}

rc::Gen<Input> distinct_input(const rc::Gen<IntegerPoints>& points) {
  return input_of(rc::gen::map(points, distinct));
}

}  // namespace

std::vector<Family> flat_families() {
  return {
      {"coplanar-lattice",
       "points of a planar lattice in any plane",
       [] { return distinct_input(points_of_a_plane()); },
       {.four_points = 75, .kind12 = 15, .coplanar = 90, .tie = 15}},
      {"coplanar-circles",
       "points of one circle and of its centre's other circles, all in one tilted plane",
       [] {
         return distinct_input(placed(rc::gen::apply(
             [](IntegerPoints circle, const IntegerPoints& other) {
               circle.insert(circle.end(), other.begin(), other.end());
               return circle;
             },
             points_of_a_circle(4, 8), points_of_a_circle(0, 4))));
       },
       {.four_points = 90, .cluster = 60, .kind12 = 20, .coplanar = 100, .tie = 70}},
      {"collinear",
       "points of a line of any direction",
       [] { return distinct_input(points_of_a_line()); },
       {.four_points = 75, .collinear = 95}},
  };
}

}  // namespace flowcert::fuzz
