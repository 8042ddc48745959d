// The fast implementation's persistence pairs against the oracle's, which come from the Čech filtration. That
// way has neither flow nor triangulation in common with the fast one, or with the alpha complex.
//
// Guarantees: compared exactly, as multisets, with ties broken in three ways. The test fails too when too few
// inputs had ties, or classes of dimension 1 and 2.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cstdio>
#include <sstream>

#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "fuzz/properties/subject.h"
#include "oracle/fast/point_set.h"
#include "oracle/persistence.h"
#include "tests/cites.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::cech_persistence_test {
namespace {

constexpr int kInputsPerFamily = 60;
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

void require_same_pairs(const fuzz::Input& input, Totals& totals) {
  const PointSet points = point_set_of(input);
  const auto expected = oracle::persistence_pairs(oracle::fast::PointSet(input.rows));
  for (const std::uint64_t seed : kSeeds) {
    const FlowComplex complex(points, {.seed = seed});
    const auto pairs = persistence_pairs(complex);
    if (pairs != expected) {
      std::ostringstream text;
      text << "ties broken with seed " << seed << "; the fast implementation has\n"
           << to_text(pairs) << "and the oracle\n"
           << to_text(expected) << "input:\n"
           << input;
      RC_FAIL(text.str());
    }
    const bool has_ties = complex.chains().broken_ties() > 0 || complex.stable().statistics().broken_ties > 0;
    if (seed == 0) totals.with_ties += has_ties ? 1 : 0;
  }
  ++totals.inputs;
  totals.largest += input.rows.size() == kMostRows ? 1 : 0;
  for (const auto& pair : expected) ++totals.pairs.at(static_cast<std::size_t>(pair.dimension));
}

// Makes inputs larger: most inputs of the families have six rows or so.
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
  EXPECT_GE(all.inputs, 1650U);
  EXPECT_GE(all.largest, 150U);
  EXPECT_GE(all.with_ties, 300U);
  EXPECT_GE(all.pairs[1], 1650U);
  EXPECT_GE(all.pairs[2], 300U);
}

// Six edges of squared length 2, four faces, and the inside.
TEST(CechPersistence, OfARegularTetrahedron) {
  CITES("FC-PERS-05");
  const auto pairs = oracle::persistence_pairs(oracle::PointSet({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}));
  EXPECT_EQ(to_text(pairs),
            "0 0 1/2\n0 0 1/2\n0 0 1/2\n0 0 inf\n"
            "1 1/2 2/3\n1 1/2 2/3\n1 1/2 2/3\n"
            "2 2/3 3/4\n");
  EXPECT_EQ(oracle::persistence_pairs(oracle::PointSet({})).size(), 0U);
}

}  // namespace
}  // namespace flowcert::property::cech_persistence_test
