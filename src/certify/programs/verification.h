// Reads a program's answers to cases (asked_cases.h) one by one from a stream (src/cli/manual/cases.md), and judges
// them.
//
// Guarantees: every case of the run has one outcome in the end, the unanswered ones too. Answers are judged one at a
// time and forgotten. What is kept is a byte for each case, and a few findings for each of the first failing cases by
// number, as many as asked for, and for the smallest case of each reason.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/layer.h"
#include "certify/other_truth.h"
#include "certify/pair_differences.h"
#include "certify/programs/asked_cases.h"
#include "certify/truth.h"
#include "flowcert/claim.h"
#include "flowcert/profile.h"
#include "io/line_reader.h"

namespace flowcert::certify {

// ---- Answers ----
// Memory is bounded by the largest answer. The reader only looks where an answer begins and ends. If that is not
// clear, it throws InvalidInput, "standard input:LINE: reason". A stream may end anywhere: what it breaks off is no
// answer, and no fault.

inline constexpr std::string_view kStandardInput = "standard input";

struct Answer {
  LinePlace place;  // of its first line
  std::string id;
  bool is_refusal = false;
  // A claim, line by line as it came; of a refusal, the reason, which may be empty.
  std::string text;
  bool is_cut = false;  // the stream ends before its `end`
};

class AnswerReader {
 public:
  // `name` is what reasons call the stream. It must last.
  explicit AnswerReader(std::istream& in, std::string_view name = kStandardInput) : in_(in), name_(name) {}

  // The next answer; false at the end of the stream.
  bool next(Answer& answer);
  // Where the stream broke off an answer or a line: "standard input:7: it ends within a line: 'answ'"; else empty.
  [[nodiscard]] const std::string& cut() const { return cut_; }

 private:
  bool next_line();
  void read_head(Answer& answer) const;
  void read_claim_lines(Answer& answer);
  [[nodiscard]] LinePlace place() const;
  void note_cut(const std::string& what);

  std::istream& in_;
  std::string_view name_;
  std::string cut_;
  std::string line_;  // the last one read, without its LF; a CR is a blank to all who look at it
  std::size_t number_ = 0;
};

// To a case of so many rows. Throws InvalidInput if the text is longer than any answer can need.
void require_not_endless(const std::string& text, std::size_t rows);
// The claim of an answer, which may have no lines. Throws InvalidInput.
[[nodiscard]] Claim claim_of_answer(const std::string& text, const PointSet& points);

// ---- Outcomes ----

// In the order in which reports list them.
enum class Outcome : std::uint8_t {
  kConforms,
  kConformsWhereDetermined,
  kPerturbed,
  kFails,
  kUnreadable,
  kRefused,
  kUnanswered
};
inline constexpr std::size_t kOutcomes = 7;
// "conforms", "conforms where determined", "perturbed", "fails", "unreadable", "refused", "unanswered"
[[nodiscard]] const char* outcome_text(Outcome outcome);
[[nodiscard]] bool is_right(Outcome outcome);

using OutcomeCounts = std::array<std::size_t, kOutcomes>;
using CountsByName = std::vector<std::pair<std::string, OutcomeCounts>>;

inline constexpr std::size_t kMostFindingsKept = 10;

// A case whose answer is wrong.
struct FailedCase {
  std::string id;
  Outcome outcome = Outcome::kFails;
  std::string reason;                         // of a refusal, or why the answer is unreadable; else empty
  std::vector<Finding> findings;              // the first kMostFindingsKept that are wrong
  std::vector<PairDifference> pair_findings;  // the same, of persistence pairs
  std::size_t wrong = 0;                      // how many there are
};

// The cases in which something is wrong for one reason, and the smallest one of them.
struct CasesOfReason {
  std::size_t cases = 0;
  std::size_t points = 0;  // of the smallest case; the first by number, if several are
  std::size_t number = 0;
  FailedCase smallest;  // with the first finding of this reason alone
};

struct VerificationOptions {
  CheckOptions check;
  OtherTruth oracle;       // of vectors, and
  bool by_oracle = false;  // of drawn inputs that it takes
  DrawnCasesOf drawn;
  bool judges_pairs = false;  // answers are persistence pairs, not claims
  std::optional<std::size_t> only;
  std::vector<std::size_t> asked;  // numbers, ascending, of the cases that are asked; empty: all
  std::size_t most_failures_kept = 0;
  std::string folder;  // for points and claims of failing cases; empty: not kept
};

class Verification {
 public:
  // given: the cases that are asked, of which all that has no answer is missing. Without, they are those of the first
  // answer's run.
  explicit Verification(VerificationOptions options, std::unique_ptr<AskedCases> given = nullptr);

