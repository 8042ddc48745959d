// Findings are listed level by level. The first finding of a level matters most.
#include "cli/check_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <ostream>
#include <vector>

#include "cli/profile_report.h"
#include "cli/reason_table.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "cli/xml_text.h"
#include "io/foreign_text.h"
#include "io/number_text.h"

namespace flowcert::cli {

namespace {

constexpr std::array<const char*, kLevels> kLevelNames = {"well formed", "what is claimed is critical",
                                                          "nothing is missing, nothing twice, indices", "incidences",
                                                          "manifolds and connections"};

// For the table, which has to fit into a line.
constexpr std::array<const char*, kLevels> kShortLevelNames = {"well formed", "what is claimed is critical",
                                                               "none missing, none twice", "incidences",
                                                               "manifolds and connections"};

const char* word_of(const Finding& finding) {
  if (!finding.is_variation) return "wrong";
  return finding.is_decided ? "permitted" : "not decided";
}

std::string place_of(const std::string& claim, const Finding& finding) {
  return finding.line ? fmt::format("{}:{}", claim, *finding.line) : claim;
}

void print_reason_table(const CheckedFiles& files, const CheckReport& report, const std::vector<ReasonRow>& reasons) {
  Table table("llrl", {"reason", "", "findings", "smallest example"});
  for (const ReasonRow& row : reasons) {
    const Finding& finding = report.findings[row.example];
    table.row(row.reason).cell(word_of(finding)).cell(row.count).cell(place_of(files.claim, finding));
  }
  table.print();
  fmt::print("\n");
}

// Words of a command line for a shell.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./+,:@%-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// Long numbers are shortened in the middle.
void print_finding(const CheckedFiles& files, const Finding& finding) {
  print_wrapped(with_short_numbers(finding_line(files.claim, finding)), kFindingIndent);
}

// Below a finding: what is wrong in a sentence, the atoms of a molecule, and the command that explains it.
void print_in_plain_words(const CheckedFiles& files, const Finding& finding) {
  const auto print = [](const std::string& text) {
    fmt::print("{}{}\n", std::string(kFindingIndent, ' '), wrapped(text, kFindingIndent, kLineWidth - kFindingIndent));
  };
  print(with_short_numbers(on_one_line(finding.sentence)));
  // More than these are no command to paste.
  constexpr std::size_t kMostIds = 64;
  if (finding.contact.empty() || finding.contact.size() > kMostIds) return;
  if (files.atoms != nullptr) {
    std::vector<std::string> names;
    for (const PointId row : finding.contact)
      names.push_back(unbroken(fmt::format("{} {}", row, files.atoms->text(row))));
    print(fmt::format("atoms: {}", fmt::join(names, ", ")));
  }
  if (files.points != display_name(kStandardStream)) {
    // Not wrapped: it is to be pasted.
    fmt::print("{}flowcert explain {} --ids {}\n", std::string(kFindingIndent, ' '), shell_word(files.points),
               fmt::join(finding.contact, ","));
  }
}

// First one example of each reason, then all others, level by level.
void print_findings(const CheckedFiles& files, const CheckReport& report, std::size_t most) {
  if (report.findings.empty()) return;
  const std::vector<ReasonRow> reasons = reasons_of(report);
  if (report.findings.size() > 1) print_reason_table(files, report, reasons);
  std::vector<bool> is_shown(report.findings.size(), false);
  for (const ReasonRow& row : reasons) {
    is_shown[row.example] = true;
    print_finding(files, report.findings[row.example]);
    print_in_plain_words(files, report.findings[row.example]);
  }
  std::array<std::size_t, kLevels> of_level{};
  bool is_cut = false;
  if (report.findings.size() > reasons.size()) fmt::print("\n");
  for (std::size_t k = 0; k < report.findings.size(); ++k) {
    if (is_shown[k]) continue;
    if (of_level.at(static_cast<std::size_t>(report.findings[k].level - 1))++ < most) {
      print_finding(files, report.findings[k]);
    } else {
      is_cut = true;
    }
  }
  if (is_cut) fmt::print("(of each level, {} more at most are shown)\n", with_commas(most));
  fmt::print("\n");
}

std::string level_verdict(const std::optional<bool>& conforms, const LevelCount& count) {
  return conforms ? verdict_text(count.verdict) : "nothing to judge";
}

void print_levels(const CheckReport& report) {
  const auto counts = count_levels(report);
  Table table("lllrr", {"level", "", "verdict", "wrong", "permitted"});
  for (std::size_t k = 0; k < kLevels; ++k) {
    table.row(fmt::format("{}", k + 1)).cell(kShortLevelNames.at(k));
    table.cell(level_verdict(report.conforms.at(k), counts.at(k)));
    table.cell(counts.at(k).wrong).cell(counts.at(k).varied);
  }
  table.print();
}

void write_level(std::ostream& out, const CheckedFiles& files, const CheckReport& report, std::size_t k,
                 const LevelCount& count) {
  out << fmt::format("    <testcase classname=\"flowcert.check\" name=\"level {}: {}\"", k + 1, kLevelNames.at(k));
  if (!report.conforms.at(k)) {
    out << "><skipped message=\"nothing to judge\"/></testcase>\n";
    return;
  }
  if (count.wrong + count.varied == 0) {
    out << "/>\n";
    return;
  }
  const char* element = count.wrong > 0 ? "failure" : "system-out";
  out << ">\n      <" << element;
  if (count.wrong > 0) out << fmt::format(" message=\"{} wrong\"", count.wrong);
  out << ">";
  for (const Finding& finding : report.findings) {
    if (finding.level == static_cast<int>(k) + 1) out << xml_text(finding_line(files.claim, finding)) << '\n';
  }
  out << "</" << element << ">\n    </testcase>\n";
}

}  // namespace

std::string finding_line(const std::string& claim, const Finding& finding) {
  return on_one_line(fmt::format("{}: {}, level {}: {} [{}]: claimed {}; truth: {}", place_of(claim, finding),
                                 word_of(finding), finding.level, reason_text(finding.reason), finding.clause,
                                 finding.claimed, finding.truth));
}

void print_verdict(const CheckedFiles& files, Verdict verdict, const Profile& profile, const std::string& tolerance) {
  fmt::print("\n");
  print_conformity({verdict, profile, files.check.tolerance});
  const std::string grade = profile.grade();
  print_wrapped(fmt::format("{} ({}{}; truth by the {})", verdict_text(verdict), grade, tolerance, truth_text(files)),
                kFindingIndent);
}

void print_report_json(const Json& json, int indent) { fmt::print("{}\n", report_text(json, indent)); }

void print_check_text(const CheckedFiles& files, const CheckReport& report, std::size_t most) {
  print_findings(files, report, most);
  print_row("critical points of index", "claimed", "        truth");
  for (std::size_t index = 0; index < 4; ++index) {
    const bool is_judged = report.indices.at(index);
    print_row(fmt::format("  {}", index),
              is_judged ? with_commas(report.claimed_counts.at(index)) : std::string("not judged"),
              files.check.highest_level < 2 ? "" : fmt::format("{:>13}", with_commas(report.true_counts.at(index))));
  }
  fmt::print("\n");
  print_levels(report);
  for (const std::string& what : report.not_judged) print_wrapped("not judged: " + on_one_line(what), kFindingIndent);
  for (const std::string& what : report.not_decided) print_wrapped("not decided: " + on_one_line(what), kFindingIndent);
  print_verdict(files, report.verdict, report.profile,
                report.is_exact ? "" : fmt::format(", tolerance {} of the radius", files.check.tolerance));
}

void write_check_junit(std::ostream& out, const CheckedFiles& files, const CheckReport& report) {
  const auto counts = count_levels(report);
  std::size_t failures = 0, skipped = 0;
  for (std::size_t k = 0; k < kLevels; ++k) {
    failures += counts.at(k).wrong > 0 ? 1 : 0;
    skipped += report.conforms.at(k) ? 0 : 1;
  }
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      << fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n",
                     xml_text(fmt::format("flowcert check {} {}", files.points, files.claim)), kLevels, failures,
                     skipped)
      << junit_properties({report.verdict, report.profile, files.check.tolerance});
  for (std::size_t k = 0; k < kLevels; ++k) write_level(out, files, report, k, counts.at(k));
  out << "  </testsuite>\n</testsuites>\n";
}

