// `flowcert verify` says whether a program's answers to the cases of `flowcert generate` are right. Exit status 0 if
// all are right, 1 if any is wrong or missing. It reports in three ways: tables for people, one JSON object, and a
// JUnit file for CI systems (src/cli/manual/cases.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iosfwd>
#include <iostream>
#include <memory>
#include <numeric>
#include <ostream>
#include <set>

#include "certify/programs/verification.h"
#include "cli/case_progress.h"
#include "cli/check_command.h"
#include "cli/check_report.h"
#include "cli/command.h"
#include "cli/conformance_report.h"
#include "cli/layer.h"
#include "cli/profile_report.h"
#include "cli/reason_table.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "cli/xml_text.h"
#include "io/input_bytes.h"
#include "io/line_reader.h"
#include "io/output_file.h"

namespace flowcert::cli {

// ---- Reports ----

namespace {

constexpr std::size_t kVerifyIndent = 4;
// Reports for people show at most so many.
constexpr std::size_t kMostFindingsShown = 3;
constexpr std::size_t kMostRangesShown = 20;
// What findings call the text of an answer; its lines count from 1.
constexpr char kAnswer[] = "answer";

std::size_t count_of(const OutcomeCounts& counts, Outcome outcome) {
  return counts.at(static_cast<std::size_t>(outcome));
}

std::size_t total_of(const OutcomeCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::size_t right_of(const OutcomeCounts& counts) {
  std::size_t right = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) right += is_right(static_cast<Outcome>(k)) ? counts.at(k) : 0;
  return right;
}

std::vector<std::string> outcome_texts() {
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < kOutcomes; ++k) texts.emplace_back(outcome_text(static_cast<Outcome>(k)));
  return texts;
}

OutcomeRow row_of(const std::string& name, const OutcomeCounts& counts) {
  return {.name = name, .counts = {counts.begin(), counts.end()}};
}

std::vector<OutcomeRow> rows_of(const CountsByName& by_name) {
  std::vector<OutcomeRow> rows;
  for (const auto& [name, counts] : by_name) rows.push_back(row_of(name, counts));
  return rows;
}

void print_tables(const Verification& verification) {
  const CountsByName flags = verification.counts_by_flag();
  if (!flags.empty()) {
    print_outcomes("flag", outcome_texts(), rows_of(flags));
    fmt::print("\n");
  }
  std::vector<OutcomeRow> families = rows_of(verification.counts_by_family());
  families.push_back(row_of("all", verification.counts()));
  print_outcomes(flags.empty() ? "family" : "group", outcome_texts(), families);
}

// Prints the families and flags whose cases are all wrong, unless all cases are, and the family of all wrong cases.
void print_telling_names(const Verification& verification) {
  const OutcomeCounts all = verification.counts();
  const std::size_t wrong = total_of(all) - right_of(all);
  if (wrong < 2 || wrong == total_of(all)) return;
  std::string lines;
  const auto tell = [&](const char* what, const CountsByName& rows) {
    for (const auto& [name, counts] : rows) {
      const std::size_t here = total_of(counts) - right_of(counts);
      if (total_of(counts) >= 2 && here == total_of(counts)) {
        lines += fmt::format("all {} cases of the {} {} are wrong\n", with_commas(here), what, name);
      }
      if (here == wrong) lines += fmt::format("all {} wrong cases are of the {} {}\n", with_commas(wrong), what, name);
    }
  };
  tell(verification.is_stored() ? "group" : "family", verification.counts_by_family());
  tell("flag", verification.counts_by_flag());
  if (!lines.empty()) fmt::print("\n{}", lines);
}

// "fails on level 3", "unreadable: answer:1: not an index", "refused: out of memory"
std::string verdict_of(const FailedCase& failed) {
  std::string text = outcome_text(failed.outcome);
  if (!failed.findings.empty()) text += fmt::format(" on level {}", failed.findings.front().level);
  if (!failed.reason.empty()) text += ": " + failed.reason;
  return text;
}

std::vector<std::string> lines_of(const FailedCase& failed, std::size_t most) {
  std::vector<std::string> lines;
  const std::size_t findings = std::min(most, failed.findings.size()),
                    pairs = std::min(most, failed.pair_findings.size());
  for (std::size_t k = 0; k < findings; ++k) {
    lines.push_back(finding_line(kAnswer, failed.findings[k]));
    lines.push_back("  " + failed.findings[k].sentence);
  }
  for (std::size_t k = 0; k < pairs; ++k) {
    lines.push_back(fmt::format("{}: wrong, {}", kAnswer, persistence_finding_words(failed.pair_findings[k])));
    lines.push_back("  " + sentence_of(failed.pair_findings[k]));
  }
  if (failed.wrong > findings + pairs) lines.push_back(fmt::format("({} more)", failed.wrong - findings - pairs));
  return lines;
}

void print_failure(const Verification& verification, std::size_t number, const FailedCase& failed) {
  const std::string family = verification.cases().family(number);
  print_wrapped(fmt::format("case {} ({}) {}", failed.id, family, verdict_of(failed)), kVerifyIndent);
  for (const std::string& line : lines_of(failed, kMostFindingsShown)) {
    print_wrapped("  " + with_short_numbers(line), kVerifyIndent);
  }
  fmt::print("  its points: {}\n", verification.cases().points_command(number));
  const auto named = std::ranges::find_if(failed.findings, [](const Finding& one) { return !one.contact.empty(); });
  if (named != failed.findings.end()) {
    fmt::print("  why: {} | flowcert explain - --ids {}\n", verification.cases().points_command(number),
               fmt::join(named->contact, ","));
  }
  if (verification.options().folder.empty() || failed.outcome == Outcome::kRefused) return;
  const std::string path = verification.kept_path(number);
  if (verification.options().judges_pairs) {
    fmt::print("  its answer: {}.claim, of {}.xyz\n", path, path);
  } else {
    fmt::print("  its answer: flowcert check {}.xyz {}.claim\n", path, path);
  }
}

std::vector<ReasonRow> reasons_of(const Verification& verification) {
  std::vector<ReasonRow> rows;
  for (const auto& [reason, of] : verification.reasons()) rows.push_back({reason, of.cases, of.points, of.number});
  sort_reasons(rows);
  return rows;
}

void print_reason_table(const Verification& verification) {
  print_reasons(reasons_of(verification), "cases", [&](const ReasonRow& row) {
    return fmt::format("case {} ({}), {}", row.example, verification.cases().family(row.example),
                       points_text(row.size));
  });
}

// The smallest case of each reason, with what is wrong for that reason.
void print_examples(const Verification& verification) {
  for (const ReasonRow& row : reasons_of(verification)) {
    const CasesOfReason& of = verification.reasons().at(row.reason);
    print_failure(verification, of.number, of.smallest);
    fmt::print("\n");
  }
}

// Those that are no examples.
void print_failures(const Verification& verification, std::size_t most) {
  std::set<std::size_t> examples;
  for (const auto& [reason, of] : verification.reasons()) examples.insert(of.number);
  std::size_t shown = 0;
  for (const auto& [number, failed] : verification.failures()) {
    if (shown == most) break;
    if (examples.contains(number)) continue;
    ++shown;
    fmt::print("\n");
    print_failure(verification, number, failed);
  }
  shown += examples.size();
  const OutcomeCounts counts = verification.counts();
  const std::size_t all = total_of(counts) - right_of(counts) - count_of(counts, Outcome::kUnanswered);
  if (all > shown) {
    fmt::print("\n({} of {} failing cases are shown; --most N shows N)\n", with_commas(shown), with_commas(all));
  }
}

// It comes before all tables, because cases without an answer are in no row of the first one.
// cut: where the input broke off, or empty.
void print_unanswered(const Verification& verification, const std::string& cut) {
  if (!cut.empty()) print_wrapped(cut + "\n", kVerifyIndent);
  const auto ranges = verification.unanswered_ranges();
  if (ranges.empty()) return;
  std::string list;
  for (std::size_t k = 0; k < std::min(ranges.size(), kMostRangesShown); ++k) {
    const auto& [first, last] = ranges[k];
    list += k == 0 ? "" : ", ";
    list += first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
  }
  if (ranges.size() > kMostRangesShown) list += ", ...";
  const std::string count = with_commas(count_of(verification.counts(), Outcome::kUnanswered));
  print_wrapped(fmt::format("{} of {} have no answer: {}", count, counted(verification.expected(), "case"), list),
                kVerifyIndent);
  fmt::print("\n");
}

const char* truth_text(const Verification& verification) {
  if (verification.is_stored()) return "conformance vectors";
  return verification.options().by_oracle ? "oracle" : "fast implementation";
}

// How many cases the statement is about. Vectors are kept apart from drawn inputs, which no other version has.
std::string note_of(const Verification& verification) {
  const std::string cases = counted(verification.expected(), verification.is_stored() ? "vector" : "drawn input");
  const auto most = verification.cases().most_points();
  return fmt::format(" ({}{})", cases, most ? " of at most " + points_text(*most) : "");
}

JudgedProfile judged_profile(const Verification& verification) {
  return {verification.verdict(), verification.profile(), verification.options().check.tolerance,
          note_of(verification)};
}

// What a run is worth of which the program under test says itself which it was.
constexpr char kRightInWhatCame[] = "right in what came";
bool is_right_in_what_came(const Verification& verification) {
  return !verification.is_given() && verification.verdict() != Verdict::kFails;
}

const char* verdict_words(const Verification& verification) {
  return is_right_in_what_came(verification) ? kRightInWhatCame : verdict_text(verification.verdict());
}

// "conforms: 500 of 500 cases are right", or "right in what came: 500 cases"
std::string first_words(const Verification& verification) {
  const std::string expected = counted(verification.expected(), "case");
  if (is_right_in_what_came(verification)) return fmt::format("{}: {}", kRightInWhatCame, expected);
  return fmt::format("{}: {} of {} {} right", verdict_words(verification), with_commas(right_of(verification.counts())),
                     expected, verification.expected() == 1 ? "is" : "are");
}

void print_verdict(const Verification& verification) {
  std::string text = first_words(verification);
  if (verification.approximate() > 0) {
    text += fmt::format("; {} approximate, tolerance {} of the radius", with_commas(verification.approximate()),
                        verification.options().check.tolerance);
  }
  if (verification.partly_judged() > 0) {
    text += fmt::format("; {} judged in part", with_commas(verification.partly_judged()));
  }
  text += fmt::format("; truth by the {}", truth_text(verification));
  if (verification.too_large() > 0) {
    text += fmt::format(", of {} large ones by the fast implementation", with_commas(verification.too_large()));
  }
  fmt::print("\n");
  if (!is_right_in_what_came(verification)) {
    print_conformity(judged_profile(verification));
  }
  print_wrapped(text, kVerifyIndent);
  if (is_right_in_what_came(verification)) {
    print_wrapped("The answers alone say which cases were asked; verify " + verification.cases().run_options() +
                      " says whether any is missing.",
                  kVerifyIndent);
  }
}

// ---- JSON ----

Json failure_field(const Verification& verification, std::size_t number, const FailedCase& failed) {
  Json findings = Json::array();
  for (const Finding& finding : failed.findings) findings.push_back(finding_field(finding));
  Json field = {{"id", failed.id},
                {"number", number},
                {"family", verification.cases().family(number)},
                {"verdict", outcome_text(failed.outcome)},
                {"reason", failed.reason.empty() ? Json(nullptr) : Json(failed.reason)},
                {"wrong", failed.wrong},
                {"findings", std::move(findings)}};
  if (verification.options().judges_pairs) {
    field["persistence_findings"] = persistence_findings_field(failed.pair_findings);
  }
  field["points"] = verification.cases().points_command(number);
  return field;
}

// ---- JUnit ----

void write_family(std::ostream& out, const Verification& verification, const std::string& name,
                  const OutcomeCounts& counts) {
  out << fmt::format("    <testcase classname=\"flowcert.verify\" name=\"{}\"", xml_text(name));
  const std::size_t wrong = total_of(counts) - right_of(counts);
  if (wrong == 0) {
    out << "/>\n";
    return;
  }
  out << fmt::format(">\n      <failure message=\"{} of {} cases are wrong\">", wrong, total_of(counts));
  for (const auto& [number, failed] : verification.failures()) {
    if (verification.cases().family(number) != name) continue;
    out << xml_text(fmt::format("case {} {}", failed.id, verdict_of(failed))) << '\n';
    for (const std::string& line : lines_of(failed, kMostFindingsShown)) out << "  " << xml_text(line) << '\n';
  }
  if (const std::size_t count = count_of(counts, Outcome::kUnanswered); count > 0) {
    out << fmt::format("{} unanswered\n", count);
  }
  out << "</failure>\n    </testcase>\n";
}

// At most `most` of the failing cases that were kept are shown.
void print_verify_text(const Verification& verification, std::size_t most, const std::string& cut) {
  print_unanswered(verification, cut);
  print_reason_table(verification);
  print_examples(verification);
  print_tables(verification);
  print_telling_names(verification);
  print_failures(verification, most);
  print_verdict(verification);
}

void print_verify_json(const Verification& verification, const std::string& cut) {
  Json json = header_fields("flowcert-verify", 1);
  json["verdict"] = verdict_words(verification);
  json["profile"] = profile_field(judged_profile(verification));
  if (is_right_in_what_came(verification)) json["profile"]["statement"] = nullptr;
  json["tolerance"] = verification.options().check.tolerance;
  json["highest_level"] = verification.options().check.highest_level;
  json["truth"] = truth_text(verification);
  json["run"] = verification.cases().generate_command(verification.options().only);
  add_outcomes(json, outcome_texts(), row_of("all", verification.counts()));
  json["approximate"] = verification.approximate();
  json["partly_judged"] = verification.partly_judged();
  json["too_large_for_oracle"] = verification.too_large();
  json["reasons"] = reasons_field(reasons_of(verification), [](const ReasonRow& row) { return Json(row.example); });
  json["families"] = outcome_rows_field("family", outcome_texts(), rows_of(verification.counts_by_family()));
  if (verification.is_stored())
    json["flags"] = outcome_rows_field("flag", outcome_texts(), rows_of(verification.counts_by_flag()));
  Json& failures = json["failures"] = Json::array();
  for (const auto& [number, failed] : verification.failures()) {
    failures.push_back(failure_field(verification, number, failed));
  }
  json["unanswered_numbers"] = verification.unanswered_ranges();
  json["cut"] = cut.empty() ? Json(nullptr) : Json(cut);
  print_report_json(json);
}

void write_verify_junit(std::ostream& out, const Verification& verification) {
  const auto families = verification.counts_by_family();
  const auto failures = std::count_if(families.begin(), families.end(), [](const auto& family) {
    return right_of(family.second) < total_of(family.second);
  });
  const std::string run = verification.cases().generate_command(verification.options().only);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      << fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n",
                     xml_text("flowcert verify of " + run), families.size(), failures)
      << (is_right_in_what_came(verification) ? "" : junit_properties(judged_profile(verification)));
  for (const auto& [name, counts] : families) write_family(out, verification, name, counts);
  out << "  </testsuite>\n</testsuites>\n";
}

