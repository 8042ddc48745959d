// A stream can be cut at three words, because no claim format has a line that begins with one of them.
#include "certify/programs/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <istream>
#include <ostream>
#include <set>
#include <tuple>

#include "certify/finding_words.h"
#include "flowcert/claim.h"
#include "flowcert/flow_complex.h"
#include "io/input_bytes.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::certify {

// ---- Answers ----

namespace {

constexpr std::string_view kAnswer = "answer";
constexpr std::string_view kRefused = "refused";
constexpr std::string_view kEnd = "end";
constexpr std::size_t kMostAnswerBytes = std::size_t{1} << 28;

std::string_view first_word(std::string_view line) {
  std::string_view word;
  Fields(line, Separators::kBlanks).next(word);
  return word;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

LinePlace AnswerReader::place() const { return {.file = name_, .line = number_}; }

void AnswerReader::note_cut(const std::string& what) {
  cut_ = fmt::format("{}:{}: it ends within {}", name_, number_, what);
}

bool AnswerReader::next_line() {
  if (!std::getline(in_, line_)) {
    if (in_.bad()) reject_file(name_, "cannot be read");
    return false;
  }
  ++number_;
  return true;
}

void AnswerReader::read_head(Answer& answer) const {
  const std::string_view word = first_word(line_);
  if (word != kAnswer && word != kRefused) {
    place().reject("neither 'answer ID' nor 'refused ID': " + in_quotes(line_));
  }
  std::string_view rest = without_blanks(line_);
  rest = without_blanks(rest.substr(word.size()));
  const std::string_view id = first_word(rest);
  if (id.empty()) place().reject("no id of a case after " + in_quotes(word));
  rest = without_blanks(rest.substr(id.size()));
  answer = {.place = place(), .id = std::string(id), .is_refusal = word == kRefused, .text = {}, .is_cut = false};
  if (answer.is_refusal) {
    answer.text = rest;
  } else if (!rest.empty()) {
    place().reject("more than an id after 'answer': " + in_quotes(rest));
  }
}

void AnswerReader::read_claim_lines(Answer& answer) {
  while (next_line()) {
    const std::string_view word = first_word(line_);
    if (word == kEnd && without_blanks(line_) == kEnd) return;
    if (word == kAnswer || word == kRefused) {
      place().reject(in_quotes(word) + " before the 'end' of the answer of line " + std::to_string(answer.place.line));
    }
    // The end of a text that is too long is not kept.
    if (answer.text.size() > kMostAnswerBytes) continue;
    answer.text += line_;
    answer.text += '\n';
  }
  answer.is_cut = true;
  note_cut("the answer to " + in_quotes(answer.id));
}

bool AnswerReader::next(Answer& answer) {
  std::string_view word;
  do {
    if (!next_line()) return false;
    word = first_word(line_);
  } while (word.empty() || word.starts_with('#'));
  // A head without a line break may lack a part of its id.
  if (in_.eof() && (kAnswer.starts_with(word) || kRefused.starts_with(word))) {
    note_cut("a line: " + in_quotes(line_));
    return false;
  }
  read_head(answer);
  if (!answer.is_refusal) read_claim_lines(answer);
  return true;
}

// ---- Outcomes ----

namespace {

bool is_empty(const std::string& text) { return std::all_of(text.begin(), text.end(), is_blank); }

// A set of n points has at most 2 n^2 + n vertices, edges, facets and cells in its Delaunay triangulation, and so no
// more critical points. An answer has room for twice as many, and for lines of other kinds. A program that never comes
// to an end is stopped here: a line takes up to 3 KB when it is judged.
std::size_t most_lines(std::size_t rows) { return 1000 + 4 * rows * rows; }

std::size_t count_of_lines(std::string_view text) {
  LineReader lines(text, kAnswer);
  std::string_view line;
  std::size_t count = 0;
  while (lines.next_uncommented(line)) ++count;
  return count;
}

}  // namespace

void require_not_endless(const std::string& text, std::size_t rows) {
  if (text.size() > kMostAnswerBytes) reject_file("answer", fmt::format("more than {} bytes", kMostAnswerBytes));
  const std::size_t most = most_lines(rows);
  if (count_of_lines(text) > most) reject_file("answer", fmt::format("more than {} lines for {} points", most, rows));
}

// An answer without lines claims that there is no critical point. The readers of files would refuse it, as an empty
// file.
Claim claim_of_answer(const std::string& text, const PointSet& points) {
  Claim claim;
  if (is_empty(text)) {
    claim.format = "csv";
    return claim;
  }
  claim = read_claim_from(text, "answer");
  require_rows(claim, points, "answer");
  return claim;
}

namespace {

// What a program says of itself must not reach a terminal raw.
std::string printable(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  return text;
}

Outcome outcome_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kConforms:
      return Outcome::kConforms;
    case Verdict::kConformsWhereDetermined:
      return Outcome::kConformsWhereDetermined;
    case Verdict::kPerturbed:
      return Outcome::kPerturbed;
    default:
      return Outcome::kFails;
  }
}

void write_file(const std::string& path, const std::string& content) {
  io::write_whole_file(path, [&](std::ostream& out) { out << content; });
}

}  // namespace

