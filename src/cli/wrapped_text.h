// Text for people in lines of at most 80 columns.
//
// Guarantees: only blanks are dropped and only line ends and indents are added. No line is wider than it may be. The
// code is our own: neither {fmt} nor Boost nor CLI11 2.1 breaks lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/layer.h"

namespace flowcert::cli {

inline constexpr std::size_t kLineWidth = 80;
// wrapped() makes a blank of it, but no line's end.
inline constexpr char kFixedBlank = '\x1f';

// How many columns a text in UTF-8 takes.
[[nodiscard]] std::size_t columns_of(std::string_view text);

// The text with line ends where it would be wider than `width`, which is at least 4. All lines but the first begin with
// `indent` blanks, at most three quarters of the width. A line that the text ends itself is indented as it is written.
// Lines are broken at blanks. A word that fits no line is broken after a comma or a slash, or else anywhere.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent, std::size_t width = kLineWidth);

// What is between the ends of lines.
[[nodiscard]] std::vector<std::string> split_lines(const std::string& text);

}  // namespace flowcert::cli
