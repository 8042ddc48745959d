// What is wrong with a claim that is a list: a persistence diagram, cycles or pores (FC-CLAIM-11, FC-CLAIM-25,
// FC-CLAIM-26).
#pragma once

#include <string>
#include <vector>

#include "certify/cycle_differences.h"
#include "certify/layer.h"
#include "certify/pair_differences.h"
#include "certify/pore_claims.h"
#include "flowcert/check.h"
#include "flowcert/profile.h"
#include "io/json_fields.h"

namespace flowcert::certify {

// What a list has, and by what its rows are counted: dimensions of pairs and cycles, kinds of diameters.
enum class ListedThing { kPairs, kCycles, kPores };

struct PairReport {
  ListedThing thing = ListedThing::kPairs;
  Verdict verdict = Verdict::kConforms;  // or kFails
  Profile profile;
  std::vector<PairDifference> differences;
  // Pairs of positive length, cycles or diameters; and chambers and windows that a claim may leave out, and does.
  std::vector<std::size_t> claimed, truth, left_out;
};

[[nodiscard]] PairReport report_of_pairs(const std::vector<ClaimedPair>& claimed, const std::vector<ListedPair>& truth,
                                         double tolerance);
[[nodiscard]] PairReport report_of_cycles(const CycleClaim& claim, const FlowComplex& complex, double tolerance);
// name: of the claim's file, for messages.
[[nodiscard]] PairReport report_of_pores(const PoreClaim& claim, const Pores& pores, double tolerance,
                                         const std::string& name);

// The words of a report, and of its rows in tables and in JSON.
struct ListWords {
  const char *clause, *key, *wrong, *row_key, *test_case;
  std::vector<const char*> rows;
  std::vector<Json> row_keys;
};
[[nodiscard]] const ListWords& list_words(const PairReport& report);

// How many differences a row has.
struct DifferenceCounts {
  std::size_t spurious = 0, missing = 0;
};
[[nodiscard]] DifferenceCounts counts_of(const PairReport& report, std::size_t row);

}  // namespace flowcert::certify
