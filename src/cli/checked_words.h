// Checks of options' values that CLI11 does not have. Each returns what is wrong, in words; empty if nothing is.
#pragma once

#include <fmt/format.h>

#include <string>

#include "certify/programs/command_run.h"
#include "cli/layer.h"
#include "io/number_text.h"

namespace flowcert::cli {

// The command must have the place {in}.
[[nodiscard]] inline std::string complaint_about_missing_in(const std::string& command) {
  return has_place(command, "{in}") ? "" : "there is no {in} in the command";
}

// The seconds must be positive and at most `most`, which is `span` ("a day") in words. CLI11's range would take nan.
[[nodiscard]] inline std::string complaint_about_seconds(const std::string& word, double most,
                                                         const std::string& span) {
  const NumberText number = parse_number(word);
  const bool is_right = number.fault == nullptr && 0 < number.value && number.value <= most;
  return is_right ? "" : fmt::format("{} is no number of seconds, of at most {}", in_quotes(word), span);
}

}  // namespace flowcert::cli
