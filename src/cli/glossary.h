// The words of the field, and those of this program, each in a sentence or two: `flowcert help WORD`.
//
// Guarantees: every word has one entry. A word is found without regard to case, hyphens and an s at its end.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/layer.h"

namespace flowcert::cli {

struct GlossaryEntry {
  const char* word;
  const char* meaning;
};

// In alphabetical order.
[[nodiscard]] std::span<const GlossaryEntry> glossary();

// Nothing where there is no such word.
[[nodiscard]] const GlossaryEntry* entry_of(std::string_view word);

// The words that have this one in them, or are in it; empty where there are none.
[[nodiscard]] std::string nearest_words(std::string_view word);

// The words in lines of 80 columns.
[[nodiscard]] std::string words_of_glossary();

}  // namespace flowcert::cli
