// A file in memory, whole.
#pragma once

#include <string>

#include "io/layer.h"

namespace flowcert::io {

// The bytes of the file at `path`; "-" is standard input. Throws InvalidInput "FILE: reason" when it cannot
// be opened or read.
[[nodiscard]] std::string read_bytes(const std::string& path);

}  // namespace flowcert::io
