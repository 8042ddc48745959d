#include "cli/conformance_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <set>

#include "cli/check_report.h"
#include "cli/command.h"
#include "cli/profile_report.h"
#include "cli/reason_table.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kCaseIndent = 4;

// ---- Counting

// The columns of the tables.
constexpr std::array kColumns = {RunOutcome::kConforms,  RunOutcome::kConformsWhereDetermined,
                                 RunOutcome::kPerturbed, RunOutcome::kFails,
                                 RunOutcome::kRefused,   RunOutcome::kCrashed,
                                 RunOutcome::kTimedOut,  RunOutcome::kUnreadable};

// An invalid case that is refused counts as conforming, one that is accepted as failing.
RunOutcome column_of(RunOutcome outcome) {
  if (outcome == RunOutcome::kAccepted) return RunOutcome::kFails;
  return outcome == RunOutcome::kProperlyRefused ? RunOutcome::kConforms : outcome;
}

std::size_t count_of(const OutcomeRow& row, RunOutcome column) {
  return row.counts.at(static_cast<std::size_t>(std::ranges::find(kColumns, column) - kColumns.begin()));
}

std::size_t negative_of(const OutcomeRow& row) {
  std::size_t sum = 0;
  for (const RunOutcome column : kColumns) sum += is_negative(column) ? count_of(row, column) : 0;
  return sum;
}

// The row counts the cases for which includes(case).
template <typename Includes>
OutcomeRow row_of(const ConformanceReport& report, const std::string& name, const Includes& includes) {
  OutcomeRow row{.name = name, .counts = std::vector<std::size_t>(kColumns.size())};
  for (const CaseOutcome& outcome : report.outcomes) {
    if (!includes(*outcome.of)) continue;
    const auto column = std::ranges::find(kColumns, column_of(outcome.outcome));
    ++(column == kColumns.end() ? row.skipped : row.counts[static_cast<std::size_t>(column - kColumns.begin())]);
  }
  return row;
}

OutcomeRow row_of_all(const ConformanceReport& report) {
  return row_of(report, "all", [](const VectorCase&) { return true; });
}

// The flags that have a case that was run.
std::vector<OutcomeRow> rows_by_flag(const ConformanceReport& report) {
  std::vector<OutcomeRow> rows;
  for (const VectorFlag& flag : report.vectors.flags) {
    rows.push_back(row_of(report, flag.name, [&](const VectorCase& one) {
      return std::ranges::find(one.flags, flag.name) != one.flags.end();
    }));
  }
  std::erase_if(rows, [](const OutcomeRow& row) { return row.cases() == 0; });
  return rows;
}

// All groups that have a case, even if all their cases were skipped.
std::vector<OutcomeRow> rows_by_group(const ConformanceReport& report) {
  std::vector<OutcomeRow> rows;
  for (const std::string& group : report.vectors.groups) {
    rows.push_back(row_of(report, group, [&](const VectorCase& one) { return one.group == group; }));
  }
  std::erase_if(rows, [](const OutcomeRow& row) { return row.cases() + row.skipped == 0; });
  return rows;
}

std::size_t claims_judged(const ConformanceReport& report, std::size_t level) {
  return static_cast<std::size_t>(
      std::ranges::count_if(report.outcomes, [&](const CaseOutcome& outcome) { return outcome.judged.at(level); }));
}

std::size_t orbits_judged(const ConformanceReport& report) {
  std::size_t count = 0;
  for (const CaseOutcome& outcome : report.outcomes) count += outcome.orbits_judged;
  return count;
}

std::size_t persistence_judged(const ConformanceReport& report) {
  return static_cast<std::size_t>(std::ranges::count_if(report.outcomes, &CaseOutcome::is_persistence_judged));
}

// ---- Text

std::string outcome_words(const CaseOutcome& outcome) {
  switch (outcome.outcome) {
    case RunOutcome::kAccepted:
      return "accepts what is invalid";
    case RunOutcome::kRefused:
      return "refuses what is valid";
    default:
      return run_outcome_text(outcome.outcome);
  }
}

// The numbers of examples are those of outcomes.
std::vector<ReasonRow> reasons_of(const ConformanceReport& report) {
  ReasonTally tally;
  for (std::size_t k = 0; k < report.outcomes.size(); ++k) {
    const CaseOutcome& outcome = report.outcomes[k];
    for (const CaseReason& reason : outcome.reasons) tally.add(reason.reason, outcome.of->rows.size(), k);
  }
  return tally.rows();
}

