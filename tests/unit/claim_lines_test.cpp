// The lines of claims, by the letter (FC-FILE-47): what ends one, what is blank, and what no line of JSON has.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/claim_file_samples.h"

namespace flowcert::claim_lines_test {
namespace {

const std::string kHeader = "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n";

std::string record_refusal(const std::string& record) { return claim_refusal(kHeader + record); }

std::string joined(const std::vector<std::string>& lines, const std::string& end) {
  std::string text;
  for (const std::string& line : lines) text += line + end;
  return text;
}

struct LinesOfAFormat {
  const char* name;
  std::vector<std::string> lines;  // two points, on the lines 2 and 4
};

const LinesOfAFormat kLinesOfFormats[] = {{"exchange",
                                           {kHeader.substr(0, kHeader.size() - 1), R"({"index":0,"contact":[1]})",
                                            " \t\v\f", R"({"index":0,"contact":[2]})"}},
                                          {"csv", {"index,x,y,z", "0,1,2,3", "\v \t\f", "0\v1\f2\t3"}},
                                          {"giesen-kuehne", {"inf 3", "7 | 0", " \t\v\f", "\f8\v|\t0 |"}}};

TEST(ClaimLines, EndInThreeWaysInEveryFormat) {
  CITES("FC-FILE-47", "FC-FILE-12");
  const std::string mark = "\xef\xbb\xbf";
  for (const auto& [name, lines] : kLinesOfFormats) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
      const std::string text = joined(lines, end);
      for (const std::string& whole : {text, text.substr(0, text.size() - std::string(end).size()), mark + text}) {
        const Claim claim = read_claim_from(whole, "a");
        EXPECT_EQ(claim.format, name);
        ASSERT_EQ(claim.points.size(), 2U) << name;
        EXPECT_EQ(claim.points[0].line, 2U) << name;
        EXPECT_EQ(claim.points[1].line, 4U) << name;
      }
      EXPECT_TRUE(claim_refusal(mark + mark + text).starts_with("a:1: ")) << name << ": two marks";
      EXPECT_TRUE(claim_refusal(text + mark + lines.back()).starts_with("a:5: ")) << name << ": a mark on a later line";
      EXPECT_TRUE(claim_refusal(text + lines.back() + std::string("\0", 1)).starts_with("a:5: ")) << name << ": NUL";
    }
  }
  for (const char* nothing : {"\n", "\r", " \t\v\f\r\n", "\xef\xbb\xbf", "\xef\xbb\xbf\r\n "}) {
    EXPECT_EQ(claim_refusal(nothing), "a: empty");
  }
}

// The parser takes NUL for the end, and does not look at what comes after it.
TEST(ClaimLines, JsonHasNoMarksAndNoNul) {
  CITES("FC-FILE-47", "FC-FILE-19");
  const std::string record = R"({"index":0,"contact":[1]})";
  EXPECT_EQ(record_refusal(record), "accepted, 1 points");
  EXPECT_EQ(record_refusal(record + std::string("\0", 1)), "a:2: not JSON, in column 26");
  EXPECT_EQ(record_refusal(record + std::string("\0 and more", 10)), "a:2: not JSON, in column 26");
  EXPECT_EQ(record_refusal("\xef\xbb\xbf" + record), "a:2: not JSON, in column 1");
  EXPECT_EQ(record_refusal("\v" + record), "a:2: not JSON, in column 1") << "a blank of other texts";
  EXPECT_EQ(record_refusal("{\"index\":-0,\"contact\":[-0]}"), "accepted, 1 points");
  EXPECT_EQ(record_refusal("{\"index\":00,\"contact\":[1]}"), "a:2: not JSON, in column 11");
  for (const char* number : {"+1", ".5", "5.", "1.e1", "0x1", "Infinity", "NaN", "1/2"}) {
    const std::string text = "{\"index\":0,\"center\":[0,0," + std::string(number) + "]}";
    EXPECT_TRUE(record_refusal(text).starts_with("a:2: not JSON, in column ")) << number;
    EXPECT_EQ(record_refusal("{\"index\":0,\"center\":[0,0,\"" + std::string(number) + "\"]}") == "accepted, 1 points",
              std::string("IN").find(number[0]) == std::string::npos)
        << number << " in a string";
  }
  EXPECT_TRUE(record_refusal(R"({"index":0,"contact":[1],"\ud83d":1})").starts_with("a:2: not JSON"));
  EXPECT_EQ(record_refusal(R"({"index":0,"contact":[1],"\ud83d\ude00":1})"), "accepted, 1 points");
  for (const char* string : {R"({"index":"0","contact":[1]})", R"({"index":0,"contact":["1"]})"}) {
    EXPECT_TRUE(record_refusal(string).starts_with("a:2: the value of ")) << string;
  }
}

TEST(ClaimLines, ANumberSignIsNoCommentAfterAPoint) {
  CITES("FC-FILE-47", "FC-FILE-15");
  EXPECT_EQ(claim_refusal("0,1,2,3# a comment\n0,1,2,3,,4 # 5\n"), "accepted, 2 points");
  EXPECT_EQ(claim_refusal("0,1,2,3.#\n"), "a:1: not a number: '3.#'");
  EXPECT_EQ(claim_refusal("0,1,2,1.#INF\n"), "a:1: not a number: '1.#INF'");
  EXPECT_EQ(claim_refusal("inf 3\n7 | 0 # none\n"), "a:2: more than one number between two bars: ' 0 # none'");
}

}  // namespace
}  // namespace flowcert::claim_lines_test
