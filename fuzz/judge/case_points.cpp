// See case_points.h.
#include "fuzz/judge/case_points.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "io/number_text.h"

namespace flowcert::judge {

namespace {

std::string decimal_text(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

// The vectors have hexadecimal floats. A program that reads none must not refuse an invalid case for that.
std::string word_text(const std::string& word, bool hexadecimal) {
  const bool is_hexadecimal = word.find("0x") != std::string::npos;
  if (hexadecimal || !is_hexadecimal) return word;
  const NumberText number = parse_number(word);
  return number.fault == nullptr ? decimal_text(number.value) : word;
}

}  // namespace

std::optional<std::string> point_file_text(const VectorCase& one, const PointFileStyle& style) {
  const bool is_xyz = style.format == PointFileFormat::kXyz;
  if (one.text) return is_xyz ? one.text : std::nullopt;
  std::string text = is_xyz ? "" : fmt::format("OFF\n{} 0 0\n", one.words.size());
  // An XYZ file of no byte is an error (FC-IN-05).
  if (is_xyz && one.words.empty()) text = "# no points\n";
  for (const auto& row : one.words) {
    const char* separator = "";
    for (const std::string& word : row) {
      text += separator;
      text += word_text(word, style.hexadecimal);
      separator = " ";
    }
    text += '\n';
  }
  return text;
}

std::string point_file_name(const PointFileStyle& style) {
  return style.format == PointFileFormat::kXyz ? "points.xyz" : "points.off";
}

}  // namespace flowcert::judge