void print_negative_case(const CaseOutcome& outcome, const std::string& words) {
  const VectorCase& of = *outcome.of;
  const std::string head = fmt::format("{} ({}): {}", of.id, of.comment, outcome_words(outcome));
  fmt::print("{}\n{}\n", wrapped(head, kCaseIndent), wrapped("  " + with_short_numbers(words), kCaseIndent));
}

// Returns which outcomes were shown as examples.
std::set<std::size_t> print_reasons_and_examples(const ConformanceReport& report) {
  const std::vector<ReasonRow> rows = reasons_of(report);
  print_reasons(rows, "cases", [&](const ReasonRow& row) {
    return report.outcomes[row.example].of->id + ", " + points_text(row.size);
  });
  std::set<std::size_t> shown;
  for (const ReasonRow& row : rows) {
    const CaseOutcome& outcome = report.outcomes[row.example];
    print_negative_case(outcome, std::ranges::find(outcome.reasons, row.reason, &CaseReason::reason)->example);
    shown.insert(row.example);
  }
  if (!rows.empty()) fmt::print("\n");
  return shown;
}

void print_other_negative_cases(const ConformanceReport& report, std::size_t most,
                                const std::set<std::size_t>& examples) {
  std::size_t shown = 0, left_out = 0;
  for (std::size_t k = 0; k < report.outcomes.size(); ++k) {
    const CaseOutcome& outcome = report.outcomes[k];
    if (!is_negative(outcome.outcome) || examples.contains(k)) continue;
    if (shown == most) {
      ++left_out;
      continue;
    }
    ++shown;
    print_negative_case(outcome, outcome.message);
  }
  if (left_out > 0) fmt::print("and {} more; --most shows more\n", with_commas(left_out));
  if (shown + left_out > 0) fmt::print("\n");
}

// Prints the flags and groups whose cases are all negative, unless all cases are, and the flags and groups that all
// negative cases have.
void print_telling_names(const ConformanceReport& report) {
  const OutcomeRow all = row_of_all(report);
  if (negative_of(all) == all.cases()) return;
  const auto tell = [&](const char* what, const std::vector<OutcomeRow>& rows) {
    for (const OutcomeRow& row : rows) {
      if (row.cases() >= 2 && negative_of(row) == row.cases()) {
        fmt::print("all {} cases {} {} are negative\n", row.cases(), what, row.name);
      }
      if (negative_of(all) >= 2 && negative_of(row) == negative_of(all)) {
        fmt::print("all {} negative cases are {} {}\n", negative_of(all), what, row.name);
      }
    }
  };
  tell("with the flag", rows_by_flag(report));
  tell("of the group", rows_by_group(report));
}

// Prints for each reason the rarest flag that all of its cases have, if some other case does not have it.
void print_flags_of_reasons(const ConformanceReport& report) {
  std::vector<OutcomeRow> flags = rows_by_flag(report);
  std::ranges::stable_sort(flags, {}, &OutcomeRow::cases);
  const std::size_t all = row_of_all(report).cases();
  for (const ReasonRow& row : reasons_of(report)) {
    if (row.count < 2) continue;
    const auto is_on_all = [&](const OutcomeRow& flag) {
      return std::ranges::all_of(report.outcomes, [&](const CaseOutcome& outcome) {
        const bool is_so = std::ranges::find(outcome.reasons, row.reason, &CaseReason::reason) != outcome.reasons.end();
        return !is_so || std::ranges::find(outcome.of->flags, flag.name) != outcome.of->flags.end();
      });
    };
    const auto flag = std::ranges::find_if(flags, is_on_all);
    if (flag == flags.end() || flag->cases() == all) continue;
    print_wrapped(fmt::format("all {} cases of {} have the flag {}, as {} cases do", with_commas(row.count), row.reason,
                              flag->name, with_commas(flag->cases())),
                  kCaseIndent);
  }
}

// Prints how many cases have something that was not judged, because no command was given for it.
template <typename Has>
void print_unasked(const ConformanceReport& report, const char* what, const char* option, const Has& has) {
  const auto count = static_cast<std::size_t>(std::ranges::count_if(report.outcomes, has));
  if (count == 0) return;
  print_wrapped(fmt::format("not judged: the {} of {} case{}, without {}", what, with_commas(count),
                            count == 1 ? "" : "s", option),
                kCaseIndent);
}

