// Counts as people read them.
#pragma once

#include <string>

#include "io/layer.h"

namespace flowcert::io {

// "34,835"
[[nodiscard]] std::string with_commas(unsigned long long value);

}  // namespace flowcert::io
