// Whether a claim in JSON says what it is of.
#pragma once

#include <string>
#include <string_view>

#include "certify/layer.h"
#include "io/line_reader.h"

namespace flowcert::certify {

// Whether the first line has this format's name in quotes. Blanks before it are trimmed.
[[nodiscard]] inline bool names_format(std::string_view json, const std::string& format) {
  std::string_view first;
  return LineReader(json, "").next(first) && first.find('"' + format + '"') != std::string_view::npos;
}

}  // namespace flowcert::certify
