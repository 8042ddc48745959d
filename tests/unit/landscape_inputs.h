// Small inputs for tests of merge trees and pockets: of all families, and some that have many maxima.
//
// The same in every run with one scale. There are fewer and smaller inputs if the run is scaled down.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/stable_configurations.h"
#include "oracle/fast/point_set.h"
#include "oracle/merge_tree.h"
#include "tests/property/property_parameters.h"

namespace oracle {

using LandscapeRows = std::vector<std::array<double, 3>>;

// An input with its stationary points and merge trees.
struct LandscapeSubject {
  explicit LandscapeSubject(const LandscapeRows& input)
      : rows(input),
        set(rows),
        all(stationary_points(set).stationary),
        maxima(maxima_places(all)),
        pockets_tree(superlevel_tree(set, all)),
        components_tree(sublevel_tree(set, all)) {}

  std::size_t infinity() const { return maxima.size(); }
  const Rational& value(std::size_t leaf) const { return all[maxima[leaf]].squared_distance; }
  std::size_t count(int index) const {
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const StationaryPoint& z) {
      return z.is_critical() && z.hull_dimension == index;
    }));
  }
  std::size_t leaf_of(std::size_t place) const {
    return static_cast<std::size_t>(std::find(maxima.begin(), maxima.end(), place) - maxima.begin());
  }
  Rational joining(std::size_t leaf, std::size_t other) const {
    return joining_value(pockets_tree, leaf, other).value();
  }

  LandscapeRows rows;
  fast::PointSet set;
  std::vector<StationaryPoint> all;
  std::vector<std::size_t> maxima;
  MergeTree pockets_tree, components_tree;
};

// Some of the candidates, each one at random.
inline LandscapeRows some_of(const LandscapeRows& candidates, std::size_t number, rc::Random& random) {
  LandscapeRows rows;
  for (std::size_t k = 0; k < number; ++k) {
    rows.push_back(candidates[static_cast<std::size_t>(random.next() % candidates.size())]);
  }
  return rows;
}

inline LandscapeRows lattice(int side) {
  LandscapeRows rows;
  for (int k = 0; k < side * side * side; ++k) {
    const int x = k % side, y = k / side % side, z = k / side / side;
    rows.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  }
  return rows;
}

// Squares around the axis z, as the walls of a tube, at random heights. Half of them are small.
inline LandscapeRows tube(rc::Random& random) {
  LandscapeRows rows;
  for (int z = 0; rows.size() < 16; z += 1 + static_cast<int>(random.next() % 2)) {
    const double half = random.next() % 2 == 0 ? 2 : 1;
    for (const double x : {-half, half}) {
      for (const double y : {-half, half}) rows.push_back({x, y, static_cast<double>(z)});
    }
  }
  return rows;
}

// Inputs with many maxima, of one value or of several: parts of lattices, and tubes with chambers.
inline LandscapeRows made_of_cells(std::uint64_t seed) {
  rc::Random random(seed);
  const LandscapeRows sparse = {{2, 2, 0}, {2, 2, 4}, {2, 0, 2}, {2, 4, 2}, {0, 2, 2}, {4, 2, 2}, {0, 0, 0}, {4, 0, 0},
                                {0, 4, 0}, {4, 4, 0}, {0, 0, 4}, {4, 0, 4}, {0, 4, 4}, {4, 4, 4}, {2, 2, 6}, {6, 2, 2}};
  const std::size_t number = flowcert::property::scale_of_run() < 1 ? 12 : 16;
  if (seed % 4 == 0) return some_of(lattice(3), 2 * number, random);
  if (seed % 4 == 1) return some_of(lattice(5), number, random);
  if (seed % 4 == 2) return some_of(sparse, 2 * number, random);
  return tube(random);
}

// Inputs of all families, and as many times 8 that are made of cells.
template <typename Visit>
void for_each_drawn(std::uint64_t seeds_at_scale, const Visit& visit) {
  const double scale = flowcert::property::scale_of_run();
  const auto scaled = static_cast<std::uint64_t>(static_cast<double>(seeds_at_scale) * scale);
  const std::uint64_t seeds = std::max<std::uint64_t>(1, scaled);
  const auto visit_drawn = [&](const flowcert::fuzz::Family& family, std::uint64_t seed, int size) {
    SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
    LandscapeRows rows = flowcert::fuzz::draw(family, seed, size).rows;
    rows.resize(std::min<std::size_t>(rows.size(), scale < 1 ? 7 : 10));
    if (!rows.empty()) visit(LandscapeSubject(rows), seed);
  };
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    for (const auto& family : flowcert::fuzz::families()) visit_drawn(family, seed, 12 + static_cast<int>(8 * seed));
    for (const auto& family : flowcert::fuzz::stable_families()) visit_drawn(family, seed, 100);
    for (std::uint64_t k = 8 * seed; k < 8 * (seed + 1); ++k) {
      SCOPED_TRACE("made of cells, " + std::to_string(k));
      visit(LandscapeSubject(made_of_cells(k)), k);
    }
  }
}

}  // namespace oracle
