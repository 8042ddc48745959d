// The profile of a claim or a program (FC-CLAIM-22), for people and for CI systems.
#pragma once

#include <string>

#include "certify/judged_profile.h"
#include "cli/layer.h"

namespace flowcert::cli {

// A line for people: the statement, or that there is none for such a tolerance. Prints nothing if nothing is covered.
void print_conformity(const JudgedProfile& judged);
// A line of a test suite in JUnit, or nothing if there is no statement.
[[nodiscard]] std::string junit_properties(const JudgedProfile& judged);

}  // namespace flowcert::cli
