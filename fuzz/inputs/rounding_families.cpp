// Families that are degenerate up to rounding: exact configurations whose coordinates had to be rounded to
// doubles or to floats, and exact ones with a coordinate or two moved to the neighbouring double. A filter
// that is too sure of itself is wrong on these.
//
// Guarantees: see families.h. Each coordinate is one correctly rounded division, so the doubles are the same
// everywhere.
#include <tuple>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/nudge.h"

namespace flowcert::fuzz {
namespace {

// Rotated by a rational rotation: not representable, unless the quaternion's norm is a power of two.
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

// Not a loop that converts coordinates in place: g++ 12.2 with -O3 leaves two thirds of them as they are.
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

// A row and a coordinate, both to be taken modulo their number, and 0, 1 or -1 steps.
using Nudge = std::tuple<Integer, Integer, int>;

rc::Gen<Nudge> nudge() {
  // Of five outcomes one is no step; the others are all up or down, and shrink to none.
  const auto steps =
      rc::gen::map(whole(0, 4), [](Integer dice) { return dice == 0 ? 0 : (dice % 2 == 1 ? 1 : -1); });
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
          // From the exact coordinate: two nudges that meet do not add up.
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
       {.four_points = 90, .cluster = 5, .kind12 = 25, .kind13 = 5, .tie = 30}},
  };
}

}  // namespace flowcert::fuzz