void print_judged(const ConformanceReport& report) {
  std::string judged = "judged: ";
  for (std::size_t level = 0; level < kLevels; ++level) {
    judged += fmt::format("{} claim{} on level {}, ", with_commas(claims_judged(report, level)),
                          claims_judged(report, level) == 1 ? "" : "s", level + 1);
  }
  print_wrapped(judged + with_commas(orbits_judged(report)) + " orbits", kCaseIndent);
  if (!report.options.persistence_command.empty()) {
    fmt::print("judged: the persistence pairs of {} cases\n", with_commas(persistence_judged(report)));
  }
  if (report.options.orbit_command.empty()) {
    print_unasked(report, "orbits", "--orbits-against",
                  [](const CaseOutcome& outcome) { return !outcome.of->orbits.empty(); });
  }
  if (report.options.persistence_command.empty()) {
    print_unasked(report, "persistence pairs", "--persistence-against",
                  [](const CaseOutcome& outcome) { return outcome.of->persistence.has_value(); });
  }
}

void print_undecided(const ConformanceReport& report) {
  const auto count = std::ranges::count(report.outcomes, false, &CaseOutcome::is_decided);
  if (count == 0) return;
  print_wrapped(fmt::format("not decided: in {} case{}, whether one perturbation makes all that is claimed at a point "
                            "(FC-CLAIM-04)",
                            with_commas(static_cast<std::size_t>(count)), count == 1 ? "" : "s"),
                kCaseIndent);
}

void print_skipped(const ConformanceReport& report) {
  for (const CaseOutcome& outcome : report.outcomes) {
    if (outcome.outcome != RunOutcome::kSkipped) continue;
    print_wrapped(fmt::format("skipped: {} ({}): it {}", outcome.of->id, outcome.of->comment, outcome.message),
                  kCaseIndent);
  }
}

// ---- JSON

Json orbit_findings_field(const CaseOutcome& outcome) {
  Json field = Json::array();
  for (const auto& [start, difference] : outcome.orbit_findings) {
    field.push_back({{"start", start},
                     {"permitted", difference.is_permitted},
                     {"claimed", difference.claimed},
                     {"truth", difference.truth}});
  }
  return field;
}

}  // namespace

Json persistence_findings_field(const std::vector<PairDifference>& differences) {
  Json field = Json::array();
  for (const PairDifference& difference : differences) {
    field.push_back({{"reason", difference.reason}, {"claimed", difference.claimed}, {"truth", difference.truth}});
  }
  return field;
}

namespace {

Json case_field(const CaseOutcome& outcome) {
  Json findings = Json::array();
  for (const Finding& finding : outcome.findings) findings.push_back(finding_field(finding));
  return {{"id", outcome.of->id},
          {"group", outcome.of->group},
          {"outcome", run_outcome_text(outcome.outcome)},
          {"negative", is_negative(outcome.outcome)},
          {"level", outcome.level ? Json(*outcome.level) : Json(nullptr)},
          {"seconds", outcome.seconds},
          {"message", outcome.message},
          {"findings", std::move(findings)},
          {"findings_left_out", outcome.findings_left_out},
          {"orbit_findings", orbit_findings_field(outcome)},
          {"persistence_findings", persistence_findings_field(outcome.persistence_findings)}};
}

Json judged_field(const ConformanceReport& report) {
  Json field = Json::object();
  for (std::size_t level = 0; level < kLevels; ++level) {
    field[fmt::format("{}", level + 1)] = claims_judged(report, level);
  }
  field["orbits"] = orbits_judged(report);
  field["persistence"] = persistence_judged(report);
  return field;
}

// ---- JUnit

void write_test_case(std::ostream& out, const CaseOutcome& outcome) {
  out << fmt::format("    <testcase classname=\"flowcert.conformance.{}\" name=\"{}\" time=\"{:.3f}\"",
                     xml_text(outcome.of->group), xml_text(outcome.of->id), outcome.seconds);
  const std::string message = xml_text(outcome.message);
  if (is_negative(outcome.outcome)) {
    out << fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                       xml_text(outcome_words(outcome)), message);
  } else if (outcome.outcome == RunOutcome::kSkipped) {
    out << fmt::format("><skipped message=\"{}\"/></testcase>\n", message);
  } else if (outcome.outcome == RunOutcome::kConformsWhereDetermined || outcome.outcome == RunOutcome::kPerturbed) {
    out << fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n", message);
  } else {
    out << "/>\n";
  }
}

// How many of the vectors the statement is about.
std::string note_of(const ConformanceReport& report) {
  const std::size_t asked = row_of_all(report).cases(), all = report.vectors.cases.size();
  return asked == all ? fmt::format(" ({} vectors)", with_commas(all))
                      : fmt::format(" ({} of {} vectors)", with_commas(asked), with_commas(all));
}