  // Judges an answer; one that is cut leaves its case unanswered. Throws InvalidInput, with the answer's place, if the
  // id is of no case, of a case that is not asked, or of a case that has been answered. Throws OutputError if the
  // folder cannot be written.
  void take(const Answer& answer);

  // Whether it is known which cases are asked. Before that, nothing else may be asked.
  [[nodiscard]] bool has_begun() const { return cases_ != nullptr; }
  // Whether somebody else than the program under test says so.
  [[nodiscard]] bool is_given() const { return is_given_; }

  [[nodiscard]] const VerificationOptions& options() const { return options_; }
  [[nodiscard]] const AskedCases& cases() const { return *cases_; }
  // Whether the cases are conformance vectors, which say themselves what is right.
  [[nodiscard]] bool is_stored() const { return cases_->is_stored(); }
  // How many answers are expected, and were taken.
  [[nodiscard]] std::size_t expected() const;
  [[nodiscard]] std::size_t taken() const { return taken_; }
  // How many of these are not right.
  [[nodiscard]] std::size_t wrong() const { return wrong_; }

  [[nodiscard]] OutcomeCounts counts() const;
  // By name, in the order of the cases' families and flags; without those that have no case.
  [[nodiscard]] CountsByName counts_by_family() const;
  [[nodiscard]] CountsByName counts_by_flag() const;
  [[nodiscard]] Verdict verdict() const;

  // By number.
  [[nodiscard]] const std::map<std::size_t, FailedCase>& failures() const { return failures_; }
  // By reason of a finding, or "unreadable" or "refused". A case counts for each of its reasons.
  [[nodiscard]] const std::map<std::string, CasesOfReason>& reasons() const { return reasons_; }
  // The first and the last number of each range, ascending.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> unanswered_ranges() const;

  // Numbers of cases: with anything claimed in decimals; with anything that was not judged, as indices that were not
  // asked; too large for the oracle, though it was asked for.
  [[nodiscard]] std::size_t approximate() const { return approximate_; }
  [[nodiscard]] std::size_t partly_judged() const { return partly_judged_; }
  [[nodiscard]] std::size_t too_large() const { return too_large_; }
  // What all answers that were judged cover (FC-CLAIM-22).
  [[nodiscard]] const Profile& profile() const { return profile_; }

  // Where points and claim of a failing case are kept, without the endings .xyz and .claim.
  [[nodiscard]] std::string kept_path(std::size_t number) const;

 private:
  AskedCase case_of(const Answer& answer);
  FailedCase judge(const AskedCase& one, const Answer& answer);
  void judge_claim(const AskedCase& one, const Answer& answer, FailedCase& result);
  void judge_pairs(const AskedCase& one, const Answer& answer, FailedCase& result);
  std::vector<ListedPair> pairs_of(const AskedCase& one);
  std::unique_ptr<Truth> truth_of(const AskedCase& one, const PointSet& points);
  // False, and counted, of a case that is too large for it.
  bool asks_oracle(const AskedCase& one, std::size_t most_points);
  // Counts the case for a reason. Returns the place of its finding if it is the smallest case so far.
  FailedCase* count_reason(const AskedCase& one, const FailedCase& failed, const std::string& reason);
  void keep(const AskedCase& one, const Answer& answer) const;
  [[nodiscard]] CountsByName counts_by(const std::vector<std::string>& names,
                                       const std::function<std::vector<std::string>(std::size_t)>& names_of) const;
  void begin(std::unique_ptr<AskedCases> cases);
  [[nodiscard]] bool is_expected(std::size_t number) const;

  VerificationOptions options_;
  std::unique_ptr<AskedCases> cases_;  // none before the first answer, if they are not given
  bool is_given_ = false;
  std::vector<Outcome> outcomes_;  // by number
  std::map<std::size_t, FailedCase> failures_;
  std::map<std::string, CasesOfReason> reasons_;
  std::size_t taken_ = 0;
  std::size_t wrong_ = 0;
  std::size_t approximate_ = 0;
  std::size_t partly_judged_ = 0;
  std::size_t too_large_ = 0;
  Profile profile_;
};

}  // namespace flowcert::certify
