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

// "CLAIM:LINE: wrong-pair [FC-CLAIM-11]: claimed ...; truth: ..."
std::string difference_line(const CheckedFiles& files, const PairReport& report, const PairDifference& difference) {
  const std::string line = difference.line > 0 ? fmt::format(":{}", difference.line) : "";
  return on_one_line(fmt::format("{}{}: {} [{}]: claimed {}; truth: {}", files.claim, line, difference.reason,
                                 list_words(report).clause, difference.claimed, difference.truth));
}

}  // namespace

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
  const ListWords& words = list_words(report);
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

void write_check_junit(std::ostream& out, const CheckedFiles& files, const PairReport& report) {
  const bool is_right = report.differences.empty();
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      << fmt::format("  <testsuite name=\"{}\" tests=\"1\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n",
                     xml_text(fmt::format("flowcert check {} {}", files.points, files.claim)), is_right ? 0 : 1)
      << junit_properties({report.verdict, report.profile, files.check.tolerance})
      << "    <testcase classname=\"flowcert.check\" name=\"" << list_words(report).test_case << '"';
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
