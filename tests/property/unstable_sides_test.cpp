// The sides of index-2 points in other coordinates and under other names (FC-FLOW-11).
//
// Guarantees: exact. The limits of both sides are compared by their contact sets. The test fails too when too few
// points had different limits, or when hardly any sides were swapped.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "oracle/exact_geometry.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"
#include "tests/property/transformed_answers.h"
#include "tests/transformed_inputs.h"

namespace flowcert::property::unstable_sides_test {
namespace {

constexpr int kInputsPerFamily = 12;

using Names = std::vector<std::size_t>;
// The contact set of a limit; none for infinity.
using Limit = std::optional<Names>;

// The limits of side 0 and side 1, by contact set.
using Sides = std::map<Names, std::array<Limit, 2>>;

Names contact_of(const FlowComplex& complex, std::size_t record) {
  const auto contact = complex.stationary().contact(record);
  return {contact.begin(), contact.end()};
}

Sides sides_of(const fuzz::Input& input) {
  const FlowComplex complex(point_set_of(input));
  Sides sides;
  for (std::size_t k = 0; k < complex.unstable().size(); ++k) {
    std::array<Limit, 2> limits;
    for (std::size_t side = 0; side < 2; ++side) {
      if (const auto limit = complex.unstable().limit(k, side)) limits.at(side) = contact_of(complex, *limit);
    }
    sides[contact_of(complex, complex.unstable().saddle(k))] = limits;
  }
  return sides;
}

struct Totals {
  std::size_t points = 0, different = 0, swapped = 0;
};

bool is_reflection(const fuzz::AxisMap& map) {
  const bool is_odd = (map.axis[0] > map.axis[1]) != ((map.axis[0] > map.axis[2]) != (map.axis[1] > map.axis[2]));
  return is_odd != (map.sign[0] * map.sign[1] * map.sign[2] < 0);
}

Names renamed(const Names& contact, const std::vector<std::size_t>& names) {
  Names made;
  for (const std::size_t name : contact) made.push_back(names[name]);
  std::ranges::sort(made);
  return made;
}

oracle::Point position_of(const fuzz::Input& input, std::size_t row) {
  const fuzz::Row& at = input.rows[row];
  return {oracle::Rational(at[0]), oracle::Rational(at[1]), oracle::Rational(at[2])};
}

// (b-a) x (c-a) for the first three of these rows.
oracle::Point turn_of(const fuzz::Input& input, const Names& contact) {
  const oracle::Point a = position_of(input, contact[0]);
  return oracle::cross(oracle::minus(position_of(input, contact[1]), a),
                       oracle::minus(position_of(input, contact[2]), a));
}

void compare(const fuzz::Input& input, const std::array<Limit, 2>& expected, const std::array<Limit, 2>& found,
             bool is_swapped, Totals& totals) {
  const std::array<Limit, 2> right = {expected.at(is_swapped ? 1 : 0), expected.at(is_swapped ? 0 : 1)};
  require_none(input, found == right ? "" : "sides lead elsewhere in the image", "");
  ++totals.points;
  if (expected[0] == expected[1]) return;
  ++totals.different;
  totals.swapped += is_swapped ? 1 : 0;
}

// relation(input, totals) draws a transformation.
template <typename Relation>
void on_families(const char* what, Relation&& relation) {
  Totals totals;
  bool held = true;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    held =
        expect_holds(family.name, parameters_of_run(kInputsPerFamily, held), [&] { relation(*generator, totals); }) &&
        held;
  }
  std::printf("%s: %zu points, %zu with different limits, %zu of these with swapped sides\n", what, totals.points,
              totals.different, totals.swapped);
  if (held && scale_of_run() >= 1) {
    EXPECT_GE(totals.swapped, 100U);
    EXPECT_GE(totals.different - totals.swapped, 100U);
  }
}

TEST(UnstableSides, ReflectionsSwapThem) {
  CITES("FC-FLOW-07", "FC-FLOW-11");
  on_families("axes", [](const fuzz::Input& input, Totals& totals) {
    const fuzz::AxisMap map = *fuzz::axis_maps().as("axes");
    const Sides image = sides_of(fuzz::mapped(input, map));
    for (const auto& [contact, limits] : sides_of(input)) {
      compare(input, limits, image.at(contact), is_reflection(map), totals);
    }
  });
}

TEST(UnstableSides, OtherNamesSwapThemWhereTheFirstThreeTurnOtherwise) {
  CITES("FC-FLOW-07", "FC-FLOW-11");
  on_families("names", [](const fuzz::Input& input, Totals& totals) {
    const auto order = *fuzz::row_orders(input.rows.size());
    const fuzz::Input permuted = fuzz::permuted(input, order);
    const auto names = names_after(input, order);
    const Sides image = sides_of(permuted);
    for (const auto& [contact, limits] : sides_of(input)) {
      std::array<Limit, 2> expected;
      for (std::size_t side = 0; side < 2; ++side) {
        if (limits.at(side)) expected.at(side) = renamed(*limits.at(side), names);
      }
      const Names there = renamed(contact, names);
      const bool is_swapped = oracle::dot(turn_of(input, contact), turn_of(permuted, there)) < 0;
      compare(input, expected, image.at(there), is_swapped, totals);
    }
  });
}

}  // namespace
}  // namespace flowcert::property::unstable_sides_test
