// Findings are listed level by level. The first finding of a level tells most.
#include "cli/check_report.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <ostream>

#include "cli/table.h"
#include "cli/xml_text.h"
#include "io/number_text.h"

namespace flowcert::cli {

namespace {

constexpr std::array<const char*, kLevels> kLevelNames = {"well formed", "what is claimed is critical",
                                                          "nothing is missing, nothing twice, indices", "incidences",
                                                          "polylines and surfaces"};

const char* truth_text(const CheckedFiles& files) { return files.by_oracle ? "oracle" : "fast implementation"; }
const char* grade_text(const CheckReport& report) { return report.is_exact ? "exact" : "approximate"; }

struct LevelCount {
  std::size_t wrong = 0;
  std::size_t varied = 0;
  std::size_t undecided = 0;  // of those
  Verdict verdict = Verdict::kConforms;
};

std::array<LevelCount, kLevels> count_levels(const CheckReport& report) {
  std::array<LevelCount, kLevels> counts{};
  for (const Finding& finding : report.findings) {
    LevelCount& count = counts.at(static_cast<std::size_t>(finding.level - 1));
    ++(finding.is_variation ? count.varied : count.wrong);
    count.undecided += finding.is_decided ? 0 : 1;
    count.verdict = std::max(count.verdict, verdict_on(finding));
  }
  return counts;
}

void print_findings(const CheckedFiles& files, const CheckReport& report, std::size_t most) {
  std::size_t of_level = 0;
  bool is_cut = false;
  for (std::size_t k = 0; k < report.findings.size(); ++k) {
    if (k > 0 && report.findings[k].level != report.findings[k - 1].level) of_level = 0;
    if (of_level++ < most) {
      fmt::print("{}\n", finding_line(files.claim, report.findings[k]));
    } else {
      is_cut = true;
    }
  }
  if (is_cut) {
    fmt::print("(of each level, {} at most are shown)\n", with_commas(most));
  }
  if (!report.findings.empty()) fmt::print("\n");
}

std::string level_verdict(const std::optional<bool>& conforms, const LevelCount& count) {
  return conforms ? verdict_text(count.verdict) : "nothing to judge";
}

void print_levels(const CheckReport& report) {
  const auto counts = count_levels(report);
  Table table("lllrr", {"level", "", "verdict", "wrong", "permitted"});
  for (std::size_t k = 0; k < kLevels; ++k) {
    table.row(fmt::format("{}", k + 1)).cell(kLevelNames.at(k));
    table.cell(level_verdict(report.conforms.at(k), counts.at(k)));
    table.cell(counts.at(k).wrong).cell(counts.at(k).varied);
  }
  table.print();
}

Json levels_field(const CheckReport& report) {
  const auto counts = count_levels(report);
  Json levels = Json::object();
  for (std::size_t k = 0; k < kLevels; ++k) {
    const std::optional<bool>& conforms = report.conforms.at(k);
    Json& level = levels[fmt::format("{}", k + 1)];
    level["conforms"] = conforms ? Json(*conforms) : Json(nullptr);
    level["wrong"] = counts.at(k).wrong;
    level["permitted"] = counts.at(k).varied;
    level["not_decided"] = counts.at(k).undecided;
  }
  return levels;
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
  const std::string place = finding.line ? fmt::format("{}:{}", claim, *finding.line) : claim;
  return fmt::format("{}: {}, level {}: {} [{}]: claimed {}; truth: {}", place,
                     !finding.is_variation ? "wrong"
                     : finding.is_decided  ? "permitted"
                                           : "not decided",
                     finding.level, reason_text(finding.reason), finding.clause, finding.claimed, finding.truth);
}

Json finding_field(const Finding& finding) {
  Json field;
  field["level"] = finding.level;
  field["reason"] = reason_text(finding.reason);
  field["permitted"] = finding.is_variation;
  field["decided"] = finding.is_decided;
  field["clause"] = finding.clause;
  field["line"] = finding.line ? Json(*finding.line) : Json(nullptr);
  field["contact"] = finding.contact;
  field["claimed"] = finding.claimed;
  field["truth"] = finding.truth;
  return field;
}

void print_check_text(const CheckedFiles& files, const CheckReport& report, std::size_t most) {
  print_findings(files, report, most);
  print_row("critical points of index", "claimed", "        truth");
  for (std::size_t index = 0; index < 4; ++index) {
    print_row(fmt::format("  {}", index), with_commas(report.claimed_counts.at(index)),
              files.highest_level < 2 ? "" : fmt::format("{:>13}", with_commas(report.true_counts.at(index))));
  }
  fmt::print("\n");
  print_levels(report);
  for (const std::string& what : report.not_judged) fmt::print("not judged: {}\n", what);
  for (const std::string& what : report.not_decided) fmt::print("not decided: {}\n", what);
  fmt::print("\n{} ({}", verdict_text(report.verdict), grade_text(report));
  if (!report.is_exact) fmt::print(", tolerance {} of the radius", files.tolerance);
  fmt::print("; truth by the {})\n", truth_text(files));
}

void print_check_json(const CheckedFiles& files, const CheckReport& report, const PointSet& points) {
  Json json = header_fields("flowcert-check", 1, points);
  json["verdict"] = verdict_text(report.verdict);
  json["grade"] = grade_text(report);
  json["tolerance"] = files.tolerance;
  json["truth"] = truth_text(files);
  json["claim_format"] = files.claim_format;
  json["claimed"] = report.claimed_counts;
  json["critical"] = files.highest_level < 2 ? Json(nullptr) : Json(report.true_counts);
  json["levels"] = levels_field(report);
  json["not_judged"] = report.not_judged;
  json["not_decided"] = report.not_decided;
  Json& findings = json["findings"] = Json::array();
  for (const Finding& finding : report.findings) findings.push_back(finding_field(finding));
  fmt::print("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
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
                     skipped);
  for (std::size_t k = 0; k < kLevels; ++k) write_level(out, files, report, k, counts.at(k));
  out << "  </testsuite>\n</testsuites>\n";
}

// ---- Options ----

namespace {

// With a larger tolerance, nearly every claim is ambiguous.
constexpr double kLargestTolerance = 1e-3;

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
                  "Positions and radii claimed in decimals match within this part of the radius")
      ->check(complaint_about_tolerance)
      ->capture_default_str();
  command.add_option("--levels", options.highest_level, "Check levels 1 to this one")
      ->check(CLI::Range(1, kLevels))
      ->capture_default_str();
  command.add_flag("--strict", is_strict, "Exit with status 1 also if the verdict is 'perturbed'");
}

}  // namespace flowcert::cli
