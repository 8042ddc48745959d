// The three ways in which `flowcert check` reports: lines for people, one JSON object, and a JUnit file for
// CI systems (src/cli/manual/check.md).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "cli/command.h"
#include "cli/layer.h"
#include "flowcert/check.h"
#include "io/json_fields.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::cli {

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

// A finding's further lines begin with so many blanks, for people.
inline constexpr std::size_t kFindingIndent = 4;

// "CLAIM:LINE: wrong, level 2: ..."
[[nodiscard]] std::string finding_line(const std::string& claim, const Finding& finding);
// atoms: of a molecule.
[[nodiscard]] Json finding_field(const Finding& finding, const AtomNames* atoms = nullptr);

// The last lines for people: the profile and the verdict. tolerance: how it is said, or nothing for an exact claim.
void print_verdict(const CheckedFiles& files, Verdict verdict, const Profile& profile, const std::string& tolerance);
// The keys with which the JSON of every kind of claim begins.
[[nodiscard]] Json judgement_fields(const CheckedFiles& files, Verdict verdict, const Profile& profile,
                                    const PointSet& points);

// The JSON of a report in which other people's text may be (io/foreign_text.h).
void print_report_json(const Json& json, int indent = -1);

// Shows one finding of each reason first, and then at most `most` others of each level. The tables count all of them.
void print_check_text(const CheckedFiles& files, const CheckReport& report, std::size_t most);
void print_check_json(const CheckedFiles& files, const CheckReport& report, const PointSet& points);
void write_check_junit(std::ostream& out, const CheckedFiles& files, const CheckReport& report);

// The options --tolerance, --levels and --strict, which all commands that judge claims share.
void add_judging_options(CLI::App& command, CheckOptions& options, bool& is_strict);
// The exit status that a verdict brings.
[[nodiscard]] int status_of(Verdict verdict, bool is_strict);

}  // namespace flowcert::cli
