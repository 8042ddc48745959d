// CITES("FC-CRIT-02", ...): the clauses of the spec that a test really checks.
//
// It is the first statement of each TEST body. The ids end up in GoogleTest's XML output (property "clauses",
// joined by blanks), and as text in the source, where the conformance test that compares spec and tests finds
// them.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace flowcert_tests {

inline std::string joined_clauses(std::initializer_list<const char*> clauses) {
  std::string joined;
  for (const char* clause : clauses) {
    if (!joined.empty()) joined += ' ';
    joined += clause;
  }
  return joined;
}

}  // namespace flowcert_tests

#define CITES(...) ::testing::Test::RecordProperty("clauses", ::flowcert_tests::joined_clauses({__VA_ARGS__}))
