#include "fuzz/inputs/large_family.h"

#include <array>

#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/inputs/stable_configurations.h"

namespace flowcert::fuzz {

namespace {

constexpr std::array kMakers{lattice_piece, lattice_layers, integer_spheres, rounded_capsule};

// Small sizes come more often. One input in four is made larger by a factor of 41 bits: a checker that computes in
// 128 bits needs integers of any size for it.
Input large_ties(Integer maker, const std::array<Integer, 2>& dice, Integer seed, Integer scale) {
  constexpr double kFactor = 0x1p40 + 1;
  constexpr auto kFewest = static_cast<Integer>(kFewestRowsOfLarge);
  const Integer rows = kFewest + dice[0] * dice[1] / (static_cast<Integer>(kMostRowsOfLarge) - kFewest);
  Input input =
      kMakers.at(static_cast<std::size_t>(maker))(static_cast<std::size_t>(rows), static_cast<std::uint64_t>(seed));
  for (Row& row : input.rows) {
    for (double& coordinate : row) coordinate *= scale == 0 ? kFactor : 1;
  }
  return input;
}

}  // namespace

const Family& large_family() {
  static const Family family{
      "large",
      "1,000 to 10,000 points of a lattice, layers, close spheres or a rounded capsule; drawn if it is named",
      [] {
        constexpr auto kRange = static_cast<Integer>(kMostRowsOfLarge - kFewestRowsOfLarge);
        constexpr Integer kMostSeed = Integer{1} << 60;
        return rc::gen::apply(large_ties, whole(0, kMakers.size() - 1),
                              rc::gen::container<std::array<Integer, 2>>(whole(0, kRange)), whole(0, kMostSeed),
                              whole(0, 3));
      },
      {.four_points = 100, .degenerate = 100}};
  return family;
}

bool is_large(std::string_view name) { return name == large_family().name; }

std::vector<Family> named_families() {
  std::vector<Family> all = families_and_stable_ones();
  all.push_back(large_family());
  return all;
}

}  // namespace flowcert::fuzz
