// Runs a user's command on conformance vectors. Each case has an outcome.
//
// Guarantees: every case has an outcome, whatever the command does (limited_program.h). Its answer is a claim that is
// judged like any other, by the vector's stored answers. Nothing is left behind but what --keep asks
// for.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/orbit_difference.h"
#include "certify/other_truth.h"
#include "certify/pair_differences.h"
#include "certify/programs/limited_program.h"
#include "certify/programs/vector_cases.h"
#include "flowcert/check.h"
#include "flowcert/profile.h"

namespace flowcert::certify {

enum class RunOutcome {
  kConforms,
  kConformsWhereDetermined,
  kPerturbed,
  kProperlyRefused,  // an invalid case: the command said no, by its exit status
  kSkipped,          // not asked of the command
  // Negative from here on.
  kFails,
  kAccepted,  // an invalid case, with exit status 0
  kRefused,   // a valid one, with another exit status
  kCrashed,   // ended by a signal, or not even started
  kTimedOut,
  kUnreadable,  // exit status 0, but no answer that can be read
};
inline constexpr std::size_t kRunOutcomes = 11;

// "conforms where determined"
[[nodiscard]] const char* run_outcome_text(RunOutcome outcome);
[[nodiscard]] inline bool is_negative(RunOutcome outcome) { return outcome >= RunOutcome::kFails; }

struct OrbitFinding {
  std::string start;
  PathDifference difference;
};

// Why a case is negative, and the first thing that is so, in words.
struct CaseReason {
  std::string reason;
  std::string example;
};

struct CaseOutcome {
  const VectorCase* of = nullptr;
  RunOutcome outcome = RunOutcome::kSkipped;
  std::string message;       // one line; empty where there is nothing to say
  std::optional<int> level;  // the first level that fails, if the claim fails
  // A negative case has the reasons of its wrong findings, "wrong-orbit", "wrong-pair" (or "rounding"), or how the run
  // ended ("timed-out"). Each is there once.
  std::vector<CaseReason> reasons;
  double seconds = 0;  // of all runs of the case
  std::vector<Finding> findings;
  std::size_t findings_left_out = 0;  // beyond the first kMostFindings
  bool is_decided = true;             // false if a finding is not
  std::vector<OrbitFinding> orbit_findings;
  std::array<bool, kLevels> judged{};  // the levels on which something was judged
  std::size_t orbits_judged = 0;
  std::vector<PairDifference> persistence_findings;
  bool is_persistence_judged = false;
  // What the answers cover (FC-CLAIM-22). An invalid or skipped case has none, and neither has one whose claim was not
  // judged.
  std::optional<Profile> profile;
};
inline constexpr std::size_t kMostFindings = 100;
// The page in the folder of a case that is kept (src/cli/manual/view.md).
inline constexpr char kPageName[] = "page.html";

struct ConformanceOptions {
  std::string command;              // with {in}; the answer is the file {out}, or standard output
  std::string orbit_command;        // a command with {start}; may be empty
  std::string persistence_command;  // may be empty
  std::string out_name = "claim";
  PointFileStyle points;
  ProgramLimits limits;
  CheckOptions check;
  unsigned jobs = 1;
  std::string keep;  // a folder; may be empty
  OtherTruth truth;  // of vectors
};

// The outcomes have the order of the cases, which must outlive them. An Interruption has to exist; if a signal came,
// Interrupted is thrown. Throws std::exception if it is impossible to go on: no disk, no process, a vector that
// contradicts itself.
[[nodiscard]] std::vector<CaseOutcome> run_conformance(
    const std::vector<const VectorCase*>& cases, const ConformanceOptions& options,
    const std::function<void(std::size_t done, std::size_t total)>& progress);

// ---- Words ----
// Every kind of report speaks of findings in these.

// "level 3: missing [FC-CLAIM-03]: claimed nothing; truth: ..."
[[nodiscard]] std::string finding_words(const Finding& finding);

// "orbit from 1/2,0,0: claimed segment 2: type E-F-V; truth: E-F-E"
[[nodiscard]] std::string orbit_finding_words(const OrbitFinding& finding);

// "persistence: claimed dimension 1, birth 1/2, death 3/4; truth: no such pair"
[[nodiscard]] std::string persistence_finding_words(const PairDifference& difference);

}  // namespace flowcert::certify
