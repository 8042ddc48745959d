// Fields of CSV (RFC 4180), for spreadsheets and data frames.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

// Empty for a number beyond the doubles.
[[nodiscard]] inline std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

// Quoted where it has a comma, a quote or a line's end.
[[nodiscard]] inline std::string csv_text(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace flowcert::io
