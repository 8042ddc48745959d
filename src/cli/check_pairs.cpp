#include "cli/check_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "cli/profile_report.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

// The words of a report, and of its rows in tables and in JSON.
struct ListWords {
  const char *clause, *key, *wrong, *row_key, *test_case;
  std::vector<const char*> rows;
  std::vector<Json> row_keys;
};

const ListWords& words_of(const PairReport& report) {
  static const std::vector<const char*> dimensions = {"components", "tunnels", "voids"};
  static const std::vector<Json> numbers = {0, 1, 2};
  static const std::array words = {
      ListWords{"FC-CLAIM-11", "pairs", "spurious", "dimension", "persistence pairs", dimensions, numbers},
      ListWords{"FC-CLAIM-25", "cycles", "wrong", "dimension", "cycles", dimensions, numbers},
      ListWords{"FC-CLAIM-26",
                "pores",
                "wrong",
                "kind",
                "pores",
                {"twice the peak", "", "twice the gate", "twice the exit"},
                {kPoreKinds.begin(), kPoreKinds.end()}}};
  return words.at(static_cast<std::size_t>(report.thing));
}

struct DifferenceCounts {
  std::size_t spurious = 0, missing = 0;
};

DifferenceCounts counts_of(const PairReport& report, std::size_t dimension) {
  DifferenceCounts counts;
  for (const PairDifference& difference : report.differences) {
    if (static_cast<std::size_t>(difference.dimension) != dimension) continue;
    counts.spurious += difference.is_claimed ? 1 : 0;
    // A wrong cycle or diameter comes with what is wrong with it.
    counts.missing += difference.is_true && !(report.thing != ListedThing::kPairs && difference.is_claimed) ? 1 : 0;
  }
  return counts;
}

// "CLAIM:LINE: wrong-pair [FC-CLAIM-11]: claimed ...; truth: ..."
std::string difference_line(const CheckedFiles& files, const PairReport& report, const PairDifference& difference) {
  const std::string line = difference.line > 0 ? fmt::format(":{}", difference.line) : "";
  return on_one_line(fmt::format("{}{}: {} [{}]: claimed {}; truth: {}", files.claim, line, difference.reason,
                                 words_of(report).clause, difference.claimed, difference.truth));
}

}  // namespace

PairReport report_of_pairs(const std::vector<ClaimedPair>& claimed, const std::vector<ListedPair>& truth,
                           double tolerance) {
  PairReport report;
  report.differences = pair_differences(claimed, truth, tolerance);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  report.profile.set(ProfilePart::kPersistence, Profile::State::kCovered);
  report.profile.set_exact(std::ranges::all_of(claimed, is_exact_pair));
  const auto counts = pair_counts(claimed), right = pair_counts(truth);
  report.claimed.assign(counts.begin(), counts.end());
  report.truth.assign(right.begin(), right.end());
  return report;
}

PairReport report_of_cycles(const CycleClaim& claim, const FlowComplex& complex, double tolerance) {
  PairReport report;
  report.thing = ListedThing::kCycles;
  report.claimed.resize(kPairDimensions), report.truth.resize(kPairDimensions);
  report.differences = cycle_differences(complex, claim, tolerance);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  if (claim.is_whole) report.profile.set(ProfilePart::kCycles, Profile::State::kCovered);
  report.profile.set_exact(is_exact_claim(claim));
  report.claimed.at(static_cast<std::size_t>(claim.dimension)) = claim.cycles.size();
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    report.truth.at(static_cast<std::size_t>(pair.dimension)) += pair.death ? 1 : 0;
  }
  return report;
}

PairReport report_of_pores(const PoreClaim& claim, const Pores& pores, double tolerance, const std::string& name) {
  PoreJudgement judgement = judge_pores(claim, pores, tolerance, name);
  PairReport report;
  report.thing = ListedThing::kPores;
  report.differences = std::move(judgement.differences);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  if (claim.is_whole) report.profile.set(ProfilePart::kPores, Profile::State::kCovered);
  report.profile.set_exact(judgement.is_exact);
  report.claimed.assign(judgement.claimed.begin(), judgement.claimed.end());
  report.truth.assign(judgement.truth.begin(), judgement.truth.end());
  if (!claim.is_whole) report.left_out.assign(judgement.left_out.begin(), judgement.left_out.end());
  return report;
}

