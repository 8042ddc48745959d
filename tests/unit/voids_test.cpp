// Voids and components of persistence pairs, against components that the test makes for itself: paths over critical
// points, whatever the merge trees say.
#include "flowcert/voids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace flowcert::voids_test {
namespace {

using Records = std::vector<std::uint32_t>;
using Neighbours = std::map<std::uint32_t, std::set<std::uint32_t>>;

// What can be reached from one of them.
std::set<std::uint32_t> reached(std::uint32_t start, const Neighbours& neighbours) {
  std::set<std::uint32_t> found{start};
  Records left{start};
  while (!left.empty()) {
    const std::uint32_t next = left.back();
    left.pop_back();
    const auto known = neighbours.find(next);
    if (known == neighbours.end()) continue;
    for (const std::uint32_t other : known->second) {
      if (found.insert(other).second) left.push_back(other);
    }
  }
  return found;
}

struct Seen {
  std::size_t voids = 0, of_several = 0, equal_peaks = 0, components = 0, walls = 0;
};

class VoidsOf {
 public:
  VoidsOf(const FlowComplex& complex, Seen& seen)
      : complex_(complex),
        trees_(complex.merge_trees()),
        values_(complex.persistence().squared_distances()),
        voids_(trees_),
        infinity_(static_cast<std::uint32_t>(complex.stationary().size())),
        seen_(seen) {}

  void expect_right() const {
    for (const PersistencePair& pair : complex_.persistence().pairs()) {
      if (pair.dimension == 2) {
        const Rational b = values_.exact(pair.birth), d = values_.exact(*pair.death);
        for (const int share : {0, 2}) expect_void(pair, b + (d - b) * share / 4);
      }
      if (pair.dimension == 0 && pair.death) expect_components(pair);
    }
  }

 private:
  // Maxima, and infinity, by their places in the list.
  [[nodiscard]] std::uint32_t record_of(std::uint32_t leaf) const {
    return leaf == trees_.maxima() ? infinity_ : static_cast<std::uint32_t>(trees_.record_of(leaf));
  }
  [[nodiscard]] Records above(std::size_t record) const {
    Records records;
    for (const std::uint32_t leaf : trees_.peaks_above(record)) records.push_back(record_of(leaf));
    return records;
  }

  void expect_void(const PersistencePair& pair, const Rational& level) const {
    Neighbours neighbours;
    for (const std::uint32_t saddle : trees_.saddles_down()) {
      if (values_.compare(saddle, level) <= 0) continue;
      const auto sides = trees_.peaks_above_sides(saddle);
      const std::uint32_t one = record_of(sides[0].front()), other = record_of(sides[1].front());
      neighbours[one].insert(other);
      neighbours[other].insert(one);
    }
    const std::set<std::uint32_t> maxima = reached(*pair.death, neighbours);
    const auto is_inside = [&](std::uint32_t record) { return maxima.contains(record); };
    Void expected{{maxima.begin(), maxima.end()}, {}, {}};
    for (std::uint32_t record = 0; record < complex_.stationary().size(); ++record) {
      const Records records = above(record);
      if (records.empty() || !std::ranges::any_of(records, is_inside)) continue;
      if (std::ranges::all_of(records, is_inside)) {
        expected.cell.push_back(record);
      } else if (complex_.stationary().index(record) == StationaryIndex{2, 2}) {
        expected.walls.push_back(record);
      }
    }
    const Void found = voids_.at(*pair.death, level);
    EXPECT_EQ(found, expected);
    // Its maximum is the latest one.
    for (const std::uint32_t maximum : found.maxima) {
      EXPECT_LE(std::pair(values_.rank(maximum), maximum), std::pair(values_.rank(*pair.death), *pair.death));
      if (maximum != *pair.death && values_.rank(maximum) == values_.rank(*pair.death)) ++seen_.equal_peaks;
    }
    ++seen_.voids;
    seen_.of_several += found.maxima.size() > 1 ? 1 : 0;
    seen_.walls += found.walls.size();
  }

