// The families, group by group, and the table of all.
//
// Guarantees: those of families.h. What a group guarantees beyond that stands at its head.
#include "fuzz/inputs/families.h"

#include <array>
#include <cmath>
#include <ostream>
#include <tuple>
#include <utility>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/transformations.h"

namespace flowcert::fuzz {

// ---- Lattice families ----
// Small integer lattices, the few-points family, repeated rows, and points in general position to compare with.

namespace {

// Coordinates with all of a double's 53 bits, in [-1, 1].
rc::Gen<Input> points_in_general_position() {
  constexpr Integer kReach = Integer{1} << 53;
  return rc::gen::map(list_of(4, 12, integer_point(-kReach, kReach)),
                      [](const IntegerPoints& points) { return scaled(to_input(points), -53).value(); });
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

rc::Gen<IntegerPoints> further(std::size_t least, Integer reach) {
  return list_of(least, 4, integer_point(-reach, reach));
}

}  // namespace

static std::vector<Family> spherical_families() {
  return {
      {"signed-permutations",
       "signed permutations of one integer vector",
       [] { return distinct_input(signed_permutations(4, 12)); },
       {.four_points = 80, .cluster = 30, .kind12 = 30, .kind13 = 10, .degenerate = 50}},
      {"integer-sphere",
       "points of x²+y²+z²=N",
       [] { return distinct_input(points_of_a_sphere(4, 12)); },
       {.four_points = 90, .cluster = 30, .kind12 = 30, .kind13 = 5, .degenerate = 50}},
      {"sphere-and-others",
       "points of a turned integer sphere, and others inside, outside or on it",
       [] { return placed_distinct(rc::gen::apply(joined, points_of_a_sphere(4, 8), further(0, 9))); },
       {.four_points = 90, .cluster = 15, .kind12 = 30, .kind13 = 5, .degenerate = 40}},
      {"box-corners",
       "corners of a turned box, and others: every face a rectangle",
       [] { return placed_distinct(rc::gen::apply(joined, box_corners(4, 10), further(0, 6))); },
       {.four_points = 90, .cluster = 50, .kind12 = 70, .kind23 = 10, .kind13 = 25, .degenerate = 90}},
      {"tilted-circle",
       "cocircular points in a tilted plane, and others off it",
       [] { return placed_distinct(rc::gen::apply(joined, points_of_a_circle(4, 7), further(1, 11))); },
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

}  // namespace

static std::vector<Family> flat_families() {
  return {
      {"coplanar-lattice",
       "points of a planar lattice in any plane",
       [] { return distinct_input(points_of_a_plane()); },
       {.four_points = 75, .kind12 = 15, .coplanar = 90, .degenerate = 15}},
      {"coplanar-circles",
       "points of one circle and of its centre's other circles, all in one tilted plane",
       [] { return placed_distinct(rc::gen::apply(joined, points_of_a_circle(4, 8), points_of_a_circle(0, 4))); },
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

// ---- Scan families ----
// Families that look like scans: points of a sphere, a torus or a sheet are rounded to a grid, as by a depth sensor
// or a file with few digits.
//
// The curves are parametrised rationally (stereographic projection) and rounded in integer arithmetic: sines and
// cosines would differ between C libraries.
namespace {

// The parameter t = step / kSteps of the circle ((1-t²)/(1+t²), 2t/(1+t²)).
constexpr Integer kSteps = 8;

struct Fraction {
  Integer numerator;
  Integer denominator;  // positive
};

Fraction cosine(Integer step) { return {kSteps * kSteps - step * step, kSteps * kSteps + step * step}; }
Fraction sine(Integer step) { return {2 * kSteps * step, kSteps * kSteps + step * step}; }

IntegerPoint sphere_sample(Integer radius, Integer i, Integer j) {
  const Integer denominator = kSteps * kSteps + i * i + j * j;
  return {nearest_integer(radius * 2 * kSteps * i, denominator), nearest_integer(radius * 2 * kSteps * j, denominator),
          nearest_integer(radius * (denominator - 2 * kSteps * kSteps), denominator)};
}

IntegerPoint torus_sample(Integer core, Integer tube, Integer around, Integer across) {
  const Fraction c = cosine(around);
  const Fraction s = sine(around);
  const Fraction tube_c = cosine(across);
  const Fraction tube_s = sine(across);
  const Integer reach = core * tube_c.denominator + tube * tube_c.numerator;  // over tube_c.denominator
  return {nearest_integer(reach * c.numerator, tube_c.denominator * c.denominator),
          nearest_integer(reach * s.numerator, tube_c.denominator * s.denominator),
          nearest_integer(tube * tube_s.numerator, tube_s.denominator)};
}

template <typename Sample>
IntegerPoints samples(const IntegerPoints& parameters, const Sample& sample) {
  IntegerPoints points;
  for (const auto& [i, j, unused] : parameters) {
    points.push_back(sample(i, j));
  }
  return distinct(points);
}

rc::Gen<IntegerPoints> parameters(Integer reach) { return list_of(4, 12, integer_point(-reach, reach)); }

rc::Gen<IntegerPoints> sphere_scan() {
  return rc::gen::apply(
      [](const IntegerPoints& where, Integer radius) {
        return samples(where, [radius](Integer i, Integer j) { return sphere_sample(radius, i, j); });
      },
      parameters(20), whole(2, 6));
}

rc::Gen<IntegerPoints> torus_scan() {
  return rc::gen::apply(
      [](const IntegerPoints& where, Integer tube, Integer hole) {
        return samples(where, [&](Integer i, Integer j) { return torus_sample(tube + hole, tube, i, j); });
      },
      parameters(30), whole(1, 3), whole(1, 3));
}

// A quadratic height field over a grid, as a depth image is.
rc::Gen<IntegerPoints> sheet_scan() {
  return rc::gen::apply(
      [](const IntegerPoints& where, const IntegerPoint& form, Integer flatness) {
        return samples(where, [&](Integer x, Integer y) {
          const Integer height = form[0] * x * x + form[1] * x * y + form[2] * y * y;
          return IntegerPoint{x, y, nearest_integer(height, flatness)};
        });
      },
      parameters(2), integer_point(-2, 2), whole(3, 9));
}

}  // namespace

static std::vector<Family> scan_families() {
  return {
      {"sphere-scan",
       "points of a sphere rounded to a grid of a few cells",
       [] { return input_of(sphere_scan()); },
       {.four_points = 85, .cluster = 1, .kind12 = 35, .kind13 = 3, .degenerate = 35}},
      {"torus-scan",
       "points of a torus rounded to a grid",
       [] { return input_of(torus_scan()); },
       {.four_points = 85, .cluster = 1, .kind12 = 35, .kind13 = 3, .degenerate = 35}},
      {"sheet-scan",
       "a quadratic height field rounded to a grid",
       [] { return input_of(sheet_scan()); },
       {.four_points = 75, .cluster = 1, .kind12 = 45, .kind13 = 5, .degenerate = 45}},
  };
}

// ---- Rounding families ----
// Families that are degenerate up to rounding: exact configurations whose coordinates had to be rounded to
// doubles or to floats, and exact ones with a coordinate or two moved to the neighbouring double. A filter
// that is too sure of itself is wrong on these.
//
// Each coordinate is one correctly rounded division, so the doubles are the same
// everywhere.
namespace {

// A rational rotation of points. It is not representable, unless the quaternion's norm is a power of two.
rc::Gen<Input> rounded_rotation() {
  return rc::gen::apply(
      [](const IntegerPoints& points, const IntegerPoint& imaginary) {
        const IntegerRotation turn = rotation_of_quaternion({3, imaginary[0], imaginary[1], imaginary[2]});
        Input input;
        for (const IntegerPoint& point : points) {
          const auto& [x, y, z] = turn(point);
          const auto norm = static_cast<double>(turn.norm);
          input.rows.push_back(
              {static_cast<double>(x) / norm, static_cast<double>(y) / norm, static_cast<double>(z) / norm});
        }
        return input;
      },
      any_configuration(), integer_point(-3, 3));
}

double rounded_to_float(double value) { return static_cast<float>(value); }

// It does not convert coordinates in place: g++ 12.2 with -O3 leaves two thirds of them as they are then.
Input rounded_to_floats(const Input& input) {
  Input rounded;
  for (const auto& [x, y, z] : input.rows) {
    rounded.rows.push_back({rounded_to_float(x), rounded_to_float(y), rounded_to_float(z)});
  }
  return rounded;
}

// Rational points of the unit sphere, by stereographic projection.
rc::Gen<Input> rounded_sphere() {
  return rc::gen::map(list_of(4, 12, integer_point(-2000, 2000)), [](const IntegerPoints& parameters) {
    constexpr Integer kSteps = 1000;
    Input input;
    for (const auto& [i, j, unused] : parameters) {
      const Integer denominator = kSteps * kSteps + i * i + j * j;
      const auto divisor = static_cast<double>(denominator);
      input.rows.push_back({static_cast<double>(2 * kSteps * i) / divisor,
                            static_cast<double>(2 * kSteps * j) / divisor,
                            static_cast<double>(denominator - 2 * kSteps * kSteps) / divisor});
    }
    return input;
  });
}

// A row and a coordinate, each to be taken modulo their number, and 0, 1 or -1 steps.
using Nudge = std::tuple<Integer, Integer, int>;

rc::Gen<Nudge> nudge() {
  // One outcome of five is no step. The others are one step up or down, and shrink to no step.
  const auto steps = rc::gen::map(whole(0, 4), [](Integer dice) { return dice == 0 ? 0 : (dice % 2 == 1 ? 1 : -1); });
  return rc::gen::tuple(whole(0, 99), whole(0, 2), steps);
}

rc::Gen<Input> one_ulp_off() {
  return rc::gen::apply(
      [](const IntegerPoints& points, const std::vector<Nudge>& nudges) {
        const Input exact = to_input(points);
        Input input = exact;
        for (const auto& [row, axis, steps] : nudges) {
          const auto r = static_cast<std::size_t>(row) % exact.rows.size();
          const auto a = static_cast<std::size_t>(axis);
          // It starts from the exact coordinate, so two nudges of the same one do not add up.
          input.rows[r][a] = nudged(exact.rows[r][a], steps);
        }
        return input;
      },
      any_configuration(), list_of(1, 3, nudge()));
}

}  // namespace

static std::vector<Family> rounding_families() {
  return {
      {"rounded-sphere",
       "points of the unit sphere rounded to doubles",
       [] { return shrink_by_removing(rounded_sphere()); },
       {.four_points = 100}},
      {"rounded-rotation",
       "a degenerate integer configuration, rotated rationally, rounded to doubles",
       [] { return shrink_by_removing(rounded_rotation()); },
       {.four_points = 90}},
      {"rounded-to-float",
       "a degenerate integer configuration, rotated rationally, rounded to 32-bit floats",
       [] { return shrink_by_removing(rc::gen::map(rounded_rotation(), rounded_to_floats)); },
       {.four_points = 90}},
      {"one-ulp-off",
       "a degenerate integer configuration, up to three coordinates one ulp off",
       [] { return shrink_by_removing(one_ulp_off()); },
       {.four_points = 90, .cluster = 5, .kind12 = 25, .kind13 = 5, .degenerate = 30}},
  };
}

// ---- Magnitude families ----
// Families at the ends of the range of doubles: far from the origin, next to overflow, subnormal, and all of these in
// one input.
//
// Guarantees: all coordinates are finite, and configurations that are called exact stay so.
namespace {

// Powers of two up to 2^45, so that sums with a configuration's coordinates are far below 2^53.
rc::Gen<IntegerPoint> far_offset() {
  const auto power = rc::gen::map(whole(0, 45), [](Integer exponent) { return Integer{1} << exponent; });
  return rc::gen::apply([](const IntegerPoint& signs, Integer x, Integer y,
                           Integer z) { return IntegerPoint{signs[0] * x, signs[1] * y, signs[2] * z}; },
                        integer_point(-1, 1), power, power, power);
}

rc::Gen<Input> exact_far_away() {
  return rc::gen::apply(
      [](IntegerPoints points, const IntegerPoint& offset) {
        for (IntegerPoint& point : points) {
          point = plus(point, offset);
        }
        return to_input(points);
      },
      any_configuration(), far_offset());
}

// Thirds of a configuration, far away. The sum is rounded to what is left of the 53 bits.
rc::Gen<Input> rounded_far_away() {
  return rc::gen::apply(
      [](const IntegerPoints& points, const IntegerPoint& offset) {
        const Row shift = to_input({offset}).rows.front();
        Input input = to_input(points);
        for (Row& row : input.rows) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            row[axis] = row[axis] / 3 + shift[axis];
          }
        }
        return input;
      },
      any_configuration(), far_offset());
}

rc::Gen<Input> scaled_to_an_end() {
  constexpr std::array<int, 10> kExponents{-52, -1074, 1012, -1060, 1000, -1030, -540, 500, -1020, 970};
  return rc::gen::apply(
      [](const IntegerPoints& points, int exponent) { return scaled(to_input(points), exponent).value(); },
      any_configuration(), one_of(kExponents));
}

// 2^-997 is about 1e-300, (2^53 - 1) 2^971 is the largest double, and 2^-1074 is the smallest.
rc::Gen<double> any_magnitude() {
  constexpr std::array<int, 9> kExponents{0, -60, 60, -500, 500, -997, 971, -1074, 900};
  const auto small = whole(-3, 3);
  const auto full = whole(-((Integer{1} << 53) - 1), (Integer{1} << 53) - 1);
  const auto largest = rc::gen::just((Integer{1} << 53) - 1);
  return rc::gen::apply(
      [](Integer mantissa, int exponent) { return std::ldexp(static_cast<double>(mantissa), exponent); },
      rc::gen::weightedOneOf<Integer>({{8, small}, {3, full}, {1, largest}}),
      // About half of the exponents are 0, so that the different magnitudes meet in a coordinate or two.
      rc::gen::map(whole(0, 17),
                   [kExponents](Integer dice) { return kExponents[static_cast<std::size_t>(dice >= 9 ? 0 : dice)]; }));
}

rc::Gen<Input> mixed_magnitudes() {
  const auto row = rc::gen::apply([](double x, double y, double z) { return Row{x, y, z}; }, any_magnitude(),
                                  any_magnitude(), any_magnitude());
  return rc::gen::map(list_of(4, 9, row), [](const std::vector<Row>& rows) { return Input{rows}; });
}

// Ties at one magnitude, among points of another magnitude.
rc::Gen<Input> two_scales() {
  constexpr std::array<int, 8> kExponents{-3, 20, -60, 60, -600, 600, -1074, 1000};
  return rc::gen::apply(
      [](const IntegerPoints& points, const IntegerPoints& others, int exponent) {
        Input input = to_input(points);
        const Input beside = scaled(to_input(others), exponent).value();
        input.rows.insert(input.rows.end(), beside.rows.begin(), beside.rows.end());
        return input;
      },
      rc::gen::oneOf(lattice_points(3, 2, 5), box_corners(2, 5), right_angles_12()), lattice_points(2, 2, 4),
      one_of(kExponents));
}

}  // namespace

static std::vector<Family> magnitude_families() {
  return {
      {"far-away",
       "a degenerate integer configuration at an offset of up to 2^45, exactly",
       [] { return shrink_by_removing(exact_far_away()); },
       {.four_points = 90, .cluster = 20, .kind12 = 40, .kind23 = 10, .kind13 = 15, .degenerate = 70}},
      {"far-away-rounded",
       "a third of a degenerate configuration at an offset of up to 2^45, rounded",
       [] { return shrink_by_removing(rounded_far_away()); },
       {.four_points = 90, .degenerate = 15}},
      {"extreme-scale",
       "a degenerate integer configuration scaled by a power of two to the ends of the range",
       [] { return shrink_by_removing(scaled_to_an_end()); },
       {.four_points = 90, .cluster = 20, .kind12 = 40, .kind23 = 10, .kind13 = 15, .degenerate = 70}},
      {"two-scales",
       "a degenerate configuration, and a much smaller or larger one beside its origin",
       [] { return shrink_by_removing(two_scales()); },
       {.four_points = 90, .cluster = 2, .kind12 = 50, .degenerate = 50}},
      {"mixed-magnitudes",
       "coordinates from the smallest subnormal to the largest double in one input",
       [] { return shrink_by_removing(mixed_magnitudes()); },
       {.four_points = 95}},
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
