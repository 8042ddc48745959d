// The families, group by group, and the table of all.
//
// Guarantees: those of families.h. What a group guarantees beyond that stands at its head.
#include "fuzz/inputs/families.h"

#include <cmath>
#include <ostream>
#include <utility>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// ---- Lattice families ----
// Small integer lattices, the few-points family, repeated rows, and points in general position to compare with.

namespace {

// Coordinates with all of a double's 53 bits, in [-1, 1].
rc::Gen<Input> points_in_general_position() {
  constexpr Integer kReach = Integer{1} << 53;
  return rc::gen::map(list_of(4, 12, integer_point(-kReach, kReach)), [](const IntegerPoints& points) {
    Input input = to_input(points);
    for (Row& row : input.rows) {
      for (double& coordinate : row) {
        coordinate = std::ldexp(coordinate, -53);
      }
    }
    return input;
  });
}

// Lattice points that are repeated, with zeros of either sign.
rc::Gen<Input> repeated_rows() {
  using Repeat = std::pair<Integer, Integer>;
  return rc::gen::apply(
      [](const IntegerPoints& points, const std::vector<Repeat>& repeats) {
        Input input = to_input(points);
        for (const auto& [row, sign] : repeats) {
          Row again = input.rows[static_cast<std::size_t>(row) % input.rows.size()];
          for (double& coordinate : again) {
            if (coordinate == 0 && sign != 0) {
              coordinate = -0.0;
            }
          }
          input.rows.push_back(again);
        }
        return input;
      },
      list_of(4, 8, integer_point(-1, 2)), list_of(1, 4, rc::gen::pair(whole(0, 99), whole(0, 1))));
}

// All numbers of points are equally likely, at any size.
rc::Gen<IntegerPoints> few_points() {
  return rc::gen::mapcat(rc::gen::noShrink(whole(0, 4)), [](Integer count) {
    const auto number = static_cast<std::size_t>(count);
    return rc::gen::oneOf(rc::gen::container<IntegerPoints>(number, integer_point(-1, 1)),
                          rc::gen::container<IntegerPoints>(number, integer_point(-4, 4)));
  });
}

Family lattice_family(Integer width, Promise promise) {
  return {"lattice-" + std::to_string(width), "distinct points of the lattice {0.." + std::to_string(width - 1) + "}^3",
          [width] { return input_of(lattice_points(width, 4, 12)); }, promise};
}

}  // namespace

static std::vector<Family> lattice_families() {
  return {
      {"general-position",
       "random 53-bit coordinates in [-1, 1]",
       [] { return shrink_by_removing(points_in_general_position()); },
       {.four_points = 100}},
      lattice_family(2,
                     {.four_points = 100, .cluster = 50, .kind12 = 65, .kind23 = 10, .kind13 = 25, .degenerate = 90}),
      lattice_family(3, {.four_points = 100, .cluster = 10, .kind12 = 75, .kind23 = 5, .kind13 = 25, .degenerate = 80}),
      lattice_family(4, {.four_points = 100, .cluster = 5, .kind12 = 60, .kind23 = 1, .kind13 = 15, .degenerate = 65}),
      {"few-points",
       "0 to 4 points with small integer coordinates",
       [] { return input_of(few_points()); },
       {.four_points = 10, .kind12 = 8, .coplanar = 10, .degenerate = 8}},
      {"duplicates",
       "lattice points, rows repeated, zeros of either sign",
       [] { return shrink_by_removing(repeated_rows()); },
       {.four_points = 80, .kind12 = 50, .kind13 = 8, .duplicates = 100, .degenerate = 50}},
  };
}

// ---- Spherical families ----
// Families of cospherical and cocircular integer points: the sets that a Delaunay triangulation cuts
// arbitrarily.
//
// Guarantees: the points named as cospherical or cocircular are so exactly.
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

static std::vector<Family> spherical_families() {
  return {
      {"signed-permutations",
       "signed permutations of one integer vector",
       [] { return input_of(rc::gen::map(signed_permutations(4, 12), distinct)); },
       {.four_points = 80, .cluster = 30, .kind12 = 30, .kind13 = 10, .degenerate = 50}},
      {"integer-sphere",
       "points of x²+y²+z²=N",
       [] { return input_of(rc::gen::map(points_of_a_sphere(4, 12), distinct)); },
       {.four_points = 90, .cluster = 30, .kind12 = 30, .kind13 = 5, .degenerate = 50}},
      {"sphere-and-others",
       "points of a turned integer sphere, and others inside, outside or on it",
       [] { return placed_distinct(joined(points_of_a_sphere(4, 8), further(0, 9))); },
       {.four_points = 90, .cluster = 15, .kind12 = 30, .kind13 = 5, .degenerate = 40}},
      {"box-corners",
       "corners of a turned box, and others: every face a rectangle",
       [] { return placed_distinct(joined(box_corners(4, 10), further(0, 6))); },
       {.four_points = 90, .cluster = 50, .kind12 = 70, .kind23 = 10, .kind13 = 25, .degenerate = 90}},
      {"tilted-circle",
       "cocircular points in a tilted plane, and others off it",
       [] { return placed_distinct(joined(points_of_a_circle(4, 7), further(1, 11))); },
       {.four_points = 90, .cluster = 60, .kind12 = 20, .degenerate = 70}},
      {"two-circles",
       "points of two circles about one tilted axis",
       [] { return placed_distinct(points_of_two_circles(3, 6)); },
       {.four_points = 90, .cluster = 50, .kind12 = 50, .degenerate = 80}},
  };
}

