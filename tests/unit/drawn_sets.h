// Small inputs of all families, for tests of the oracle, whose time grows fast with the number of points.
//
// Guarantees: the same inputs in every run of one scale (tests/property/property_parameters.h).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/stable_configurations.h"
#include "tests/property/property_parameters.h"

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

}  // namespace flowcert_tests
