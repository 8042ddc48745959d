// The profile of a claim or a program (FC-CLAIM-22) with the verdict on it, as reports say it.
#pragma once

#include <optional>
#include <string>

#include "certify/layer.h"
#include "flowcert/check.h"
#include "flowcert/profile.h"
#include "io/json_fields.h"

namespace flowcert::certify {

// A verdict on what was judged, and with which tolerance.
struct JudgedProfile {
  Verdict verdict;
  Profile profile;
  double tolerance;
  std::string note = {};  // comes after the statement, such as the number of vectors
};

// "conforms to 1.2, points + U2, exact", with the note; nothing where conformity_text() has nothing.
[[nodiscard]] std::optional<std::string> statement_of(const JudgedProfile& judged);
// specification, parts, grade, statement (src/cli/manual/check.md).
[[nodiscard]] Json profile_field(const JudgedProfile& judged);

}  // namespace flowcert::certify
