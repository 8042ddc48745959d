// Runs conformance vectors in parallel. A case takes one run of the command, one of the orbit command for each start,
// and one of the persistence command.
#include "certify/programs/conformance_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <new>

#include "certify/finding_words.h"
#include "certify/programs/command_run.h"
#include "certify/viewer_claim.h"
#include "flowcert/claim.h"
#include "geometry/parallel_for.h"
#include "io/input_bytes.h"
#include "io/number_text.h"
#include "io/out_of_memory.h"
#include "io/output_file.h"

namespace flowcert::certify {

// ---- Words ----

const char* run_outcome_text(RunOutcome outcome) {
  constexpr std::array<const char*, kRunOutcomes> kTexts = {"conforms",  "conforms where determined",
                                                            "perturbed", "properly refused",
                                                            "skipped",   "fails",
                                                            "accepted",  "refused",
                                                            "crashed",   "timed out",
                                                            "unreadable"};
  return kTexts.at(static_cast<std::size_t>(outcome));
}

std::string finding_words(const Finding& finding) {
  return one_line(fmt::format("level {}: {} [{}]: claimed {}; truth: {}", finding.level, reason_text(finding.reason),
                              finding.clause, finding.claimed, finding.truth));
}

std::string orbit_finding_words(const OrbitFinding& finding) {
  return one_line(fmt::format("orbit from {}: claimed {}; truth: {}", finding.start, finding.difference.claimed,
                              finding.difference.truth));
}

std::string persistence_finding_words(const PairDifference& difference) {
  return one_line(fmt::format("persistence{}: claimed {}; truth: {}",
                              difference.reason == "rounding" ? ", rounding" : "", difference.claimed,
                              difference.truth));
}

// ---- A case ----

namespace {

namespace fs = std::filesystem;

constexpr char kOrbitName[] = "orbit.json";
constexpr char kPersistenceName[] = "persistence";

// The copy replaces what an earlier run may have left.
void copy_if_regular(const fs::path& from, const fs::path& to) {
  fs::remove(to);
  std::error_code ignored;
  if (fs::is_regular_file(from, ignored)) fs::copy_file(from, to);
}

class CaseRun {
 public:
  CaseRun(const VectorCase& one, const ConformanceOptions& options, const fs::path& folder,
          const std::function<bool()>& is_cancelled)
      : case_(one), options_(options), folder_(folder), is_cancelled_(is_cancelled) {
    result_.of = &one;
  }

  CaseOutcome result() {
    const auto points = point_file_text(case_, options_.points);
    if (!points) {
      result_.message = "is about the text of an XYZ file";
    } else if (case_.refused_start && options_.orbit_command.empty()) {
      result_.message = "has a start, and there is no --orbits-against";
    } else {
      points_ = *points;
      answer_case();
    }
    return std::move(result_);
  }

 private:
  void answer_case() {
    if (case_.refused_start) return expect_refusal(run_orbit(*case_.refused_start));
    if (case_.is_invalid()) return expect_refusal(run_claim());
    result_.outcome = RunOutcome::kConforms;
    judge_claim(run_claim());
    judge_orbits();
    if (case_.persistence && !options_.persistence_command.empty()) judge_persistence(run_persistence());
  }

  void judge_orbits() {
    if (options_.orbit_command.empty()) return;
    for (const CaseOrbit& orbit : case_.orbits) {
      const CommandRun run = run_orbit(orbit.start);
      if (!ends_well(run) || !judge_orbit(run, orbit)) return;
    }
    if (!case_.orbits.empty()) tell(ProfilePart::kOrbits, true);
  }

  // ---- Running

  CommandRun run_claim() {
    CommandRun claim = run(options_.command, options_.out_name, {});
    claim_folder_ = claim.folder;
    return claim;
  }
  CommandRun run_orbit(const std::string& start) {
    return run(options_.orbit_command, kOrbitName, {{"{start}", start}});
  }
  CommandRun run_persistence() { return run(options_.persistence_command, kPersistenceName, {}); }

  CommandRun run(const std::string& command, const std::string& out_name,
                 const std::vector<std::pair<std::string, std::string>>& values) {
    CommandRun run = run_command({command, point_file_name(options_.points), points_, out_name, values},
                                 folder_ / fmt::format("{}", ++runs_), options_.limits, is_cancelled_);
    result_.seconds += run.end.seconds;
    return run;
  }

  // ---- How a run ends

  // The first negative outcome decides the case, and its run is kept.
  void fail(const CommandRun& run, RunOutcome outcome, const std::string& message) {
    if (outcome != RunOutcome::kFails) add_reason(one_word(run_outcome_text(outcome)), message);
    if (is_negative(result_.outcome)) return;
    result_.outcome = outcome;
    result_.message = message;
    if (!options_.keep.empty()) keep(run);
  }

