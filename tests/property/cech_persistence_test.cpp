// The fast implementation's persistence pairs against the oracle's, which come from the Čech filtration: a
// way that has neither flow nor triangulation in common with the fast one, or with the alpha complex.
//
// Guarantees: compared exactly, as multisets, with ties broken in three ways. The test fails too when too few
// inputs had ties, or classes of dimension 1 and 2.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

#include "flowcert/persistence.h"
#include "fuzz/families.h"
#include "fuzz/properties/stationary_comparison.h"
#include "oracle/persistence.h"
#include "tests/cites.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property {
namespace {

constexpr int kInputsPerFamily = 150;
constexpr std::size_t kMostRows = 11;
constexpr std::uint64_t kSeeds[] = {0, 1, 20};

struct Totals {
  std::size_t inputs = 0, with_ties = 0, largest = 0;
  std::array<std::size_t, 3> pairs{};

  void add(const Totals& part) {
    inputs += part.inputs;
    with_ties += part.with_ties;
    largest += part.largest;
    for (std::size_t k = 0; k < 3; ++k) pairs.at(k) += part.pairs.at(k);
  }
};

struct FastAnswer {
  std::vector<oracle::PersistencePair> pairs;
  bool has_ties = false;
};

FastAnswer fast_answer(const PointSet& points, std::uint64_t seed) {
  const Delaunay delaunay(points);
  const StationaryPoints stationary = stationary_points(delaunay);
  UnstableManifolds unstable(delaunay, stationary);
  const StableManifolds stable(delaunay, stationary, {.flow = {}, .seed = seed});
  const ChainComplex complex(points, stationary, unstable, stable, seed);
  const Persistence persistence(points, stationary, complex);
  FastAnswer answer{{}, complex.broken_ties() > 0 || stable.statistics().broken_ties > 0};
  for (const PersistencePair& pair : persistence.pairs()) {
    answer.pairs.push_back({pair.dimension, persistence.squared_value(pair.birth), std::nullopt});
    if (pair.death) answer.pairs.back().death = persistence.squared_value(*pair.death);
  }
  std::sort(answer.pairs.begin(), answer.pairs.end());
  return answer;
}

std::string text_of(const std::vector<oracle::PersistencePair>& pairs) {
  std::string text;
  for (const auto& pair : pairs) {
    text += "  " + std::to_string(pair.dimension) + ' ' + pair.birth.str() + ' ' +
            (pair.death ? pair.death->str() : "inf") + '\n';
  }
  return text;
}

void require_same_pairs(const fuzz::Input& input, Totals& totals) {
  const PointSet points = point_set_of(input);
  const auto expected = oracle::persistence_pairs(oracle::PointSet(input.rows));
  for (const std::uint64_t seed : kSeeds) {
    const FastAnswer fast = fast_answer(points, seed);
    if (fast.pairs != expected) {
      std::ostringstream text;
      text << "ties broken with seed " << seed << "; the fast implementation has\n"
           << text_of(fast.pairs) << "and the oracle\n"
           << text_of(expected) << "input:\n"
           << input;
      RC_FAIL(text.str());
    }
    if (seed == 0) totals.with_ties += fast.has_ties ? 1 : 0;
  }
  ++totals.inputs;
  totals.largest += input.rows.size() == kMostRows ? 1 : 0;
  for (const auto& pair : expected) ++totals.pairs.at(static_cast<std::size_t>(pair.dimension));
}

// Most inputs of the families have six rows or so.
void add_rows(const fuzz::Input& more, fuzz::Input& input) {
  input.rows.insert(input.rows.end(), more.rows.begin(), more.rows.end());
}

void print_row(const std::string& name, const Totals& totals) {
  std::printf("%-22s %5zu inputs; %5zu of %zu rows, %5zu with ties; %6zu %5zu %5zu pairs of dim. 0, 1, 2\n",
              name.c_str(), totals.inputs, totals.largest, kMostRows, totals.with_ties, totals.pairs[0],
              totals.pairs[1], totals.pairs[2]);
}

TEST(CechPersistence, HasTheSamePairsHoweverTiesAreBroken) {
  CITES("FC-PERS-01", "FC-PERS-02", "FC-PERS-03", "FC-PERS-05", "FC-CHAIN-02");
  Totals all;
  bool agreed = true;
  for (const fuzz::Family& family : fuzz::families()) {
    Totals totals;
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds("Čech, " + family.name, parameters_of_run(kInputsPerFamily, agreed),
                          [&] {
                            fuzz::Input input = *generator;
                            if (*rc::gen::arbitrary<bool>()) add_rows(*generator, input);
                            if (input.rows.size() > kMostRows) input.rows.resize(kMostRows);
                            require_same_pairs(input, totals);
                          }) &&
             agreed;
    print_row(family.name, totals);
    all.add(totals);
  }
  print_row("all", all);
  if (!agreed || scale_of_run() < 1) return;
  EXPECT_GE(all.inputs, 5000U);
  EXPECT_GE(all.largest, 500U);
  EXPECT_GE(all.with_ties, 1000U);
  EXPECT_GE(all.pairs[1], 5000U);
  EXPECT_GE(all.pairs[2], 1000U);
}

// Six edges of squared length 2, four faces, and the inside.
TEST(CechPersistence, OfARegularTetrahedron) {
  CITES("FC-PERS-05");
  const auto pairs =
      oracle::persistence_pairs(oracle::PointSet({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}));
  EXPECT_EQ(text_of(pairs),
            "  0 0 1/2\n  0 0 1/2\n  0 0 1/2\n  0 0 inf\n"
            "  1 1/2 2/3\n  1 1/2 2/3\n  1 1/2 2/3\n"
            "  2 2/3 3/4\n");
  EXPECT_EQ(oracle::persistence_pairs(oracle::PointSet({})).size(), 0U);
}

}  // namespace
}  // namespace flowcert::property
