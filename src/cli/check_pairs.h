// `flowcert check` of a persistence diagram, of cycles and of pores: which claimed pairs, cycles or diameters are wrong,
// and which are missing (FC-FILE-28, FC-CLAIM-11; FC-FILE-53, FC-CLAIM-25; FC-FILE-58, FC-CLAIM-26), for people, as
// JSON and for CI systems (src/cli/manual/check.md).
#pragma once

#include <string>
#include <vector>

#include "certify/cycle_differences.h"
#include "certify/pair_differences.h"
#include "certify/pore_claims.h"
#include "cli/check_report.h"
#include "cli/layer.h"

namespace flowcert::cli {

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

// At most `most` differences are shown; the table counts all.
void print_check_text(const CheckedFiles& files, const PairReport& report, std::size_t most);
void print_check_json(const CheckedFiles& files, const PairReport& report, const PointSet& points);
void write_check_junit(std::ostream& out, const CheckedFiles& files, const PairReport& report);

}  // namespace flowcert::cli
