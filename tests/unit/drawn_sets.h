// Small inputs of all families, for tests of the oracle, whose time grows fast with the number of points.
//
// Guarantees: the same inputs in every run of one scale (tests/property/property_parameters.h).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/stable_configurations.h"
#include "tests/property/property_parameters.h"
#include "tests/unit/portable_random.h"

namespace flowcert_tests {

struct DrawnSets {
  std::uint64_t seeds;    // so many inputs of each family,
  std::uint64_t made;     // and of each one that is made for stable sets
  std::size_t most_rows;  // further rows are left out
  int growth = 8;         // how much the size of an input grows from seed to seed
};

// As many seeds as a run of this scale has, and at least one.
inline std::uint64_t scaled_seeds(std::uint64_t seeds) {
  return std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(static_cast<double>(seeds) * flowcert::property::scale_of_run()));
}

// Calls use(rows, seed). There may be no rows.
template <class Use>
void for_each_drawn_set(const DrawnSets& sets, const Use& use) {
  const auto use_drawn = [&](const flowcert::fuzz::Family& family, std::uint64_t seed, int size) {
    SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
    std::vector<std::array<double, 3>> rows = flowcert::fuzz::draw(family, seed, size).rows;
    if (rows.size() > sets.most_rows) rows.resize(sets.most_rows);
    use(rows, seed);
  };
  for (const flowcert::fuzz::Family& family : flowcert::fuzz::families()) {
    for (std::uint64_t seed = 0; seed < sets.seeds; ++seed) {
      use_drawn(family, seed, 12 + sets.growth * static_cast<int>(seed));
    }
  }
  for (const flowcert::fuzz::Family& family : flowcert::fuzz::stable_families()) {
    for (std::uint64_t seed = 0; seed < sets.made; ++seed) use_drawn(family, seed, 100);
  }
}

// Calls use(rows) with inputs of 120 points at random, on grids of three widths. On the coarse ones many values are
// equal.
template <class Use>
void for_each_grid(const Use& use) {
  PortableRandom random(5);
  for (const double steps : {6.0, 20.0, 1e6}) {
    for (int input = 0; input < 3; ++input) {
      SCOPED_TRACE("grid of " + std::to_string(steps) + " steps, input " + std::to_string(input));
      std::vector<std::array<double, 3>> rows(120);
      const auto coordinate = [&] { return std::round(random.coordinate() * steps); };
      for (auto& row : rows) row = {coordinate(), coordinate(), coordinate()};
      use(rows);
    }
  }
}

}  // namespace flowcert_tests
