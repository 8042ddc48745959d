// The three ways in which `flowcert conformance` reports: tables for people, one JSON object, and a JUnit
// file for CI systems (spec/formats/conformance.md).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "certify/programs/conformance_run.h"
#include "cli/layer.h"
#include "io/json_fields.h"

namespace flowcert::cli {

struct ConformanceReport {
  const Vectors& vectors;
  const ConformanceOptions& options;
  const std::vector<CaseOutcome>& outcomes;
  double seconds = 0;  // of the whole run

  // The verdict on the cases that were not skipped.
  [[nodiscard]] Verdict verdict() const;
  // What the answers to all cases cover (FC-CLAIM-22).
  [[nodiscard]] Profile profile() const;
};

// The differences of persistence pairs in a report for programs.
[[nodiscard]] Json persistence_findings_field(const std::vector<PairDifference>& differences);

// The outcomes that tables count cases by, in words.
[[nodiscard]] std::vector<std::string> tally_outcomes();

// At most `most` negative cases are shown; the others are counted.
void print_conformance_text(const ConformanceReport& report, std::size_t most);
[[nodiscard]] Json conformance_json(const ConformanceReport& report);
void print_conformance_json(const ConformanceReport& report);
void write_conformance_junit(std::ostream& out, const ConformanceReport& report);

}  // namespace flowcert::cli
