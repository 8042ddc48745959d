#include "cli/shortened_numbers.h"

#include <algorithm>

namespace flowcert::cli {

namespace {

constexpr std::size_t kLongest = 24;
constexpr std::size_t kKept = 10;

}  // namespace

std::string with_short_numbers(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  std::string result;
  while (!text.empty()) {
    const std::size_t other = std::min(text.find_first_of(kDigits), text.size());
    result += text.substr(0, other);
    text.remove_prefix(other);
    const std::string_view digits = text.substr(0, std::min(text.find_first_not_of(kDigits), text.size()));
    text.remove_prefix(digits.size());
    if (digits.size() <= kLongest) {
      result += digits;
    } else {
      result.append(digits.substr(0, kKept)).append("...").append(digits.substr(digits.size() - kKept));
    }
  }
  return result;
}

}  // namespace flowcert::cli
