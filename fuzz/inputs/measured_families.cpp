// Families of measured and rounded inputs: scans, roundings, and the ends of the range of doubles.
//
// Guarantees: those of families.h. What a group guarantees beyond that stands at its head.
#include <array>
#include <cmath>
#include <ostream>
#include <tuple>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

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

std::vector<Family> scan_families() {
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

std::vector<Family> rounding_families() {
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
      [kExponents](const IntegerPoints& points, Integer which) {
        Input input = to_input(points);
        for (Row& row : input.rows) {
          for (double& coordinate : row) {
            coordinate = std::ldexp(coordinate, kExponents[static_cast<std::size_t>(which)]);
          }
        }
        return input;
      },
      any_configuration(), whole(0, static_cast<Integer>(kExponents.size()) - 1));
}

// 2^-997 is about 1e-300, (2^53 - 1) 2^971 is the largest double, and 2^-1074 is the smallest.
rc::Gen<double> any_magnitude() {
  constexpr std::array<int, 9> kExponents{0, -60, 60, -500, 500, -997, 971, -1074, 900};
  const auto small = whole(-3, 3);
  const auto full = whole(-((Integer{1} << 53) - 1), (Integer{1} << 53) - 1);
  const auto largest = rc::gen::just((Integer{1} << 53) - 1);
  return rc::gen::apply(
      [kExponents](Integer mantissa, Integer which) {
        return std::ldexp(static_cast<double>(mantissa), kExponents[static_cast<std::size_t>(which)]);
      },
      rc::gen::weightedOneOf<Integer>({{8, small}, {3, full}, {1, largest}}),
      // About half of the exponents are 0, so that the different magnitudes meet in a coordinate or two.
      rc::gen::map(whole(0, 17), [](Integer dice) { return dice >= 9 ? 0 : dice; }));
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
      [kExponents](const IntegerPoints& points, const IntegerPoints& others, Integer which) {
        Input input = to_input(points);
        for (Row row : to_input(others).rows) {
          for (double& coordinate : row) {
            coordinate = std::ldexp(coordinate, kExponents[static_cast<std::size_t>(which)]);
          }
          input.rows.push_back(row);
        }
        return input;
      },
      rc::gen::oneOf(lattice_points(3, 2, 5), box_corners(2, 5), right_angles_12()), lattice_points(2, 2, 4),
      whole(0, static_cast<Integer>(kExponents.size()) - 1));
}

}  // namespace

std::vector<Family> magnitude_families() {
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

}  // namespace flowcert::fuzz
