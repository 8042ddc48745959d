// How `flowcert check` reports beside JSON (certify/check_json.h): by lines for people, and by a JUnit file for CI
// systems (src/cli/manual/check.md).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "certify/check_json.h"
#include "cli/command.h"
#include "cli/layer.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::cli {

// A finding's further lines begin with so many blanks, for people.
inline constexpr std::size_t kFindingIndent = 4;

// "CLAIM:LINE: wrong, level 2: ..."
[[nodiscard]] std::string finding_line(const std::string& claim, const Finding& finding);

// The last lines for people: the profile and the verdict. tolerance: how it is said, or nothing for an exact claim.
void print_verdict(const CheckedFiles& files, Verdict verdict, const Profile& profile, const std::string& tolerance);

// Prints report_text().
void print_report_json(const Json& json, int indent = -1);

// Shows one finding of each reason first, and then at most `most` others of each level. The tables count all of them.
void print_check_text(const CheckedFiles& files, const CheckReport& report, std::size_t most);
void write_check_junit(std::ostream& out, const CheckedFiles& files, const CheckReport& report);

// The options --tolerance, --highest-level and --strict, which all commands that judge claims share.
void add_judging_options(CLI::App& command, CheckOptions& options, bool& is_strict);
// The exit status that a verdict brings.
[[nodiscard]] int status_of(Verdict verdict, bool is_strict);

}  // namespace flowcert::cli
