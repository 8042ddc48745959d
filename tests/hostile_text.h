// Texts that an attacker would put into a file, a claim or a program's answer, and what none of them may do.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flowcert_tests {

// Each does something to a terminal, a log or a reader that plain text does not.
inline std::vector<std::string> hostile_texts() {
  std::vector<std::string> texts = {
      "\x1b[2J\x1b[H\x1b[32mconforms\x1b[0m",
      "\x1b]0;title\x07",
      "\x1b]8;;http://example.org\x1b\\here\x1b]8;;\x1b\\",
      "\x1b[?1049h",
      "\x1bP$q\"p\x1b\\",
      "\x1b[6n",
      "\x1b"
      "c",
      "a\rconforms",
      "a\nflowcert: conforms",
      "a\r\nb",
      "a\tb",
      "a\vb",
      "a\fb",
      "a\bb\b\b",
      "bell\x07",
      "\x7f",
      std::string("nul\0nul", 7),
      "\x9b"
      "2J",
      "\x85",
      "\x90payload\x9c",
      "\u009b2J",
      "\u0085next line",
      "\u2028line",
      "\u2029paragraph",
      "\u202esmrofnoc",
      "\u202dleft\u202c",
      "\u2066isolate\u2069",
      "\u2067isolate\u2069",
      "\u200eleft",
      "\u200fright",
      "\u061carabic",
      "con\u200bforms",
      "con\u00adforms",
      "\ufeffmark",
      "con\u2060forms",
      "\U000e0063\U000e006f",
      "\xff\xfe",
      "\xc0\x9b"
      "2J",
      "\xed\xa0\x80\xed\xb0\x80",
      "\xf8\x88\x80\x80\x80",
      "\xe2\x80",
  };
  return texts;
}

// One line of UTF-8 with neither controls nor marks that are not seen. Decoded here by itself.
inline bool is_harmless(std::string_view text) {
  for (std::size_t k = 0; k < text.size();) {
    const auto byte = [&](std::size_t at) {
      return at < text.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(text[at])) : 0U;
    };
    const std::uint32_t first = byte(k);
    std::size_t more = 0;
    std::uint32_t code = first;
    if (first >= 0x80) {
      if (first >= 0xc2 && first <= 0xdf) {
        more = 1;
        code = first - 0xc0;
      } else if (first >= 0xe0 && first <= 0xef) {
        more = 2;
        code = first - 0xe0;
      } else if (first >= 0xf0 && first <= 0xf4) {
        more = 3;
        code = first - 0xf0;
      } else {
        return false;
      }
    }
    for (std::size_t j = 1; j <= more; ++j) {
      if (byte(k + j) < 0x80 || byte(k + j) > 0xbf) return false;
      code = code * 64 + (byte(k + j) - 0x80);
    }
    const std::pair<std::uint32_t, std::uint32_t> forbidden[] = {
        {0, 0x1f},        {0x7f, 0x9f},     {0xad, 0xad},     {0x61c, 0x61c},   {0x180e, 0x180e}, {0x200b, 0x200f},
        {0x2028, 0x202e}, {0x2060, 0x206f}, {0xd800, 0xdfff}, {0xfeff, 0xfeff}, {0xfff9, 0xfffb}, {0xe0000, 0xe007f}};
    for (const auto& [from, to] : forbidden) {
      if (code >= from && code <= to) return false;
    }
    if (code > 0x10ffff || (more == 2 && code < 0x800) || (more == 3 && code < 0x10000)) return false;
    k += more + 1;
  }
  return true;
}

}  // namespace flowcert_tests
