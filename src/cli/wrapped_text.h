// Text for people in lines of at most 80 columns.
//
// Guarantees: only blanks are dropped and only line ends and indents are added. A line is longer than 80 columns in no
// case. The code is our own: neither {fmt} nor Boost nor CLI11 2.1 breaks lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/layer.h"

namespace flowcert::cli {

inline constexpr std::size_t kLineWidth = 80;

// How many columns a text in UTF-8 takes.
[[nodiscard]] std::size_t columns_of(std::string_view text);

// The text with line ends where it would be too wide. All lines but the first begin with `indent` blanks, at most 40.
// A line that the text ends itself is indented as it is written. Lines are broken at blanks. A word that fits no line
// is broken after a comma or a slash, or else anywhere.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent);

}  // namespace flowcert::cli
