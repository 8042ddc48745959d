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

const char* clause_of(const PairReport& report) { return report.is_of_cycles ? "FC-CLAIM-25" : "FC-CLAIM-11"; }
// Those that are claimed, and are wrong.
const char* wrong_word(const PairReport& report) { return report.is_of_cycles ? "wrong" : "spurious"; }

struct DifferenceCounts {
  std::size_t spurious = 0, missing = 0;
};

DifferenceCounts counts_of(const PairReport& report, std::size_t dimension) {
  DifferenceCounts counts;
  for (const PairDifference& difference : report.differences) {
    if (static_cast<std::size_t>(difference.dimension) != dimension) continue;
    counts.spurious += difference.is_claimed ? 1 : 0;
    // A wrong cycle comes with what is wrong with it.
    counts.missing += difference.is_true && !(report.is_of_cycles && difference.is_claimed) ? 1 : 0;
  }
  return counts;
}

// "CLAIM:LINE: wrong-pair [FC-CLAIM-11]: claimed ...; truth: ..."
std::string difference_line(const CheckedFiles& files, const PairReport& report, const PairDifference& difference) {
  const std::string line = difference.line > 0 ? fmt::format(":{}", difference.line) : "";
  return on_one_line(fmt::format("{}{}: {} [{}]: claimed {}; truth: {}", files.claim, line, difference.reason,
                                 clause_of(report), difference.claimed, difference.truth));
}

}  // namespace

PairReport report_of_pairs(const std::vector<ClaimedPair>& claimed, const std::vector<ListedPair>& truth,
                           double tolerance) {
  PairReport report;
  report.differences = pair_differences(claimed, truth, tolerance);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  report.profile.set(ProfilePart::kPersistence, Profile::State::kCovered);
  report.profile.set_exact(std::ranges::all_of(claimed, is_exact_pair));
  report.claimed = pair_counts(claimed);
  report.truth = pair_counts(truth);
  return report;
}

PairReport report_of_cycles(const CycleClaim& claim, const FlowComplex& complex, double tolerance) {
  PairReport report;
  report.is_of_cycles = true;
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
  Table table("llrrrr", {"dimension", "", "claimed", "truth", wrong_word(report), "missing"});
  constexpr const char* kNames[] = {"components", "tunnels", "voids"};
  for (std::size_t dimension = 0; dimension < report.truth.size(); ++dimension) {
    const DifferenceCounts counts = counts_of(report, dimension);
    table.row(fmt::format("{}", dimension)).cell(kNames[dimension]).cell(report.claimed.at(dimension));
    table.cell(report.truth.at(dimension)).cell(counts.spurious).cell(counts.missing);
  }
  table.print();
  print_verdict(files, report.verdict, report.profile,
                report.profile.is_exact() ? "" : fmt::format(", tolerance {}", files.check.tolerance));
}

void print_check_json(const CheckedFiles& files, const PairReport& report, const PointSet& points) {
  Json json = judgement_fields(files, report.verdict, report.profile, points);
  Json& pairs = json[report.is_of_cycles ? "cycles" : "pairs"] = Json::array();
  for (std::size_t dimension = 0; dimension < report.truth.size(); ++dimension) {
    const DifferenceCounts counts = counts_of(report, dimension);
    pairs.push_back({{"dimension", dimension},
                     {"claimed", report.claimed.at(dimension)},
                     {"true", report.truth.at(dimension)},
                     {wrong_word(report), counts.spurious},
                     {"missing", counts.missing}});
  }
  Json& findings = json["findings"] = Json::array();
  for (const PairDifference& difference : report.differences) {
    findings.push_back({{"reason", difference.reason},
                        {"clause", clause_of(report)},
                        {"line", difference.line > 0 ? Json(difference.line) : Json(nullptr)},
                        {"dimension", difference.dimension},
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
      << "    <testcase classname=\"flowcert.check\" name=\"" << (report.is_of_cycles ? "cycles" : "persistence pairs")
      << '"';
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