JudgedProfile judged_profile(const ConformanceReport& report) {
  return {report.verdict(), report.profile(), report.options.check.tolerance, note_of(report)};
}

void write_test_suite(std::ostream& out, const ConformanceReport& report, const OutcomeRow& group) {
  double seconds = 0;
  for (const CaseOutcome& outcome : report.outcomes) {
    if (outcome.of->group == group.name) seconds += outcome.seconds;
  }
  out << fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"{:.3f}\">\n",
      xml_text(group.name), group.cases() + group.skipped, negative_of(group), group.skipped, seconds);
  out << junit_properties(judged_profile(report));
  for (const CaseOutcome& outcome : report.outcomes) {
    if (outcome.of->group == group.name) write_test_case(out, outcome);
  }
  out << "  </testsuite>\n";
}

}  // namespace

std::vector<std::string> tally_outcomes() {
  std::vector<std::string> texts;
  for (const RunOutcome column : kColumns) texts.emplace_back(run_outcome_text(column));
  return texts;
}

Verdict ConformanceReport::verdict() const {
  const OutcomeRow all = row_of_all(*this);
  if (negative_of(all) > 0) return Verdict::kFails;
  if (count_of(all, RunOutcome::kPerturbed) > 0) return Verdict::kPerturbed;
  return count_of(all, RunOutcome::kConformsWhereDetermined) > 0 ? Verdict::kConformsWhereDetermined
                                                                 : Verdict::kConforms;
}

Profile ConformanceReport::profile() const {
  Profile joined;
  for (const CaseOutcome& outcome : outcomes) {
    if (outcome.profile) joined.join(*outcome.profile);
  }
  return joined;
}

void print_conformance_text(const ConformanceReport& report, std::size_t most) {
  const std::set<std::size_t> examples = print_reasons_and_examples(report);
  print_outcomes("flag", tally_outcomes(), rows_by_flag(report));
  fmt::print("\n");
  print_outcomes("group", tally_outcomes(), rows_by_group(report));
  fmt::print("\n");
  print_telling_names(report);
  print_flags_of_reasons(report);
  print_other_negative_cases(report, most, examples);
  print_skipped(report);
  print_judged(report);
  print_undecided(report);
  const OutcomeRow all = row_of_all(report);
  fmt::print("\n");
  print_wrapped(fmt::format("{} cases in {}: {} conform, {} where determined, {} perturbed, {} negative",
                            with_commas(all.cases()), seconds_text(report.seconds),
                            with_commas(count_of(all, RunOutcome::kConforms)),
                            with_commas(count_of(all, RunOutcome::kConformsWhereDetermined)),
                            with_commas(count_of(all, RunOutcome::kPerturbed)), with_commas(negative_of(all))),
                kCaseIndent);
  fmt::print("\n");
  print_conformity(judged_profile(report));
  fmt::print("{}\n", verdict_text(report.verdict()));
}

Json conformance_json(const ConformanceReport& report) {
  const ConformanceOptions& options = report.options;
  Json json = header_fields("flowcert-conformance", 1);
  json["command"] = options.command;
  json["orbit_command"] = options.orbit_command.empty() ? Json(nullptr) : Json(options.orbit_command);
  json["persistence_command"] = options.persistence_command.empty() ? Json(nullptr) : Json(options.persistence_command);
  json["tolerance"] = options.check.tolerance;
  json["highest_level"] = options.check.highest_level;
  json["time_limit"] = options.limits.seconds;
  json["verdict"] = verdict_text(report.verdict());
  json["profile"] = profile_field(judged_profile(report));
  json["seconds"] = report.seconds;
  json["judged"] = judged_field(report);
  json["reasons"] = reasons_field(reasons_of(report),
                                  [&](const ReasonRow& row) { return Json(report.outcomes[row.example].of->id); });
  json["flags"] = outcome_rows_field("flag", tally_outcomes(), rows_by_flag(report));
  json["groups"] = outcome_rows_field("group", tally_outcomes(), rows_by_group(report));
  Json& cases = json["cases"] = Json::array();
  for (const CaseOutcome& outcome : report.outcomes) cases.push_back(case_field(outcome));
  return json;
}

void print_conformance_json(const ConformanceReport& report) { print_report_json(conformance_json(report)); }

void write_conformance_junit(std::ostream& out, const ConformanceReport& report) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const OutcomeRow& group : rows_by_group(report)) write_test_suite(out, report, group);
  out << "</testsuites>\n";
}

}  // namespace flowcert::cli
