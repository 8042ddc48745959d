// Reports what a campaign has found, for people and for programs, on standard output.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/known_findings.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

// The text prints at most so many; the JSON has all.
inline constexpr std::size_t kMostFindingsPrinted = 20;

// As the campaign has them: the number of the case, and "PROPERTY KIND".
using FindingKey = std::pair<std::size_t, std::string>;
using FindingKeys = std::set<FindingKey>;
[[nodiscard]] inline FindingKey key_of(const fuzz::Counterexample& finding) {
  return {finding.number, kind_of(finding)};
}

// What a person looks at: the kind, and the points that are left. Findings that are equal in both are printed once,
// whatever the order of their points.
using ShownFinding = std::pair<std::string, std::vector<fuzz::Row>>;
[[nodiscard]] inline ShownFinding shown_of(const fuzz::Counterexample& finding) {
  std::vector<fuzz::Row> rows = finding.trial.input.rows;
  std::ranges::sort(rows);
  return {kind_of(finding), rows};
}

struct FuzzRun {
  const fuzz::Campaign& campaign;
  const KnownFindings& known;
  // The seconds of this run. None if nothing was run, as when parts are merged.
  std::optional<double> seconds;
  std::size_t cases = 0;
  unsigned jobs = 1;
  bool is_interrupted = false;
  bool is_time_up = false;
  const FindingKeys* printed = nullptr;  // findings that were printed before
};

// What a finding is, its points if they are few, and where its file lies. `unless_small` says why it is not small yet.
void print_finding(const fuzz::Campaign& campaign, const fuzz::Counterexample& finding,
                   const std::string& unless_small);

void print_fuzz(const FuzzRun& run, bool json);

// Reports one case, which is done, and returns the exit status.
[[nodiscard]] int print_case(const fuzz::Campaign& campaign, const fuzz::OneCase& one, bool json);

// The exit status, which says whether there is a finding that the known ones do not explain.
[[nodiscard]] int verdict_of(const FuzzRun& run);

}  // namespace flowcert::commands
