#include "io/foreign_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace flowcert::io {

namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;  // in bytes; 0: the first byte begins no character
};

// UTF-8 as RFC 3629 has it: the shortest form, no surrogates.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t size = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < size) return {};
  std::uint32_t code = byte(0) & (0x7fU >> size);
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(k) & 0xc0U) != 0x80) return {};
    code = code << 6U | (byte(k) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast[size] || is_surrogate || code > 0x10ffff) return {};
  return {code, size};
}

// Marks and controls of direction, separators of lines, and what no terminal shows.
bool is_hidden(std::uint32_t code) {
  static constexpr auto kRanges = std::to_array<std::pair<std::uint32_t, std::uint32_t>>({{0x7f, 0x9f},
                                                                                          {0xad, 0xad},
                                                                                          {0x61c, 0x61c},
                                                                                          {0x180e, 0x180e},
                                                                                          {0x200b, 0x200f},
                                                                                          {0x2028, 0x202e},
                                                                                          {0x2060, 0x206f},
                                                                                          {0xfeff, 0xfeff},
                                                                                          {0xfff9, 0xfffb},
                                                                                          {0xe0000, 0xe007f}});
  return std::ranges::any_of(kRanges, [&](const auto& range) { return code >= range.first && code <= range.second; });
}

std::string escaped(const Character& character) {
  switch (character.code) {
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    default:
      if (character.code < 0x80) return fmt::format("\\x{:02x}", character.code);
      if (character.code < 0x10000) return fmt::format("\\u{:04x}", character.code);
      return fmt::format("\\U{:08x}", character.code);
  }
}

}  // namespace

std::string on_one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.size == 0) {
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    } else if (character.code < 0x20 || is_hidden(character.code)) {
      line += escaped(character);
    } else {
      line += text.substr(0, character.size);
    }
    text.remove_prefix(std::max<std::size_t>(character.size, 1));
  }
  return line;
}

std::string_view front_of(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t size = most;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80) --size;
  return text.substr(0, size);
}

std::string json_with_escapes(std::string_view json) {
  std::string result;
  while (!json.empty()) {
    const Character character = first_character(json);
    const std::size_t size = std::max<std::size_t>(character.size, 1);
    if (!is_hidden(character.code)) {
      result += json.substr(0, size);
    } else if (character.code < 0x10000) {
      result += fmt::format("\\u{:04x}", character.code);
    } else {
      const std::uint32_t above = character.code - 0x10000;
      result += fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + (above >> 10U), 0xdc00 + (above & 0x3ffU));
    }
    json.remove_prefix(size);
  }
  return result;
}

}  // namespace flowcert::io
