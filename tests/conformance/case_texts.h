// What the tests of `flowcert generate` and `flowcert verify` share: streams of cases, taken apart.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance {

using Words = std::vector<std::string>;

inline Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::string generated(const Words& options = {}) {
  const Finished finished = flowcert(joined({"generate"}, options));
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.err, "");
  return finished.out;
}

// The cases of a stream, without comments. Each one begins with its line `case`.
inline std::vector<std::string> cases_of(const std::string& stream) {
  std::vector<std::string> cases;
  for (const std::string& line : lines_of(stream)) {
    if (line.starts_with('#')) continue;
    if (line.starts_with("case ")) cases.emplace_back();
    if (cases.empty()) {
      ADD_FAILURE() << "before the first case: " << line;
      return cases;
    }
    cases.back() += line + '\n';
  }
  return cases;
}

inline std::string id_of(const std::string& one) {
  std::istringstream words(one);
  std::string id;
  words >> id >> id;
  return id;
}

inline Words ids_of(const std::string& stream) {
  Words ids;
  for (const std::string& one : cases_of(stream)) ids.push_back(id_of(one));
  return ids;
}

}  // namespace flowcert::conformance
