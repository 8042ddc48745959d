// What the targets of readers have in common: bytes are a file, which is refused in one line or read, and
// what was read makes sense.
//
// Guarantees: only the first reading of the bytes may throw InvalidInput, and only with one short line that
// opens with the file's name. Any other exception passes through, and so is a finding.
#pragma once

#include <string>
#include <string_view>

#include "flowcert/claim.h"
#include "fuzz/inputs/byte_input.h"

namespace flowcert::fuzz {

[[nodiscard]] inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Of a file whose name is "a", or "a" with an ending.
[[nodiscard]] inline std::string complaint_about_refusal(const InvalidInput& error) {
  const std::string message = error.what();
  const bool is_one_line = message.find('\n') == std::string::npos;
  const bool names_file = message.starts_with("a:") || message.starts_with("a.");
  return is_one_line && names_file && message.size() <= 300
             ? ""
             : "the message is not one short line about the file: " + message;
}

// A point file `name`: all rows are finite; written as XYZ, which is exact, and read again they are the same,
// bit for bit; and reading the same bytes by content, where they are of the same format, gives the same.
[[nodiscard]] std::string complaint_about_points(Bytes bytes, const std::string& name);

// The oracle's reader, which is another one, accepts the same files, with the same rows. For XYZ and OBJ, and
// files that it means to read: not compressed, with LF or CR LF only, without a byte order mark.
[[nodiscard]] std::string complaint_against_oracle(Bytes bytes, const std::string& name);

// A claim of a format, by the name of Claim::format: numbers are in their ranges, and if it names rows of a
// fixed small input only, it can be judged.
[[nodiscard]] std::string complaint_about_claim(Bytes bytes, std::string_view format);

}  // namespace flowcert::fuzz
