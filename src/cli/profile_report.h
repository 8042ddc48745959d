// The profile of a claim or a program (FC-CLAIM-22), as each of the three sorts of reports says it.
#pragma once

#include <string>

#include "cli/layer.h"
#include "flowcert/check.h"
#include "flowcert/profile.h"
#include "io/json_fields.h"

namespace flowcert::cli {

// In all three a `note` comes after the statement, such as the number of vectors.

// A line for people. Nothing is printed if nothing is told.
void print_conformity(Verdict verdict, const Profile& profile, const std::string& note = "");
// specification, parts, grade, statement (spec/formats/check.md).
[[nodiscard]] Json profile_field(Verdict verdict, const Profile& profile, const std::string& note = "");
// A line of a test suite in JUnit, or nothing if nothing is told.
[[nodiscard]] std::string junit_properties(Verdict verdict, const Profile& profile, const std::string& note = "");

}  // namespace flowcert::cli
