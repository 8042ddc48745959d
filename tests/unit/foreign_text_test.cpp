// Text that is not our own, as a terminal gets it: whatever bytes it has, the result is one line that moves no cursor,
// turns no text round and hides nothing.
#include "io/foreign_text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/hostile_text.h"
#include "tests/unit/portable_random.h"

namespace flowcert::foreign_text_test {
namespace {

using flowcert_tests::hostile_texts;
using flowcert_tests::is_harmless;
using io::front_of;
using io::on_one_line;

TEST(ForeignText, IsShownAsDescribed) {
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"", ""},
      {"plain", "plain"},
      {"a\nb\tc\rd", "a\\nb\\tc\\x0dd"},
      {"\x1b[2J\x1b[32mconforms", "\\x1b[2J\\x1b[32mconforms"},
      {"\x7f", "\\x7f"},
      {std::string("a\0b", 3), "a\\x00b"},
      // A control of eight bits: as a byte it is no UTF-8, as a character it is one of C1.
      {"\x9b"
       "31m",
       "\\x9b31m"},
      {"\u009b31m", "\\u009b31m"},
      {"\u202ecba\u2069", "\\u202ecba\\u2069"},
      {"\u200bz\ufeff", "\\u200bz\\ufeff"},
      {"\U000e0041", "\\U000e0041"},
      {"é ü 中 😀", "é ü 中 😀"},
      // Too long a form, a surrogate, beyond Unicode, cut short.
      {"\xc0\xaf", "\\xc0\\xaf"},
      {"\xed\xa0\x80", "\\xed\\xa0\\x80"},
      {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
      {"\xe4\xb8", "\\xe4\\xb8"},
  };
  for (const auto& [text, shown] : texts) EXPECT_EQ(on_one_line(text), shown);
}

TEST(ForeignText, IsHarmlessWhateverItHas) {
  for (const std::string& text : hostile_texts()) {
    EXPECT_TRUE(is_harmless(on_one_line(text))) << on_one_line(text);
    EXPECT_EQ(on_one_line(on_one_line(text)), on_one_line(text));
    EXPECT_FALSE(is_harmless(text)) << on_one_line(text);
  }
  flowcert_tests::PortableRandom random(1);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t k = random.below(8); k > 0; --k) text += static_cast<char>(random.below(256));
    const std::string shown = on_one_line(text);
    ASSERT_TRUE(is_harmless(shown)) << shown;
    ASSERT_EQ(on_one_line(shown), shown);
    // What is harmless stays as it is.
    if (is_harmless(text)) {
      ASSERT_EQ(shown, text);
    }
  }
}

TEST(ForeignText, IsCutBetweenCharacters) {
  EXPECT_EQ(front_of("abc", 3), "abc");
  EXPECT_EQ(front_of("abcd", 3), "abc");
  EXPECT_EQ(front_of("aé", 2), "a");
  EXPECT_EQ(front_of("😀", 3), "");
}

}  // namespace
}  // namespace flowcert::foreign_text_test