// ---- The command ----

// How many failing cases are usually shown to people and reported to programs.
constexpr std::size_t kUsuallyShown = 10;
constexpr std::size_t kUsuallyReported = 1000;

struct VerifyCommandOptions {
  VerificationOptions verification;
  std::optional<std::size_t> most;
  std::string junit;
  std::function<std::unique_ptr<AskedCases>()> given_cases;
  std::string asked;  // the file that generate wrote
  bool json = false;
  bool is_strict = false;
};

// Returns where the input broke off, if it did.
std::string take_all_answers(Verification& verification, CaseProgress& progress) {
  std::ios::sync_with_stdio(false);
  AnswerReader answers(std::cin);
  Answer answer;
  while (answers.next(answer)) {
    verification.take(answer);
    progress(verification.taken(), verification.expected(), verification.wrong());
  }
  return answers.cut();
}

// The ids in the file that generate wrote, in their order.
std::vector<std::string> asked_ids(const std::string& path) {
  std::vector<std::string> ids;
  const std::string bytes = read_bytes(path);
  LineReader lines(bytes, path);
  std::string_view line;
  while (lines.next_uncommented(line)) {
    Fields fields(line, Separators::kBlanks);
    std::string_view word, id;
    if (fields.next(word) && word == "case" && fields.next(id)) ids.emplace_back(id);
  }
  if (ids.empty()) reject_file(path, "no line 'case ID N', which flowcert generate writes");
  return ids;
}

