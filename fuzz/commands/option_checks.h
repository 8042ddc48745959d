// What several commands ask of the values of their options. CLI11's own checks do not know these.
//
// Each returns what is wrong, in words; empty if nothing is.
#pragma once

#include <string>

#include "fuzz/commands/layer.h"

namespace flowcert::commands {

// A place {in} is in the command.
[[nodiscard]] std::string has_in(const std::string& command);
// All of the numbers that a seed can be, which CLI11 takes for the largest one where they are too large.
[[nodiscard]] std::string is_seed(const std::string& word);
// A positive number of seconds, at most so many, which are `span` ("a day"). CLI11's range takes nan for one.
[[nodiscard]] std::string fault_of_seconds(const std::string& word, double most, const std::string& span);

}  // namespace flowcert::commands
