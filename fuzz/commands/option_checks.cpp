// See option_checks.h.
#include "fuzz/commands/option_checks.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <system_error>

#include "fuzz/judge/command_template.h"
#include "io/number_text.h"

namespace flowcert::commands {

std::string has_in(const std::string& command) {
  return has_place(command, "{in}") ? "" : "there is no {in} in the command";
}

std::string is_seed(const std::string& word) {
  std::uint64_t seed = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), seed);
  const bool is_one = result.ec == std::errc() && result.ptr == word.data() + word.size();
  return is_one ? "" : in_quotes(word) + " is no number from 0 to 18446744073709551615";
}

std::string fault_of_seconds(const std::string& word, double most, const std::string& span) {
  const NumberText number = parse_number(word);
  const bool is_right = number.fault == nullptr && 0 < number.value && number.value <= most;
  return is_right ? "" : fmt::format("{} is no number of seconds, of at most {}", in_quotes(word), span);
}

}  // namespace flowcert::commands
