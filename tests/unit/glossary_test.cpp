// spec/glossary.md and `flowcert help WORD` say the same of the same words.
#include "cli/glossary.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace flowcert::glossary_test {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

// The page's entries: "- **word** (FC-ID): meaning", which may go on in lines with an indent of two.
Entries entries_of_page() {
  std::ifstream page(FLOWCERT_GLOSSARY);
  Entries entries;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("- **")) {
      const std::size_t end = line.find("**", 4), colon = line.find(": ", end);
      if (end == std::string::npos || colon == std::string::npos) return {};
      entries.emplace_back(line.substr(4, end - 4), line.substr(colon + 2));
    } else if (line.starts_with("  ") && !entries.empty()) {
      entries.back().second += line.substr(1);
    }
  }
  return entries;
}

TEST(Glossary, IsThatOfTheSpecification) {
  Entries entries;
  for (const cli::GlossaryEntry& entry : cli::glossary()) entries.emplace_back(entry.word, entry.meaning);
  EXPECT_EQ(entries_of_page(), entries);
}

TEST(Glossary, IsInAlphabeticalOrder) {
  std::string last;
  for (const cli::GlossaryEntry& entry : cli::glossary()) {
    EXPECT_LT(last, entry.word);
    last = entry.word;
  }
}

}  // namespace
}  // namespace flowcert::glossary_test
