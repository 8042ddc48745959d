// What made a file, for formats that have room for a comment only.
#pragma once

#include <string>

#include "io/layer.h"

namespace flowcert::io {

// One line: format and its version, the reproducibility line, the hash of the input.
[[nodiscard]] std::string made_by_text(const char* format, int format_version,
                                       const std::string& input_sha256);

}  // namespace flowcert::io
