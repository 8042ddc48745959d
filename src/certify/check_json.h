// The report of a check as JSON (src/cli/manual/check.md).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "certify/layer.h"
#include "certify/list_report.h"
#include "certify/reason_tally.h"
#include "flowcert/atom_names.h"
#include "flowcert/check.h"
#include "io/json_fields.h"

namespace flowcert::certify {

struct CheckedFiles {
  std::string points;
  std::string claim;
  const AtomNames* atoms = nullptr;  // of a molecule
  std::string claim_format;
  bool by_oracle = false;
  CheckOptions check;
};

// What is said to be true: "oracle" or "fast implementation".
[[nodiscard]] const char* truth_text(const CheckedFiles& files);

[[nodiscard]] Json finding_field(const Finding& finding, const AtomNames* atoms = nullptr);

[[nodiscard]] Json check_json(const CheckedFiles& files, const CheckReport& report, const PointSet& points);
[[nodiscard]] Json check_json(const CheckedFiles& files, const PairReport& report, const PointSet& points);

// The text of a report in which other people's text may be (io/foreign_text.h).
[[nodiscard]] std::string report_text(const Json& json, int indent = -1);

// ---- What other forms of the report have, too ----

struct LevelCount {
  std::size_t wrong = 0;
  std::size_t varied = 0;
  std::size_t undecided = 0;  // of those
  Verdict verdict = Verdict::kConforms;
};

[[nodiscard]] std::array<LevelCount, kLevels> count_levels(const CheckReport& report);

// The reasons of what is wrong come first, then those of what is permitted. The numbers of examples are those of
// findings. An example is small if its contact set is.
[[nodiscard]] std::vector<ReasonRow> reasons_of(const CheckReport& report);

}  // namespace flowcert::certify
