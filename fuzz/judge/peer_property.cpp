#include "fuzz/judge/peer_property.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <new>
#include <sstream>
#include <system_error>

#include "certify/finding_words.h"
#include "flowcert/claim.h"
#include "fuzz/judge/command_run.h"
#include "fuzz/judge/conformance_words.h"
#include "fuzz/properties/subject.h"
#include "io/output_file.h"

namespace flowcert::judge {

namespace {

namespace fs = std::filesystem;
using property::Disagreement;

// Each run takes a process, so fewer runs are spent on shrinking than for our own properties.
constexpr std::size_t kShrinkingBudget = 400;
// A run that is late takes all of its time limit.
constexpr char kLate[] = "time-limit";
constexpr std::size_t kLateShrinkingBudget = 40;
constexpr std::size_t kMostFindingsShown = 20;

Disagreement ending(std::string kind, const std::string& complaint) {
  return {std::move(kind), "", complaint, "", "", "", ""};
}

std::optional<Disagreement> bad_ending(const CommandRun& run, const ProgramLimits& limits) {
  if (run.end.ending == ProgramEnding::kTimedOut) {
    return ending(kLate, fmt::format("not done after {} s", limits.seconds));
  }
  if (run.end.ending == ProgramEnding::kSignalled) return ending("signal", signal_text(run.end.number));
  if (was_not_started(run.end)) {
    return ending("not-started", status_text(run));
  }
  if (run.end.number != 0) return ending("refusal", status_text(run));
  return std::nullopt;
}

std::optional<Disagreement> wrong_claim(const CheckReport& report, const std::string& claim) {
  if (report.verdict != Verdict::kFails) return std::nullopt;
  std::vector<Finding> wrong;
  for (const Finding& finding : report.findings) {
    if (!finding.is_variation) wrong.push_back(finding);
  }
  const Finding& telling = telling_finding(wrong);
  std::string truth;
  for (std::size_t k = 0; k < std::min(wrong.size(), kMostFindingsShown); ++k) {
    truth += finding_words(wrong[k]) + '\n';
  }
  return Disagreement{reason_text(telling.reason), telling.clause, finding_words(telling), "the claim", claim,
                      "what is wrong with it",     truth};
}

class Peer {
 public:
  explicit Peer(const PeerOptions& options) : options_(options) {}

  // No program has to accept a file without points, so no program is asked about it.
  std::optional<Disagreement> judge(const fuzz::Input& input) {
    if (input.rows.empty()) return std::nullopt;
    std::ostringstream rows;
    rows << input;
    const ScratchFolder folder(scratch_.path() / fmt::format("{}-{}", ::getpid(), ++runs_));
    const CommandRun run = run_in(folder.path(), rows.str());
    if (auto bad = bad_ending(run, options_.limits)) return bad;
    try {
      return judge_answer(property::subject_of(input).complex, answer_bytes(run), run.answer_name);
    } catch (const InvalidInput& error) {
      return ending("unreadable", one_line(error.what()));
    } catch (const std::bad_alloc&) {
      return ending("unreadable", run.answer_name + ": too large to be read");
    }
  }

 private:
  [[nodiscard]] CommandRun run_in(const fs::path& folder, const std::string& rows) const {
    try {
      CommandRun run = run_command({options_.command, "points.xyz", rows, options_.out_name, {}}, folder,
                                   options_.limits, options_.is_cancelled);
      if (run.end.ending == ProgramEnding::kCancelled) throw property::MachineFailure("stopped by a signal");
      return run;
    } catch (const OutputError& error) {
      throw property::MachineFailure(error.what());
    }
  }

  [[nodiscard]] std::optional<Disagreement> judge_answer(const FlowComplex& complex, const std::string& bytes,
                                                         const std::string& name) const {
    const Claim claim = read_claim_from(bytes, name);
    require_rows(claim, complex.points(), name);
    return wrong_claim(check(complex.points(), claim, *fast_truth(complex), options_.check), bytes);
  }

  PeerOptions options_;
  ScratchFolder scratch_;
  std::size_t runs_ = 0;
};

}  // namespace

property::Property peer_property(const PeerOptions& options) {
  auto peer = std::make_shared<Peer>(options);
  return {.name = kPeerProperty,
          .description = "what the command claims is right",
          .shrinking_budget = kShrinkingBudget,
          .slow_kind = kLate,
          .slow_shrinking_budget = kLateShrinkingBudget,
          .check = [peer](const property::Trial& trial) { return peer->judge(trial.input); }};
}

}  // namespace flowcert::judge
