// The parts of a help as it is printed: the names of commands, and examples.
#pragma once

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance {

// All commands of all groups. A group is a list below a heading, and no list of options, arguments or examples.
inline std::vector<std::string> commands_in(const std::string& help) {
  std::vector<std::string> names;
  bool is_below = false;
  for (const std::string& line : lines_of(help)) {
    std::smatch found;
    if (!line.starts_with(' ')) {
      is_below = line.ends_with(':') && !line.ends_with("xamples:") && line != "Options:" && line != "Positionals:";
    }
    if (is_below && std::regex_search(line, found, std::regex("^  ([a-z][a-z-]+)  "))) names.push_back(found[1]);
  }
  return names;
}

// Each on one line, as a shell reads it.
inline std::vector<std::string> examples_in(const std::string& help) {
  std::vector<std::string> examples;
  bool is_below = false;
  for (const std::string& line : lines_of(help)) {
    if (!line.starts_with(' ')) is_below = line.ends_with("xamples:");
    if (!is_below || !line.starts_with(' ')) continue;
    if (line.starts_with("    ") && !examples.empty()) {
      examples.back().resize(examples.back().size() - std::min<std::size_t>(examples.back().size(), 1));
      examples.back() += line.substr(4);
    } else {
      examples.push_back(line.substr(2));
    }
  }
  return examples;
}

}  // namespace flowcert::conformance