  void expect_components(const PersistencePair& pair) const {
    const StationaryPoints& stationary = complex_.stationary();
    Neighbours neighbours;
    for (std::size_t record = 0; record < stationary.size(); ++record) {
      if (stationary.index(record) != StationaryIndex{1, 1} || values_.rank(record) >= values_.rank(*pair.death)) {
        continue;
      }
      const auto ends = stationary.contact(record);
      neighbours[ends[0]].insert(ends[1]);
      neighbours[ends[1]].insert(ends[0]);
    }
    const auto ends = stationary.contact(*pair.death);
    const auto found = components_at(trees_, *pair.death);
    std::set<std::uint32_t> names[2];
    for (const std::size_t side : {0U, 1U}) {
      for (const std::uint32_t record : found[side]) names[side].insert(stationary.contact(record).front());
      EXPECT_EQ(names[side], reached(ends[side], neighbours));
    }
    EXPECT_FALSE(names[0].contains(ends[1]));
    const std::uint32_t born = stationary.contact(pair.birth).front();
    if (!names[0].contains(born) && !names[1].contains(born)) return;  // another point of this value joined it before
    ++seen_.components;
  }

  const FlowComplex& complex_;
  const MergeTrees& trees_;
  const SquaredDistances& values_;
  Voids voids_;
  std::uint32_t infinity_;
  Seen& seen_;
};

TEST(Voids, AreComponentsAtEachLevel) {
  CITES("FC-CYC-06", "FC-CYC-07");
  Seen seen;
  flowcert_tests::for_each_drawn_set({.seeds = 6, .made = 2, .most_rows = 60}, [&](const auto& rows, std::uint64_t) {
    const FlowComplex complex(PointSet(property::rows_of(fuzz::Input{.rows = rows})));
    VoidsOf(complex, seen).expect_right();
  });
  flowcert_tests::for_each_grid([&](const auto& rows) {
    const FlowComplex complex(PointSet(property::rows_of(fuzz::Input{.rows = rows})));
    VoidsOf(complex, seen).expect_right();
  });
  EXPECT_GT(seen.voids, 500U);
  EXPECT_GT(seen.of_several, 20U);
  EXPECT_GT(seen.equal_peaks, 0U);
  EXPECT_GT(seen.components, 500U);
  EXPECT_GT(seen.walls, 1000U);
}

// Two maxima of the value 149/64 join at 9/4 (FC-CYC-06).
TEST(Voids, OfEqualPeaksTheEarlierOneDies) {
  CITES("FC-CYC-06");
  const std::vector<Point> rows = {{-1, -1, -3}, {-1, 0, -1}, {0, -2, -1}, {0, 1, -3},
                                   {0, 2, 1},    {1, -1, -3}, {1, 0, -1}};
  const FlowComplex complex(rows);
  const SquaredDistances& values = complex.persistence().squared_distances();
  const Voids voids(complex.merge_trees());
  const auto& counts = complex.stationary().critical_counts();
  std::vector<std::uint32_t> peaks;
  const auto first = static_cast<std::uint32_t>(counts[0] + counts[1] + counts[2]);
  for (std::uint32_t record = first; record < first + counts[3]; ++record) {
    if (values.exact(record) == Rational(149, 64)) peaks.push_back(record);
  }
  ASSERT_EQ(peaks.size(), 2U);
  std::size_t seen = 0;
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    if (pair.dimension != 2 || !std::ranges::count(peaks, *pair.death)) continue;
    const Void space = voids.at(*pair.death, values.exact(pair.birth));
    const bool is_earlier = *pair.death == peaks[0];
    EXPECT_EQ(values.exact(pair.birth) == Rational(9, 4), is_earlier);
    EXPECT_EQ(space.maxima, is_earlier ? Records{peaks[0]} : peaks);
    ++seen;
  }
  EXPECT_EQ(seen, 2U);
}

TEST(Voids, RefuseWhatHasNone) {
  const std::vector<Point> rows = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}};
  const FlowComplex complex(rows);
  const Voids voids(complex.merge_trees());
  EXPECT_THROW((void)voids.at(0, Rational(1)), std::invalid_argument);
  EXPECT_THROW((void)components_at(complex.merge_trees(), 0), std::invalid_argument);
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    if (pair.dimension != 2) continue;
    EXPECT_THROW((void)voids.at(*pair.death, Rational(0)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace flowcert::voids_test
