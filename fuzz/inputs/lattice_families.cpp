// Families on small integer lattices, the few-points family, repeated rows, and points in general position to
// compare with.
//
// Guarantees: see families.h.
#include <cmath>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

// All of a double's 53 bits, in [-1, 1].
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

// Lattice points again and again, with zeros of either sign.
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

// All numbers alike, whatever the size.
rc::Gen<IntegerPoints> few_points() {
  return rc::gen::mapcat(rc::gen::noShrink(whole(0, 4)), [](Integer count) {
    const auto number = static_cast<std::size_t>(count);
    return rc::gen::oneOf(rc::gen::container<IntegerPoints>(number, integer_point(-1, 1)),
                          rc::gen::container<IntegerPoints>(number, integer_point(-4, 4)));
  });
}

Family lattice_family(Integer width, Promise promise) {
  return {"lattice-" + std::to_string(width),
          "distinct points of the lattice {0.." + std::to_string(width - 1) + "}^3",
          [width] { return input_of(lattice_points(width, 4, 12)); }, promise};
}

}  // namespace

std::vector<Family> lattice_families() {
  return {
      {"general-position",
       "random 53-bit coordinates in [-1, 1]",
       [] { return shrink_by_removing(points_in_general_position()); },
       {.four_points = 100}},
      lattice_family(
          2, {.four_points = 100, .cluster = 50, .kind12 = 65, .kind23 = 10, .kind13 = 25, .tie = 90}),
      lattice_family(3,
                     {.four_points = 100, .cluster = 10, .kind12 = 75, .kind23 = 5, .kind13 = 25, .tie = 80}),
      lattice_family(4,
                     {.four_points = 100, .cluster = 5, .kind12 = 60, .kind23 = 1, .kind13 = 15, .tie = 65}),
      {"few-points",
       "0 to 4 points with small integer coordinates",
       [] { return input_of(few_points()); },
       {.four_points = 10, .kind12 = 8, .coplanar = 10, .tie = 8}},
      {"duplicates",
       "lattice points, rows repeated, zeros of either sign",
       [] { return shrink_by_removing(repeated_rows()); },
       {.four_points = 80, .kind12 = 50, .kind13 = 8, .duplicates = 100, .tie = 50}},
  };
}

}  // namespace flowcert::fuzz