  static std::string one_word(std::string text) {
    std::ranges::replace(text, ' ', '-');
    return text;
  }

  void add_reason(const std::string& reason, const std::string& example) {
    const bool is_known = std::ranges::find(result_.reasons, reason, &CaseReason::reason) != result_.reasons.end();
    if (!is_known) result_.reasons.push_back({reason, example});
  }

  void keep(const CommandRun& run) const {
    const fs::path folder = fs::path(options_.keep) / case_.id;
    fs::create_directories(folder);
    write_text_file(folder / point_file_name(options_.points), points_);
    write_text_file(folder / "case.json", case_.json + "\n");
    copy_if_regular(run.out(), folder / "stdout");
    copy_if_regular(run.err(), folder / "stderr");
    if (run.answer != run.out()) copy_if_regular(run.answer, folder / run.answer_name);
    if (!case_.rows.empty()) keep_page(run, folder);
  }

  // The points in a page and, if they were claimed, what is wrong with the critical points.
  void keep_page(const CommandRun& run, const fs::path& folder) const {
    std::optional<ClaimText> claim;
    if (run.folder == claim_folder_) {
      try {
        claim = {answer_bytes(run), run.answer_name};
      } catch (const InvalidInput&) {
        // There is no answer. The page then has the points alone.
      }
    }
    io::write_whole_file((folder / kPageName).string(), [&](std::ostream& page) {
      write_claim_page(page, PointSet(case_.rows), case_.id, claim, options_.check);
    });
  }

  // Returns false if the program said neither yes nor no, because it crashed, was late or was cancelled.
  bool comes_to_an_end(const CommandRun& run) {
    const ProgramEnd& end = run.end;
    if (end.ending == ProgramEnding::kTimedOut) {
      fail(run, RunOutcome::kTimedOut, fmt::format("not done after {} s", options_.limits.seconds));
    } else if (end.ending == ProgramEnding::kSignalled) {
      fail(run, RunOutcome::kCrashed, signal_text(end.number));
    } else if (was_not_started(end)) {
      fail(run, RunOutcome::kCrashed, "not started: " + status_text(run));
    } else {
      return end.ending == ProgramEnding::kExited;
    }
    return false;
  }

  bool ends_well(const CommandRun& run) {
    if (!comes_to_an_end(run)) return false;
    if (run.end.number != 0) fail(run, RunOutcome::kRefused, status_text(run));
    return run.end.number == 0;
  }

  void expect_refusal(const CommandRun& run) {
    if (!comes_to_an_end(run)) return;
    if (run.end.number == 0) return fail(run, RunOutcome::kAccepted, "exit status 0");
    result_.outcome = RunOutcome::kProperlyRefused;
    result_.message = status_text(run);
  }

  // ---- What it answers

  // Calls read(bytes). Returns false if the answer cannot be read.
  template <typename Read>
  bool read_answer(const CommandRun& run, const Read& read) {
    const io::ThrowsOutOfMemory throws;
    try {
      read(answer_bytes(run));
      return true;
    } catch (const InvalidInput& error) {
      fail(run, RunOutcome::kUnreadable, one_line(error.what()));
    } catch (const Json::exception& error) {
      fail(run, RunOutcome::kUnreadable, one_line(fmt::format("{}: {}", run.answer_name, error.what())));
    } catch (const std::bad_alloc&) {
      fail(run, RunOutcome::kUnreadable, run.answer_name + ": too large to be read");
    }
    return false;
  }

  void judge_claim(const CommandRun& run) {
    if (!ends_well(run)) return;
    const PointSet points(case_.rows);
    Claim claim;
    const bool is_read = read_answer(run, [&](const std::string& bytes) {
      claim = read_claim_from(bytes, run.answer_name);
      require_rows(claim, points, run.answer_name);
    });
    if (!is_read) return;
    take(run, check(points, claim, *options_.truth.of_vector(case_), options_.check));
  }