// The cases that the user says are asked; none, if the user says nothing.
std::unique_ptr<AskedCases> given_cases(VerifyCommandOptions& options) {
  std::unique_ptr<AskedCases> given = options.given_cases();
  if (given || options.asked.empty()) return given;
  const std::vector<std::string> ids = asked_ids(options.asked);
  std::unique_ptr<AskedCases> cases = cases_with(ids.front(), options.verification.drawn);
  std::vector<std::size_t>& numbers = options.verification.asked;
  for (const std::string& id : ids) numbers.push_back(cases->named(id).number);
  std::ranges::sort(numbers);
  numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
  return cases;
}

int verify(VerifyCommandOptions options) {
  const bool is_for_programs = options.json || !options.junit.empty();
  options.verification.most_failures_kept = options.most.value_or(is_for_programs ? kUsuallyReported : kUsuallyShown);
  std::optional<CaseProgress> progress;
  progress.emplace("verifying", STDIN_FILENO, PlaceInPipe::kLast);
  std::unique_ptr<AskedCases> given = given_cases(options);
  Verification verification(options.verification, std::move(given));
  const std::string cut = take_all_answers(verification, *progress);
  progress.reset();
  if (!verification.has_begun()) throw InvalidInput("standard input: no answers");
  if (!options.junit.empty()) {
    write_whole_file(options.junit, [&](std::ostream& out) { write_verify_junit(out, verification); });
  }
  if (options.json) {
    print_verify_json(verification, cut);
  } else {
    print_verify_text(verification, options.most.value_or(kUsuallyShown), cut);
  }
  return status_of(verification.verdict(), options.is_strict);
}

}  // namespace

