// Lines of at most 80 columns, and long numbers that are shortened in the middle: on words, numbers and bytes at
// random, and at both sides of each limit. Tables of counts and of reasons.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "cli/reason_table.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"

namespace flowcert::text_for_people_test {

using namespace cli;
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text + '\n');
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string without(std::string text, const std::string& dropped) {
  std::erase_if(text, [&](char c) { return dropped.find(c) != std::string::npos; });
  return text;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text.append(text.empty() ? "" : "\n").append(line);
  return text;
}

std::string row_of(std::size_t count, char c, const std::string& indent = "") {
  return std::string(indent).append(count, c);
}

TEST(WrappedText, ShortTextStaysAsItIs) {
  for (const std::string text : {"", "a", "  two  blanks ", "one\ntwo\n", "\n\n"}) EXPECT_EQ(wrapped(text, 4), text);
  EXPECT_EQ(wrapped(row_of(80, 'x'), 4), row_of(80, 'x'));
  EXPECT_EQ(wrapped(row_of(79, 'x') + " y", 4), joined({row_of(79, 'x'), "    y"}));
}

TEST(WrappedText, LinesAreBrokenAtBlanksAndIndented) {
  const std::string words = row_of(40, 'a') + ' ' + row_of(39, 'b') + ' ' + row_of(75, 'c') + " d";
  const std::string first = row_of(40, 'a') + ' ' + row_of(39, 'b');
  EXPECT_EQ(wrapped(words, 4), joined({first, row_of(75, 'c', "    "), "    d"}));
  EXPECT_EQ(wrapped("  " + words, 0), joined({row_of(40, 'a', "  "), row_of(39, 'b'), row_of(75, 'c') + " d"}));
}

TEST(WrappedText, LineEndsOfTheTextStay) {
  const std::string wide = row_of(78, 'x', "  ");
  EXPECT_EQ(wrapped(joined({"first", wide + " y", "last"}), 6), joined({"first", wide, "      y", "last"}));
}

TEST(WrappedText, WordsThatFitNoLineAreBrokenAfterCommasOrSlashes) {
  EXPECT_EQ(wrapped(row_of(50, '1') + ',' + row_of(40, '2'), 2),
            joined({row_of(50, '1') + ',', row_of(40, '2', "  ")}));
  EXPECT_EQ(wrapped(row_of(79, '1') + '/' + row_of(40, '2'), 2),
            joined({row_of(79, '1') + '/', row_of(40, '2', "  ")}));
  EXPECT_EQ(wrapped(row_of(200, 'x'), 2), joined({row_of(80, 'x'), row_of(78, 'x', "  "), row_of(42, 'x', "  ")}));
}

TEST(WrappedText, AFixedBlankIsNoPlaceForALineEnd) {
  const std::string clause = std::string("(b") + kFixedBlank + "c)";
  EXPECT_EQ(wrapped(row_of(77, 'x') + ' ' + clause, 2), joined({row_of(77, 'x'), "  (b c)"}));
  EXPECT_EQ(wrapped(row_of(75, 'x') + clause, 2), row_of(75, 'x') + "(b c)");
}

TEST(WrappedText, ColumnsAreCharacters) {
  std::string umlauts;
  for (int k = 0; k < 80; ++k) umlauts += "ü";
  EXPECT_EQ(columns_of(umlauts), 80U);
  EXPECT_EQ(wrapped(umlauts, 2), umlauts);
  EXPECT_EQ(wrapped(umlauts + "ü", 2), umlauts + "\n  ü");
}

TEST(WrappedText, AnyTextFitsAndLosesNothing) {
  std::mt19937 random(1);
  const std::string alphabet = "ab  ,/7\n\xc3\xbc\x80";
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text;
    for (std::size_t k = random() % 700; k > 0; --k) text += alphabet[random() % alphabet.size()];
    if (trial % 2 == 0) text = without(text, " ");
    const std::string result = wrapped(text, random() % 90);
    for (const std::string& line : lines_of(result)) EXPECT_LE(columns_of(line), 80U) << line;
    EXPECT_EQ(without(result, " \n"), without(text, " \n"));
  }
}

TEST(ShortNumbers, OnlyLongOnesAreShortened) {
  EXPECT_EQ(with_short_numbers(""), "");
  EXPECT_EQ(with_short_numbers("1/2, -0.25 and 0x1p-3"), "1/2, -0.25 and 0x1p-3");
  const std::string longest = "123456789012345678901234";
  EXPECT_EQ(with_short_numbers(longest), longest);
  EXPECT_EQ(with_short_numbers(longest + "5"), "1234567890...6789012345");
  EXPECT_EQ(with_short_numbers("at -" + longest + "5/" + longest + "7, 3"),
            "at -1234567890...6789012345/1234567890...6789012347, 3");
  EXPECT_LE(with_short_numbers(row_of(9000, '1', "-") + '/' + row_of(9000, '2')).size(), 48U);
}

// ---- Tables

std::string printed(const std::function<void()>& print) {
  std::fflush(stdout);
  ::testing::internal::CaptureStdout();
  print();
  std::fflush(stdout);
  return ::testing::internal::GetCapturedStdout();
}

TEST(Tables, ColumnsOfZerosAreLeftOut) {
  Table table("lrrr", {"name", "all", "none", "some"});
  table.row("one").cell(0).cell(0).cell(0);
  table.row("two").cell(0).cell(0).cell(1234);
  table.leave_out_zeros(2);
  EXPECT_EQ(printed([&] { table.print(); }),
            "  name  all   some\n"
            "  one     0      0\n"
            "  two     0  1,234\n");
}

TEST(Tables, WideOnesAreTwo) {
  const std::string wide(30, '1');
  for (const std::size_t length : {16U, 17U}) {
    const std::string name(length, 'n');
    Table table("lrr", {"name", "first", "second"});
    table.row(name).cell(wide).cell(std::string(28, '2'));
    const std::string text = printed([&] { table.print_in_parts(); });
    EXPECT_EQ(lines_of(text).size(), length == 16 ? 3U : 6U) << text;
    if (length == 16) continue;
    EXPECT_NE(text.find("\n  " + name + "  " + wide + "\n\n  name "), std::string::npos) << text;
  }
}

TEST(ReasonTally, CountsAndKeepsTheSmallestExample) {
  ReasonTally tally;
  tally.add("b", 5, 0);
  tally.add("a", 7, 1);
  tally.add("c", 2, 2);
  tally.add("c", 1, 3);
  tally.add("c", 1, 4);
  const std::vector<ReasonRow> rows = tally.rows();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].reason, "c");
  EXPECT_EQ(rows[0].count, 3U);
  EXPECT_EQ(rows[0].example, 3U);
  EXPECT_EQ(rows[1].reason, "a");
  EXPECT_EQ(rows[2].reason, "b");
  EXPECT_EQ(printed([&] {
              print_reasons(rows, "cases", [](const ReasonRow& row) { return "case " + std::to_string(row.example); });
            }),
            "  reason  cases  smallest example\n"
            "  c           3  case 3\n"
            "  a           1  case 1\n"
            "  b           1  case 0\n\n");
}

}  // namespace
}  // namespace flowcert::text_for_people_test
