// `flowcert check` of a persistence diagram, and of cycles: which claimed pairs or cycles are wrong, and which are
// missing (FC-FILE-28, FC-CLAIM-11; FC-FILE-53, FC-CLAIM-25), for people, as JSON and for CI systems
// (src/cli/manual/check.md).
#pragma once

#include <string>
#include <vector>

#include "certify/cycle_differences.h"
#include "certify/pair_differences.h"
#include "cli/check_report.h"
#include "cli/layer.h"

namespace flowcert::cli {

struct PairReport {
  bool is_of_cycles = false;
  Verdict verdict = Verdict::kConforms;  // or kFails
  Profile profile;
  std::vector<PairDifference> differences;
  std::array<std::size_t, kPairDimensions> claimed{}, truth{};  // pairs of positive length, or cycles
};

[[nodiscard]] PairReport report_of_pairs(const std::vector<ClaimedPair>& claimed, const std::vector<ListedPair>& truth,
                                         double tolerance);
[[nodiscard]] PairReport report_of_cycles(const CycleClaim& claim, const FlowComplex& complex, double tolerance);

// At most `most` differences are shown; the table counts all.
void print_check_text(const CheckedFiles& files, const PairReport& report, std::size_t most);
void print_check_json(const CheckedFiles& files, const PairReport& report, const PointSet& points);
void write_check_junit(std::ostream& out, const CheckedFiles& files, const PairReport& report);

}  // namespace flowcert::cli