void add_verify_command(CLI::App& app, int& status, const OtherTruth& oracle, const DrawnRuns& drawn) {
  auto options = std::make_shared<VerifyCommandOptions>();
  VerificationOptions& verification = options->verification;
  verification.oracle = oracle;
  verification.drawn = drawn.of_id;
  CLI::App* command = app.add_subcommand("verify", kVerifyPurpose);
  command->add_flag("--json", options->json, "Print one JSON object");
  command->add_option("--junit", options->junit, "Write a JUnit report to this file, a test case a family");
  command
      ->add_option("--keep", verification.folder,
                   "Write points and claim of each failing case into this folder, for flowcert check")
      ->type_name("DIR");
  add_judging_options(*command, verification.check, options->is_strict);
  command->add_option("--most", options->most, "Report so many failing cases; without this 10, to programs 1,000")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--case", verification.only, "Expect an answer to this case alone")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--persistence", verification.judges_pairs,
                    "Answers are persistence pairs, as persistence --json or GUDHI's tools write them");
  command->add_flag("--oracle", verification.by_oracle,
                    fmt::format("Let the oracle say what is true, not the fast implementation, for cases of up "
                                "to {} points; with --persistence, up to {}",
                                oracle.most_points, oracle.most_points_of_pairs));
  options->given_cases = drawn.add_options(*command);
  command
      ->add_option("--asked", options->asked,
                   "The file that generate wrote: its cases are asked. Without this or options of generate, the "
                   "answers alone say what was asked, and nobody says whether any is missing")
      ->type_name("FILE");
  for (const char* other : {"--level", "--seed", "--cases", "--family", "--vectors", "--most-points"}) {
    command->get_option("--asked")->excludes(command->get_option(other));
  }
  command->footer(
      "Reads from standard input, for each case, in any order:\n"
      "  answer ID\n  ...the critical points, in a format that flowcert check reads...\n  end\n"
      "or a line `refused ID REASON`.\n\n"
      "Examples:\n  flowcert generate --seed 7 | ./your-program | flowcert verify --seed 7\n"
      "  flowcert generate --vectors | ./your-program | flowcert verify --vectors\n"
      "  flowcert generate --level 1 --most-points 6 | ./your-program \\\n"
      "    | flowcert verify --level 1 --most-points 6\n"
      "  flowcert generate | ./your-diagrams | flowcert verify --seed 1 --persistence");
  command->callback([options, &status] { status = verify(*options); });
}

}  // namespace flowcert::cli