// ---- Options ----

namespace {

// Returns what is wrong, or nothing. CLI11's own range check accepts nan.
std::string complaint_about_tolerance(const std::string& word) {
  const NumberText number = parse_number(word);
  const bool is_small = number.fault == nullptr && 0 <= number.value && number.value <= kLargestTolerance;
  return is_small ? "" : fmt::format("{} is no number from 0 to {}", in_quotes(word), kLargestTolerance);
}

}  // namespace

int status_of(Verdict verdict, bool is_strict) {
  return verdict >= (is_strict ? Verdict::kPerturbed : Verdict::kFails) ? kNegativeVerdict : kRight;
}

void add_judging_options(CLI::App& command, CheckOptions& options, bool& is_strict) {
  command
      .add_option("--tolerance", options.tolerance,
                  fmt::format("Positions and radii claimed in decimals match within this part of the radius; above {} "
                              "there is no statement of what conforms",
                              kLargestStatedTolerance))
      ->check(complaint_about_tolerance)
      ->capture_default_str();
  command.add_option("--highest-level", options.highest_level, "Check levels 1 to this one")
      ->check(CLI::Range(1, kLevels))
      ->capture_default_str();
  command
      .add_option_function<std::vector<std::size_t>>(
          "--indices",
          [&options](const std::vector<std::size_t>& indices) {
            options.indices = {};
            for (const std::size_t index : indices) options.indices.at(index) = true;
          },
          "Judge critical points of these indices alone, such as 1,2,3, and not what rests on others")
      ->delimiter(',')
      ->check(CLI::Range(0, 3))
      ->type_name("INDEX,...");
  command.add_flag("--strict", is_strict, "Exit with status 1 also if the verdict is 'perturbed'");
}

}  // namespace flowcert::cli
