// Long exact numbers in text for people. Output for programs has them whole.
#pragma once

#include <string>
#include <string_view>

#include "cli/layer.h"

namespace flowcert::cli {

// The text with the middle of each long number left out: of more than 24 digits in a row the first and last ten stay,
// "1234567890...1234567890". So a rational has at most 48 characters, and its denominator is still seen as one.
[[nodiscard]] std::string with_short_numbers(std::string_view text);

}  // namespace flowcert::cli
