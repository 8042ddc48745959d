// Reads a file that some other program left, of which nothing can be assumed.
//
// Guarantees: never waits (for the other end of a pipe), and never takes more memory than it was told.
#pragma once

#include <cstddef>
#include <string>

#include "fuzz/judge/layer.h"

namespace flowcert::judge {

// Throws InvalidInput, "NAME: reason", for what is missing, no regular file, or longer than `most` bytes.
[[nodiscard]] std::string read_bounded(const std::string& path, std::size_t most, const std::string& name);

}  // namespace flowcert::judge
