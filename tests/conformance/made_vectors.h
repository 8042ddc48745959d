// Runs of flowcert-make-vectors, and the comparison of what they write with spec/vectors/.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance {

inline Finished make_vectors(std::vector<std::string> arguments, const Streams& streams = {}) {
  arguments.insert(arguments.begin(), FLOWCERT_MAKE_VECTORS);
  return RunningProgram(arguments, streams).finish();
}

inline void expect_files_of_the_spec(const Scratch& folder, const std::set<std::string>& names) {
  EXPECT_EQ(folder.names(), names);
  for (const std::string& name : names) {
    const std::string expected = content_of(std::string(FLOWCERT_SPEC_FOLDER "/vectors/") + name);
    EXPECT_FALSE(expected.empty()) << name;
    EXPECT_TRUE(content_of(folder.path(name)) == expected) << name;
  }
}

}  // namespace flowcert::conformance