// ---- Flat families ----
// Families whose points span less than space: coplanar, cocircular and coplanar, collinear.
//
// Guarantees: the points lie in one plane or on one line exactly, whatever its direction.
namespace {

IntegerPoint or_else(const IntegerPoint& vector, const IntegerPoint& instead) {
  return vector == IntegerPoint{0, 0, 0} ? instead : vector;
}

// Integer combinations of two vectors, in any plane.
rc::Gen<IntegerPoints> points_of_a_plane() {
  return rc::gen::apply(
      [](const IntegerPoints& coordinates, const IntegerPoint& u, const IntegerPoint& v, const IntegerPoint& origin) {
        IntegerPoints points;
        for (const auto& [s, t, unused] : coordinates) {
          points.push_back(plus(origin, plus(times(s, or_else(u, {1, 0, 0})), times(t, or_else(v, {0, 1, 0})))));
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

rc::Gen<Input> distinct_input(const rc::Gen<IntegerPoints>& points) { return input_of(rc::gen::map(points, distinct)); }

}  // namespace

static std::vector<Family> flat_families() {
  return {
      {"coplanar-lattice",
       "points of a planar lattice in any plane",
       [] { return distinct_input(points_of_a_plane()); },
       {.four_points = 75, .kind12 = 15, .coplanar = 90, .degenerate = 15}},
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
       {.four_points = 90, .cluster = 60, .kind12 = 20, .coplanar = 100, .degenerate = 70}},
      {"collinear",
       "points of a line of any direction",
       [] { return distinct_input(points_of_a_line()); },
       {.four_points = 75, .collinear = 95}},
  };
}

// ---- Right angle families ----
// Families with right angles on purpose: each input has a regular stationary point by construction, with the
// points around it in every position.
static std::vector<Family> right_angle_families() {
  return {
      {"right-angle-12",
       "a half circle with its diameter, and points outside its ball",
       [] { return placed_distinct(right_angles_12()); },
       {.four_points = 90, .cluster = 20, .kind12 = 100, .degenerate = 100}},
      {"right-angle-23",
       "a great-circle polygon, points of the sphere on one side, and points outside",
       [] { return placed_distinct(right_angles_23()); },
       {.four_points = 100, .cluster = 50, .kind23 = 100, .degenerate = 100}},
      {"right-angle-13",
       "a diameter of a sphere, points of the sphere on one side, and points outside",
       [] { return placed_distinct(right_angles_13()); },
       {.four_points = 100, .cluster = 25, .kind13 = 95, .degenerate = 95}},
      {"right-angles",
       "any of the three kinds of regular stationary point",
       [] { return placed_distinct(rc::gen::oneOf(right_angles_12(), right_angles_23(), right_angles_13())); },
       {.four_points = 90, .cluster = 30, .kind12 = 30, .kind23 = 20, .kind13 = 20, .degenerate = 99}},
  };
}

// ---- Orbit families ----
// Families made for the flow: orbits that cross many facets one after the other, facets of many sides, and orbits
// that run exactly along Voronoi edges or into Voronoi vertices.
//
// Guarantees: those of configurations.h. Some families have larger members in large_configurations.h.
static std::vector<Family> orbit_families() {
  return {
      {"long-cascade",
       "two combs that lean away from each other: the flow between them crosses facet after facet",
       [] { return placed_distinct(opening_combs()); },
       {.four_points = 100}},
      {"half-shell",
       "a half sphere, half cylinder or paraboloid rounded to a grid, open at the top",
       [] { return placed_distinct(open_shell()); },
       {.four_points = 90, .kind12 = 20, .degenerate = 20}},
      {"high-degree-facet",
       "an edge, and neighbours of it on a circle around it, off centre, or close to such a circle",
       [] { return placed_distinct(rc::gen::oneOf(neighbours_on_a_circle(), neighbours_near_a_circle())); },
       {.four_points = 100, .kind12 = 8, .degenerate = 9}},
      {"right-angle-chain",
       "right triangles about one axis: the flow runs up along their Voronoi edges",
       [] { return placed_distinct(rings_of_right_triangles()); },
       {.four_points = 100, .cluster = 8, .kind12 = 100, .degenerate = 100}},
      {"through-vertex",
       "points symmetric to an axis or to two planes, where the flow across facets runs into Voronoi "
       "vertices",
       [] {
         return placed_distinct(rc::gen::weightedOneOf<IntegerPoints>({{3, rings_of_pairs()}, {1, mirrored_points()}}));
       },
       {.four_points = 95, .cluster = 65, .kind12 = 30, .degenerate = 75}},
  };
}

// ---- The table ----
// Names are unique (families_test checks it), so that a report can name an input
// by family, seed and size.
namespace {

std::vector<Family> all_groups() {
  std::vector<Family> all;
  for (auto* group : {lattice_families, spherical_families, flat_families, right_angle_families, scan_families,
                      orbit_families, rounding_families, magnitude_families}) {
    for (Family& family : group()) {
      all.push_back(std::move(family));
    }
  }
  return all;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Family& family) { return out << family.name; }

const std::vector<Family>& families() {
  static const std::vector<Family> table = all_groups();
  return table;
}

Input draw(const Family& family, std::uint64_t seed, int size) {
  return family.generate()(rc::Random(seed), size).value();
}

}  // namespace flowcert::fuzz