void print_check_text(const CheckedFiles& files, const PairReport& report, std::size_t most) {
  const std::size_t shown = std::min(most, report.differences.size());
  std::set<std::string> told;
  for (std::size_t k = 0; k < shown; ++k) {
    const PairDifference& difference = report.differences[k];
    print_wrapped(with_short_numbers(difference_line(files, report, difference)), kFindingIndent);
    if (const std::string sentence = sentence_of(difference); told.insert(sentence).second) {
      fmt::print("{}{}\n", std::string(kFindingIndent, ' '),
                 wrapped(sentence, kFindingIndent, kLineWidth - kFindingIndent));
    }
  }
  if (shown < report.differences.size()) fmt::print("({} more)\n", with_commas(report.differences.size() - shown));
  if (!report.differences.empty()) fmt::print("\n");
  const ListWords& words = words_of(report);
  Table table("llrrrr", {words.row_key, "", "claimed", "truth", words.wrong, "missing"});
  for (std::size_t row = 0; row < report.truth.size(); ++row) {
    const DifferenceCounts counts = counts_of(report, row);
    const Json& key = words.row_keys[row];
    table.row(key.is_string() ? key.get<std::string>() : key.dump()).cell(words.rows[row]).cell(report.claimed.at(row));
    table.cell(report.truth.at(row)).cell(counts.spurious).cell(counts.missing);
  }
  table.print();
  for (std::size_t row = 0; row < report.left_out.size(); ++row) {
    if (report.left_out[row] == 0) continue;
    fmt::print("not claimed, which is not wrong: {} of the kind {}\n", with_commas(report.left_out[row]),
               kPoreKinds.at(row));
  }
  print_verdict(files, report.verdict, report.profile,
                report.profile.is_exact() ? "" : fmt::format(", tolerance {}", files.check.tolerance));
}

void print_check_json(const CheckedFiles& files, const PairReport& report, const PointSet& points) {
  Json json = judgement_fields(files, report.verdict, report.profile, points);
  const ListWords& words = words_of(report);
  Json& rows = json[words.key] = Json::array();
  for (std::size_t row = 0; row < report.truth.size(); ++row) {
    const DifferenceCounts counts = counts_of(report, row);
    rows.push_back({{words.row_key, words.row_keys[row]},
                    {"claimed", report.claimed.at(row)},
                    {"true", report.truth.at(row)},
                    {words.wrong, counts.spurious},
                    {"missing", counts.missing}});
    if (!report.left_out.empty()) rows.back()["not_claimed"] = report.left_out.at(row);
  }
  Json& findings = json["findings"] = Json::array();
  for (const PairDifference& difference : report.differences) {
    findings.push_back({{"reason", difference.reason},
                        {"clause", words_of(report).clause},
                        {"line", difference.line > 0 ? Json(difference.line) : Json(nullptr)},
                        {words.row_key, words.row_keys[static_cast<std::size_t>(difference.dimension)]},
                        {"claimed", difference.is_claimed ? Json(difference.claimed) : Json(nullptr)},
                        {"truth", difference.is_true ? Json(difference.truth) : Json(nullptr)},
                        {"sentence", sentence_of(difference)}});
  }
  print_report_json(json);
}

void write_check_junit(std::ostream& out, const CheckedFiles& files, const PairReport& report) {
  const bool is_right = report.differences.empty();
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      << fmt::format("  <testsuite name=\"{}\" tests=\"1\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n",
                     xml_text(fmt::format("flowcert check {} {}", files.points, files.claim)), is_right ? 0 : 1)
      << junit_properties({report.verdict, report.profile, files.check.tolerance})
      << "    <testcase classname=\"flowcert.check\" name=\"" << words_of(report).test_case << '"';
  if (is_right) {
    out << "/>\n";
  } else {
    out << fmt::format(">\n      <failure message=\"{} wrong\">", report.differences.size());
    for (const PairDifference& difference : report.differences) {
      out << xml_text(difference_line(files, report, difference)) << '\n';
    }
    out << "</failure>\n    </testcase>\n";
  }
  out << "  </testsuite>\n</testsuites>\n";
}

}  // namespace flowcert::cli