const char* outcome_text(Outcome outcome) {
  constexpr std::array<const char*, kOutcomes> kTexts = {
      "conforms", "conforms where determined", "perturbed", "fails", "unreadable", "refused", "unanswered"};
  return kTexts.at(static_cast<std::size_t>(outcome));
}

bool is_right(Outcome outcome) { return outcome <= Outcome::kPerturbed; }

Verification::Verification(VerificationOptions options, std::unique_ptr<AskedCases> given)
    : options_(std::move(options)), is_given_(given != nullptr) {
  if (given) begin(std::move(given));
}

void Verification::begin(std::unique_ptr<AskedCases> cases) {
  cases_ = std::move(cases);
  outcomes_.assign(cases_->size(), Outcome::kUnanswered);
  if (!cases_->most_points()) return;
  if (!options_.only) {
    if (options_.asked.empty()) options_.asked = cases_->asked_numbers();
  } else if (*options_.only < cases_->size() && !cases_->asks(cases_->numbered(*options_.only))) {
    throw InvalidInput(fmt::format("--case: case {} has more points than --most-points says", *options_.only));
  }
}

bool Verification::is_expected(std::size_t number) const {
  if (options_.only) return *options_.only == number;
  return options_.asked.empty() || std::ranges::binary_search(options_.asked, number);
}

std::size_t Verification::expected() const {
  if (options_.only) return 1;
  return options_.asked.empty() ? outcomes_.size() : options_.asked.size();
}

AskedCase Verification::case_of(const Answer& answer) {
  try {
    if (!has_begun()) begin(cases_with(answer.id, options_.drawn));
    return cases_->named(answer.id);
  } catch (const InvalidInput& error) {
    answer.place.reject(error.what());
  }
}

bool Verification::asks_oracle(const AskedCase& one, std::size_t most_points) {
  const bool is_small = one.rows.size() <= most_points;
  too_large_ += options_.by_oracle && !is_small ? 1 : 0;
  return options_.by_oracle && is_small;
}

std::unique_ptr<Truth> Verification::truth_of(const AskedCase& one, const PointSet& points) {
  if (const VectorCase* const stored = cases_->stored(one.number)) return options_.oracle.of_vector(*stored);
  return asks_oracle(one, options_.oracle.most_points) ? options_.oracle.of(one.rows) : fast_truth(points);
}

FailedCase* Verification::count_reason(const AskedCase& one, const FailedCase& failed, const std::string& reason) {
  CasesOfReason& of = reasons_[reason];
  const std::pair size(one.rows.size(), one.number);
  if (of.cases++ > 0 && std::pair(of.points, of.number) <= size) return nullptr;
  std::tie(of.points, of.number) = size;
  of.smallest = failed;
  of.smallest.findings.clear();
  of.smallest.pair_findings.clear();
  return &of.smallest;
}

void Verification::judge_claim(const AskedCase& one, const Answer& answer, FailedCase& result) {
  const PointSet points(one.rows);
  const Claim claim = claim_of_answer(answer.text, points);
  CheckReport report = check(points, claim, *truth_of(one, points), options_.check);
  result.outcome = outcome_of(report.verdict);
  profile_.join(report.profile);
  approximate_ += report.is_exact ? 0 : 1;
  partly_judged_ += report.not_judged.empty() ? 0 : 1;
  std::erase_if(report.findings, [](const Finding& finding) { return finding.is_variation; });
  result.wrong = report.findings.size();
  for (const Finding& finding : first_of_each_reason(report.findings)) {
    FailedCase* const smallest = count_reason(one, result, reason_text(finding.reason));
    if (smallest != nullptr) smallest->findings.push_back(finding);
  }
  if (report.findings.size() > kMostFindingsKept) report.findings.resize(kMostFindingsKept);
  result.findings = std::move(report.findings);
}

void Verification::judge_pairs(const AskedCase& one, const Answer& answer, FailedCase& result) {
  const std::vector<ClaimedPair> claimed = claimed_pairs_of(io::without_byte_order_mark(answer.text), "answer");
  const bool is_exact = std::ranges::all_of(claimed, is_exact_pair);
  approximate_ += is_exact ? 0 : 1;
  Profile profile;
  profile.set(ProfilePart::kPersistence, Profile::State::kCovered);
  profile.set_exact(is_exact);
  profile_.join(profile);
  auto differences = pair_differences(claimed, pairs_of(one), options_.check.tolerance);
  result.outcome = differences.empty() ? Outcome::kConforms : Outcome::kFails;
  result.wrong = differences.size();
  std::set<std::string> known;
  for (const PairDifference& difference : differences) {
    const std::string reason = difference.reason;
    if (!known.insert(reason).second) continue;
    FailedCase* const smallest = count_reason(one, result, reason);
    if (smallest != nullptr) smallest->pair_findings.push_back(difference);
  }
  if (differences.size() > kMostFindingsKept) differences.resize(kMostFindingsKept);
  result.pair_findings = std::move(differences);
}

