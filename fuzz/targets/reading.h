// Checks for the targets of readers. The bytes are a file. It must be refused in one line, or be read, and then what
// was read must make sense.
//
// Guarantees: only the first reading of the bytes may throw InvalidInput, and only with one short line that
// opens with the file's name. Any other exception passes through, and so is a counterexample.
#pragma once

#include <string>
#include <string_view>

#include "flowcert/claim.h"
#include "fuzz/inputs/byte_input.h"

namespace flowcert::fuzz {

[[nodiscard]] inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The file's name must be "a", or "a" with an ending.
[[nodiscard]] inline std::string complaint_about_refusal(const InvalidInput& error) {
  const std::string message = error.what();
  const bool is_one_line = message.find('\n') == std::string::npos;
  const bool names_file = message.starts_with("a:") || message.starts_with("a.");
  return is_one_line && names_file && message.size() <= 300
             ? ""
             : "the message is not one short line about the file: " + message;
}

// All rows of a point file `name` must be finite, and be the same bit for bit when written as XYZ and read again.
// Reading the bytes by content must give the same rows, if it finds the same format. The oracle's own reader must
// accept the same XYZ and OBJ files, with the same rows. This is for files that the oracle means to read: not
// compressed, with LF or CR LF only, without a byte order mark.
[[nodiscard]] std::string complaint_about_points(Bytes bytes, const std::string& name);

// The numbers of a claim of the format with this Claim::format must be in their ranges. If it names only rows of a
// fixed small input, it must be possible to judge it.
[[nodiscard]] std::string complaint_about_claim(Bytes bytes, std::string_view format);

}  // namespace flowcert::fuzz
