// See command_template.h.
#include "fuzz/judge/command_template.h"

#include <algorithm>

namespace flowcert::judge {

// Words without a meaning for the shell stay as they are, so that a user's own quotes around a place, "{in}",
// do no harm.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

bool has_place(std::string_view command, std::string_view place) {
  return command.find(place) != std::string_view::npos;
}

std::string filled_in(std::string_view command,
                      const std::vector<std::pair<std::string, std::string>>& values) {
  std::string text;
  while (!command.empty()) {
    const auto value = std::ranges::find_if(
        values, [&](const auto& candidate) { return command.starts_with(candidate.first); });
    if (value != values.end()) {
      text += shell_word(value->second);
      command.remove_prefix(value->first.size());
    } else {
      text += command.front();
      command.remove_prefix(1);
    }
  }
  return text;
}

}  // namespace flowcert::judge
