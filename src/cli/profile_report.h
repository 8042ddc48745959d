// The profile of a claim or a program (FC-CLAIM-22), as each of the three sorts of reports says it.
#pragma once

#include <string>

#include "cli/layer.h"
#include "flowcert/check.h"
#include "flowcert/profile.h"
#include "io/json_fields.h"

namespace flowcert::cli {

// A verdict on what was judged, and with which tolerance.
struct JudgedProfile {
  Verdict verdict;
  Profile profile;
  double tolerance;
  std::string note = {};  // comes after the statement, such as the number of vectors
};

// A line for people: the statement, or that there is none for such a tolerance. Prints nothing if nothing is covered.
void print_conformity(const JudgedProfile& judged);
// specification, parts, grade, statement (src/cli/manual/check.md).
[[nodiscard]] Json profile_field(const JudgedProfile& judged);
// A line of a test suite in JUnit, or nothing if there is no statement.
[[nodiscard]] std::string junit_properties(const JudgedProfile& judged);

}  // namespace flowcert::cli