  void take(const CommandRun& run, CheckReport report) {
    for (std::size_t k = 0; k < kLevels; ++k) result_.judged.at(k) = report.conforms.at(k).has_value();
    result_.profile = report.profile;
    auto& findings = report.findings;
    std::ranges::stable_sort(findings, {}, &Finding::is_variation);  // what is wrong comes first
    if (report.verdict == Verdict::kFails) {
      result_.level = findings.front().level;
      for (const Finding& finding : first_of_each_reason(findings)) {
        add_reason(reason_text(finding.reason), finding_words(finding));
      }
      fail(run, RunOutcome::kFails, finding_words(telling_finding(findings)));
    } else if (report.verdict != Verdict::kConforms) {
      const bool is_perturbed = report.verdict == Verdict::kPerturbed;
      result_.outcome = is_perturbed ? RunOutcome::kPerturbed : RunOutcome::kConformsWhereDetermined;
      result_.message = finding_words(*std::ranges::find(findings, report.verdict, verdict_on));
    }
    result_.is_decided = report.not_decided.empty();
    const std::size_t kept = std::min(findings.size(), kMostFindings);
    result_.findings_left_out = findings.size() - kept;
    result_.findings.assign(findings.begin(), findings.begin() + static_cast<std::ptrdiff_t>(kept));
  }

  bool judge_orbit(const CommandRun& run, const CaseOrbit& orbit) {
    OrbitPath claimed;
    const bool is_read = read_answer(run, [&](const std::string& bytes) {
      claimed = claimed_orbit_of(io::without_byte_order_mark(bytes), run.answer_name);
    });
    if (!is_read) return false;
    ++result_.orbits_judged;
    const PointSet points(case_.rows);
    const auto difference = path_difference(claimed, orbit.path, points, *options_.truth.of_vector(case_));
    if (!difference) return true;
    result_.orbit_findings.push_back({orbit.start, *difference});
    const std::string words = orbit_finding_words(result_.orbit_findings.back());
    if (!difference->is_permitted) {
      add_reason("wrong-orbit", words);
      fail(run, RunOutcome::kFails, words);
    } else if (result_.outcome < RunOutcome::kPerturbed) {
      result_.outcome = RunOutcome::kPerturbed;
      result_.message = words;
    }
    return true;
  }

  void judge_persistence(const CommandRun& run) {
    if (!ends_well(run)) return;
    std::vector<ClaimedPair> claimed;
    const bool is_read = read_answer(run, [&](const std::string& bytes) {
      claimed = claimed_pairs_of(io::without_byte_order_mark(bytes), run.answer_name);
    });
    if (!is_read) return;
    result_.is_persistence_judged = true;
    tell(ProfilePart::kPersistence, std::ranges::all_of(claimed, is_exact_pair));
    auto differences = pair_differences(claimed, *case_.persistence, options_.check.tolerance);
    if (differences.empty()) return;
    for (const PairDifference& difference : differences) {
      add_reason(difference.reason, persistence_finding_words(difference));
    }
    fail(run, RunOutcome::kFails, persistence_finding_words(differences.front()));
    if (differences.size() > kMostFindings) differences.resize(kMostFindings);
    result_.persistence_findings = std::move(differences);
  }

  // Adds to the profile a part that is no part of a claim.
  void tell(ProfilePart part, bool is_exact) {
    if (!result_.profile) return;
    result_.profile->set(part, Profile::State::kCovered);
    result_.profile->set_exact(result_.profile->is_exact() && is_exact);
  }

  const VectorCase& case_;
  const ConformanceOptions& options_;
  const fs::path& folder_;
  const std::function<bool()>& is_cancelled_;
  std::string points_;
  std::size_t runs_ = 0;
  fs::path claim_folder_;  // of the run that was asked for the claim
  CaseOutcome result_;
};

}  // namespace

// ---- All cases ----

// Each thread takes the next case, until there is none, or until one of them cannot go on.
std::vector<CaseOutcome> run_conformance(const std::vector<const VectorCase*>& cases, const ConformanceOptions& options,
                                         const std::function<void(std::size_t done, std::size_t total)>& progress) {
  std::vector<CaseOutcome> outcomes(cases.size());  // each is written by one worker
  const ScratchFolder scratch;
  std::atomic<bool> has_failed{false};
  std::mutex mutex;  // for what follows
  std::size_t done = 0;
  std::exception_ptr failure;
  const std::function<bool()> is_over = [&] { return has_failed || Interruption::signal() != 0; };
  geometry::parallel_for(cases.size(), options.jobs, [&](std::size_t k) {
    if (is_over()) return;
    try {
      const ScratchFolder folder(scratch.path() / cases[k]->id);
      outcomes[k] = CaseRun(*cases[k], options, folder.path(), is_over).result();
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex);
      const std::string why = fmt::format("{}: {}", cases[k]->id, error.what());
      if (!failure) failure = std::make_exception_ptr(std::runtime_error(why));
      has_failed = true;
    }
    const std::lock_guard lock(mutex);
    progress(++done, cases.size());
  });
  if (Interruption::signal() != 0) throw Interrupted{Interruption::signal()};
  if (failure) std::rethrow_exception(failure);
  return outcomes;
}

}  // namespace flowcert::certify