std::vector<ListedPair> Verification::pairs_of(const AskedCase& one) {
  const VectorCase* const stored = cases_->stored(one.number);
  if (stored != nullptr && stored->persistence) return *stored->persistence;
  return asks_oracle(one, options_.oracle.most_points_of_pairs) ? options_.oracle.pairs_of(one.rows)
                                                                : listed_pairs(FlowComplex(PointSet(one.rows)));
}

FailedCase Verification::judge(const AskedCase& one, const Answer& answer) {
  FailedCase result;
  result.id = answer.id;
  try {
    require_not_endless(answer.text, one.rows.size());
    if (answer.is_refusal) {
      result.outcome = Outcome::kRefused;
      result.reason = printable(answer.text);
    } else if (options_.judges_pairs) {
      judge_pairs(one, answer, result);
    } else {
      judge_claim(one, answer, result);
    }
  } catch (const InvalidInput& error) {
    result.outcome = Outcome::kUnreadable;
    result.reason = error.what();
  }
  if (!result.reason.empty() || answer.is_refusal) count_reason(one, result, outcome_text(result.outcome));
  return result;
}

void Verification::take(const Answer& answer) {
  const AskedCase one = case_of(answer);
  if (!is_expected(one.number)) {
    const char* const what =
        options_.only ? "not the case that --case names: " : "not among the cases that are asked: ";
    answer.place.reject(what + in_quotes(answer.id));
  }
  if (outcomes_.at(one.number) != Outcome::kUnanswered) {
    answer.place.reject("a second answer to the case " + in_quotes(answer.id));
  }
  if (answer.is_cut) return;
  FailedCase result = judge(one, answer);
  outcomes_[one.number] = result.outcome;
  ++taken_;
  if (is_right(result.outcome)) return;
  ++wrong_;
  if (!options_.folder.empty()) keep(one, answer);
  failures_.emplace(one.number, std::move(result));
  if (failures_.size() > options_.most_failures_kept) failures_.erase(std::prev(failures_.end()));
}

std::string Verification::kept_path(std::size_t number) const {
  return options_.folder + "/" + cases_->file_name(number);
}

void Verification::keep(const AskedCase& one, const Answer& answer) const {
  std::error_code failure;
  std::filesystem::create_directories(options_.folder, failure);
  if (failure) throw OutputError(options_.folder + ": cannot be written: " + failure.message());
  const std::string path = kept_path(one.number);
  // The file is never empty, because no reader takes an empty file.
  write_file(path + ".xyz", "# " + case_text(answer.id, one.rows, NumberForm::kDecimal));
  if (answer.is_refusal) return;
  write_file(path + ".claim", is_empty(answer.text) ? "# no critical points\n" : answer.text);
}

OutcomeCounts Verification::counts() const {
  OutcomeCounts counts{};
  for (std::size_t number = 0; number < outcomes_.size(); ++number) {
    if (is_expected(number)) ++counts.at(static_cast<std::size_t>(outcomes_[number]));
  }
  return counts;
}

CountsByName Verification::counts_by(const std::vector<std::string>& names,
                                     const std::function<std::vector<std::string>(std::size_t)>& names_of) const {
  std::map<std::string, OutcomeCounts> counts;
  for (std::size_t number = 0; number < outcomes_.size(); ++number) {
    if (!is_expected(number)) continue;
    for (const std::string& name : names_of(number)) {
      ++counts[name].at(static_cast<std::size_t>(outcomes_[number]));
    }
  }
  CountsByName table;
  for (const std::string& name : names) {
    if (const auto row = counts.find(name); row != counts.end()) table.emplace_back(*row);
  }
  return table;
}

CountsByName Verification::counts_by_family() const {
  return counts_by(cases_->families(), [&](std::size_t number) { return std::vector{cases_->family(number)}; });
}

CountsByName Verification::counts_by_flag() const {
  return counts_by(cases_->flags(), [&](std::size_t number) { return cases_->flags(number); });
}

Verdict Verification::verdict() const {
  const OutcomeCounts of = counts();
  const auto count = [&](Outcome outcome) { return of.at(static_cast<std::size_t>(outcome)); };
  if (count(Outcome::kConforms) == expected()) return Verdict::kConforms;
  const std::size_t where_determined = count(Outcome::kConforms) + count(Outcome::kConformsWhereDetermined);
  if (where_determined == expected()) return Verdict::kConformsWhereDetermined;
  return where_determined + count(Outcome::kPerturbed) == expected() ? Verdict::kPerturbed : Verdict::kFails;
}

std::vector<std::pair<std::size_t, std::size_t>> Verification::unanswered_ranges() const {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  for (std::size_t number = 0; number < outcomes_.size(); ++number) {
    if (outcomes_[number] != Outcome::kUnanswered || !is_expected(number)) continue;
    const bool goes_on = !ranges.empty() && ranges.back().second + 1 == number;
    if (goes_on) {
      ranges.back().second = number;
    } else {
      ranges.emplace_back(number, number);
    }
  }
  return ranges;
}

}  // namespace flowcert::certify
