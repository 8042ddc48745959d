// What a reader may say when it refuses a file; see reading.h.
#include "fuzz/targets/reading.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kLongestMessage = 300;

}  // namespace

std::string complaint_about_refusal(const InvalidInput& error) {
  const std::string message = error.what();
  const bool is_one_line = message.find('\n') == std::string::npos;
  const bool names_file = message.starts_with("a:") || message.starts_with("a.");
  return is_one_line && names_file && message.size() <= kLongestMessage
             ? ""
             : "the message is not one short line about the file: " + message;
}

}  // namespace flowcert::fuzz
