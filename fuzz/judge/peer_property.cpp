#include "fuzz/judge/peer_property.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "certify/finding_words.h"
#include "certify/pair_differences.h"
#include "certify/programs/case_dialogue.h"
#include "certify/programs/command_run.h"
#include "certify/programs/conformance_run.h"
#include "certify/programs/verification.h"
#include "flowcert/claim.h"
#include "fuzz/properties/input_points.h"
#include "fuzz/properties/subject.h"
#include "io/input_bytes.h"
#include "io/out_of_memory.h"
#include "io/output_file.h"

namespace flowcert::judge {

namespace {

namespace fs = std::filesystem;
using property::Disagreement;

// Where each run takes a process, fewer runs are spent on shrinking than for our own properties.
constexpr std::size_t kShrinkingBudget = 400;
constexpr std::size_t kShrinkingBudgetOfDialogue = 3000;
// A run that is late takes all of its time limit.
constexpr char kLate[] = "time-limit";
constexpr std::size_t kLateShrinkingBudget = 40;
constexpr std::size_t kMostFindingsShown = 20;

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

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

std::optional<Disagreement> wrong_claim(const CheckReport& report, const std::string& claim,
                                        const std::vector<std::string>& ignored) {
  std::vector<Finding> wrong;
  for (const Finding& finding : report.findings) {
    const bool counts = !finding.is_variation && !is_among(ignored, reason_text(finding.reason));
    if (counts) wrong.push_back(finding);
  }
  // A wrong Euler sum follows from what is ignored.
  const bool has_ignored = std::ranges::any_of(
      report.findings, [&](const Finding& finding) { return is_among(ignored, reason_text(finding.reason)); });
  if (has_ignored) std::erase_if(wrong, [](const Finding& finding) { return finding.clause == kEulerClause; });
  if (wrong.empty()) return std::nullopt;
  const Finding& telling = telling_finding(wrong);
  std::string truth;
  for (std::size_t k = 0; k < std::min(wrong.size(), kMostFindingsShown); ++k) {
    truth += finding_words(wrong[k]) + '\n';
  }
  return Disagreement{reason_text(telling.reason), telling.clause, finding_words(telling), kClaimName, claim,
                      "what is wrong with it",     truth};
}

std::optional<Disagreement> wrong_pairs(std::vector<PairDifference> differences, const std::string& answer,
                                        const std::vector<std::string>& ignored) {
  std::erase_if(differences, [&](const PairDifference& difference) { return is_among(ignored, difference.reason); });
  if (differences.empty()) return std::nullopt;
  std::string truth;
  for (std::size_t k = 0; k < std::min(differences.size(), kMostFindingsShown); ++k) {
    truth += persistence_finding_words(differences[k]) + '\n';
  }
  return Disagreement{differences.front().reason,
                      "FC-CLAIM-11",
                      persistence_finding_words(differences.front()),
                      "the persistence pairs",
                      answer,
                      "what is wrong with them",
                      truth};
}

class Peer {
 public:
  explicit Peer(const PeerOptions& options)
      : options_(options),
        dialogue_(options.command, scratch_.path() / "dialogue", options.limits, options.is_cancelled) {}

  // No program has to accept a file without points, so no program is asked about it.
  std::optional<Disagreement> judge(const fuzz::Input& input) {
    if (input.rows.empty()) return std::nullopt;
    std::optional<Disagreement> found = options_.is_dialogue ? judge_reply(input) : judge_file(input);
    return found && is_among(options_.ignored, found->kind) ? std::nullopt : found;
  }

 private:
  std::optional<Disagreement> judge_file(const fuzz::Input& input) {
    std::ostringstream rows;
    rows << input;
    const ScratchFolder folder(scratch_.path() / fmt::format("{}-{}", ::getpid(), ++runs_));
    const CommandRun run = run_in(folder.path(), rows.str());
    const std::optional<Disagreement> found = bad_ending(run, options_.limits);
    return found ? found : judge_run(input, run);
  }

