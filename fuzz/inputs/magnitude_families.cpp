// Families at the ends of the range of doubles: far from the origin, next to overflow, subnormal, and all of
// it in one input.
//
// Guarantees: see families.h; all coordinates are finite, and configurations that are called exact stay so.
#include <array>
#include <cmath>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

// Powers of two, up to 2^45: with a configuration's coordinates, far below 2^53.
rc::Gen<IntegerPoint> far_offset() {
  const auto power = rc::gen::map(whole(0, 45), [](Integer exponent) { return Integer{1} << exponent; });
  return rc::gen::apply(
      [](const IntegerPoint& signs, Integer x, Integer y, Integer z) {
        return IntegerPoint{signs[0] * x, signs[1] * y, signs[2] * z};
      },
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

// Thirds of a configuration, far away: the sum is rounded to what is left of 53 bits.
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

// 2^-997 is about 1e-300, 2^996 about 1e300; (2^53 - 1) 2^971 is the largest double, 2^-1074 the smallest.
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
      // Exponent 0 at every other draw, so that the different magnitudes meet in a coordinate or two.
      rc::gen::map(whole(0, 17), [](Integer dice) { return dice >= 9 ? 0 : dice; }));
}

rc::Gen<Input> mixed_magnitudes() {
  const auto row = rc::gen::apply(
      [](double x, double y, double z) {
        return Row{x, y, z};
      },
      any_magnitude(), any_magnitude(), any_magnitude());
  return rc::gen::map(list_of(4, 9, row), [](const std::vector<Row>& rows) { return Input{rows}; });
}

// Ties at one magnitude among points of another.
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
       {.four_points = 90, .cluster = 20, .kind12 = 40, .kind23 = 10, .kind13 = 15, .tie = 70}},
      {"far-away-rounded",
       "a third of a degenerate configuration at an offset of up to 2^45, rounded",
       [] { return shrink_by_removing(rounded_far_away()); },
       {.four_points = 90, .tie = 15}},
      {"extreme-scale",
       "a degenerate integer configuration scaled by a power of two to the ends of the range",
       [] { return shrink_by_removing(scaled_to_an_end()); },
       {.four_points = 90, .cluster = 20, .kind12 = 40, .kind23 = 10, .kind13 = 15, .tie = 70}},
      {"two-scales",
       "a degenerate configuration, and a much smaller or larger one beside its origin",
       [] { return shrink_by_removing(two_scales()); },
       {.four_points = 90, .cluster = 2, .kind12 = 50, .tie = 50}},
      {"mixed-magnitudes",
       "coordinates from the smallest subnormal to the largest double in one input",
       [] { return shrink_by_removing(mixed_magnitudes()); },
       {.four_points = 95}},
  };
}

}  // namespace flowcert::fuzz