  std::optional<Disagreement> judge_reply(const fuzz::Input& input) {
    const CaseReply reply = reply_to(input);
    switch (reply.silence) {
      case Silence::kCancelled:
        throw property::MachineFailure("stopped by a signal");
      case Silence::kLate:
        return ending(kLate, fmt::format("no answer after {} s; is each answer flushed, in Python by "
                                         "print(..., flush=True)?",
                                         options_.limits.seconds));
      case Silence::kUnreadable:
        return ending("unreadable", one_line(reply.reason));
      case Silence::kEnded:
        if (const auto found = bad_ending(reply.run, options_.limits)) return found;
        return ending("unreadable", "it ended before it had answered");
      case Silence::kNone:
        break;
    }
    if (reply.answer.is_refusal) return ending("refusal", one_line("refused: " + reply.answer.text));
    return unless_unreadable("answer", [&] { return judge_answer(input, reply.answer.text); });
  }

  [[nodiscard]] CaseReply reply_to(const fuzz::Input& input) {
    try {
      return dialogue_.ask(property::rows_of(input));
    } catch (const OutputError& error) {
      throw property::MachineFailure(error.what());
    }
  }

  [[nodiscard]] std::optional<Disagreement> judge_answer(const fuzz::Input& input, const std::string& text) const {
    require_not_endless(text, input.rows.size());
    const FlowComplex& complex = property::subject_of(input).complex;
    const io::ThrowsOutOfMemory throws;
    const CheckReport report =
        check(complex.points(), claim_of_answer(text, complex.points()), *fast_truth(complex), options_.check);
    return wrong_claim(report, text, options_.ignored);
  }

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

  [[nodiscard]] std::optional<Disagreement> judge_run(const fuzz::Input& input, const CommandRun& run) const {
    return unless_unreadable(run.answer_name, [&] {
      const FlowComplex& complex = property::subject_of(input).complex;
      const io::ThrowsOutOfMemory throws;
      const std::string bytes = answer_bytes(run);
      return options_.judges_pairs ? judge_pairs(complex, bytes, run.answer_name)
                                   : judge_claim(complex, bytes, run.answer_name);
    });
  }

  template <typename Judge>
  static std::optional<Disagreement> unless_unreadable(const std::string& name, const Judge& judge) {
    try {
      return judge();
    } catch (const InvalidInput& error) {
      return ending("unreadable", one_line(error.what()));
    } catch (const nlohmann::json::exception& error) {
      return ending("unreadable", one_line(fmt::format("{}: {}", name, error.what())));
    } catch (const std::bad_alloc&) {
      return ending("unreadable", name + ": too large to be read");
    }
  }

  [[nodiscard]] std::optional<Disagreement> judge_pairs(const FlowComplex& complex, const std::string& bytes,
                                                        const std::string& name) const {
    const std::vector<ClaimedPair> claimed = claimed_pairs_of(io::without_byte_order_mark(bytes), name);
    return wrong_pairs(pair_differences(claimed, listed_pairs(complex), options_.check.tolerance), bytes,
                       options_.ignored);
  }

  [[nodiscard]] std::optional<Disagreement> judge_claim(const FlowComplex& complex, const std::string& bytes,
                                                        const std::string& name) const {
    const Claim claim = read_claim_from(bytes, name);
    require_rows(claim, complex.points(), name);
    const CheckReport report = check(complex.points(), claim, *fast_truth(complex), options_.check);
    return wrong_claim(report, bytes, options_.ignored);
  }

  PeerOptions options_;
  ScratchFolder scratch_;
  std::size_t runs_ = 0;
  CaseDialogue dialogue_;  // goes before the folder does
};

}  // namespace

std::vector<std::string> peer_kinds() {
  std::vector<std::string> kinds = {"signal", kLate, "refusal", "unreadable", "not-started", "wrong-pair"};
  for (int k = 0; k <= static_cast<int>(FindingReason::kWrongPocket); ++k) {
    const auto reason = static_cast<FindingReason>(k);
    if (reason != FindingReason::kAmbiguous) kinds.emplace_back(reason_text(reason));
  }
  return kinds;
}

property::Property peer_property(const PeerOptions& options) {
  auto peer = std::make_shared<Peer>(options);
  return {.name = options.judges_pairs ? kPeerPairsProperty : kPeerProperty,
          .description =
              options.judges_pairs ? "the command's persistence pairs are right" : "what the command claims is right",
          .shrinking_budget = options.is_dialogue ? kShrinkingBudgetOfDialogue : kShrinkingBudget,
          .slow_kind = kLate,
          .slow_shrinking_budget = kLateShrinkingBudget,
          .check = [peer](const property::Trial& trial) { return peer->judge(trial.input); }};
}

}  // namespace flowcert::judge
