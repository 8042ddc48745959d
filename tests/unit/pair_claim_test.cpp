// Claims of persistence pairs, as they are read from JSON and from text, and the order of pairs.
#include "certify/pair_claim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cites.h"

namespace flowcert::pair_claim_test {
namespace {

std::vector<ClaimedPair> read(const std::string& text) { return claimed_pairs_of(text, "pairs"); }

std::string error_in(const std::string& text) {
  try {
    (void)read(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "read without an error";
}

void expect_number(const ClaimedNumber& number, const Rational& value, bool is_exact) {
  EXPECT_EQ(number.value, value);
  EXPECT_EQ(number.is_exact, is_exact) << value;
}

TEST(PairClaim, TextIsInDecimalsAndFractions) {
  CITES("FC-CLAIM-05", "FC-CLAIM-11");
  const auto pairs = read("# of GUDHI\n0 0 inf\n\n1  2.25 5/2 # a comment\n2\t0x1p-1 4\r\n");
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0].dimension, 0);
  EXPECT_FALSE(pairs[0].death);
  EXPECT_EQ(pairs[1].dimension, 1);
  expect_number(pairs[1].birth, Rational(9) / 4, false);
  expect_number(*pairs[1].death, Rational(5) / 2, true);
  EXPECT_EQ(pairs[2].dimension, 2);
  expect_number(pairs[2].birth, Rational(1) / 2, true);
  expect_number(*pairs[2].death, 4, false);
}

TEST(PairClaim, ACharacteristicMayStandInFront) {
  CITES("FC-CLAIM-11");
  const auto pairs = read("2 0 0 inf\n11 1 0.5 1\n");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].dimension, 0);
  EXPECT_EQ(pairs[1].dimension, 1);
  expect_number(pairs[1].birth, Rational(1) / 2, false);
  for (const char* line : {"1 0 0 1", "0 0 0 1", "-2 0 0 1", "2.0 0 0 1", "two 0 0 1"}) {
    EXPECT_NE(error_in(line).find("pairs:1: no characteristic of a field"), std::string::npos) << line;
  }
}

TEST(PairClaim, JsonIsExact) {
  CITES("FC-NUM-02", "FC-CLAIM-11");
  const auto pairs = read(R"({"pairs": [
    {"dimension": 0, "birth": {"squared_distance": "0"}, "death": null},
    {"dimension": 1, "birth": {"squared_distance": "7"}, "death": {"squared_distance": "15/2"}}]})");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_FALSE(pairs[0].death);
  EXPECT_EQ(pairs[1].dimension, 1);
  expect_number(pairs[1].birth, 7, true);
  expect_number(*pairs[1].death, Rational(15) / 2, true);
}

TEST(PairClaim, NumbersAndLinesAreThoseOfClaims) {
  CITES("FC-FILE-47", "FC-CLAIM-11");
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto pairs = read("0 0 inf" + std::string(end) + "\v\f" + end + "1\v.5 +5.E-1" + end);
    ASSERT_EQ(pairs.size(), 2U);
    EXPECT_EQ(pairs[1].line, 3U);
    expect_number(pairs[1].birth, Rational(1) / 2, false);
    expect_number(*pairs[1].death, Rational(1) / 2, false);
  }
  for (const char* text : {"-0 0 1\n", "00 0 1\n", "+1 0 1\n"}) {
    EXPECT_NE(error_in(text).find("pairs:1: no dimension"), std::string::npos) << text;
  }
  EXPECT_NE(error_in("+2 0 0 1\n").find("pairs:1: no characteristic of a field"), std::string::npos);
  const auto json_with = [](const std::string& number) {
    return R"({"pairs": [{"dimension": 0, "birth": {"squared_distance": ")" + number + R"("}, "death": null}]})";
  };
  for (const auto& [text, value] : {std::pair("+07/02", Rational(7) / 2), std::pair("0x.8p+0", Rational(1) / 2)}) {
    expect_number(read(json_with(text)).at(0).birth, value, true);
  }
  for (const char* text : {"1.5", "1e2", "7/-2", "-7/-2", "7/0", "\u0667"}) {
    EXPECT_NE(error_in(json_with(text)).find("no rational"), std::string::npos) << text;
  }
  EXPECT_EQ(error_in("{\"pairs\": []}" + std::string("\0 more", 6)), "pairs: not JSON, in byte 14");
  EXPECT_EQ(error_in("\v{\"pairs\": []}"), "pairs: not JSON, in byte 1");
  EXPECT_EQ(
      read("{\"pairs\": [{\"dimension\": -0, \"birth\": {\"squared_distance\": \"0\"}, \"death\": null}]}").size(), 1U);
  // The word that tells a diagram stands on the first line, whatever ends it.
  const std::string head = R"({"format": "flowcert-stationary-points"})", other = R"({"x": "flowcert-persistence"})";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    EXPECT_FALSE(is_pair_claim(head + end + other, "a"));
    EXPECT_TRUE(is_pair_claim(other + end, "a"));
  }
}

TEST(PairClaim, WhatIsNoneIsRefused) {
  CITES("FC-IN-05", "FC-CLAIM-11");
  EXPECT_EQ(error_in(" \n"), "pairs: empty");
  for (const char* text : {"0 0\n", "0 0 1 2 3\n"}) {
    EXPECT_NE(error_in(text).find("pairs:1: not the words"), std::string::npos) << text;
  }
  for (const char* text : {"3 0 1\n", "-1 0 1\n", "0.0 0 1\n"}) {
    EXPECT_NE(error_in(text).find("pairs:1: no dimension"), std::string::npos) << text;
  }
  for (const char* text : {"0 0 infinity\n", "0 inf 1\n", "0 0 nan\n", "0 0 -inf\n"}) {
    EXPECT_NE(error_in(text), "read without an error") << text;
  }
  for (const char* pair : {R"({"dimension": 3, "birth": {"squared_distance": "0"}, "death": null})",
                           R"({"dimension": 0, "birth": {"squared_distance": 0}, "death": null})",
                           R"({"dimension": 0, "birth": {"squared_distance": "0"}})", R"({"dimension": 0})"}) {
    EXPECT_NE(error_in(std::string(R"({"pairs": [)") + pair + "]}"), "read without an error") << pair;
  }
}

// A program under test or an attacker may write it.
TEST(PairClaim, JsonThatIsNoneOrHasNoEndIsRefusedInOneLine) {
  CITES("FC-IN-05");
  for (const char* text : {"{nope", "{\"pairs\": [\"\xff\"]}"}) {
    EXPECT_TRUE(error_in(text).starts_with("pairs: not JSON, in byte ")) << error_in(text);
  }
  for (const std::size_t levels : {std::size_t{16}, std::size_t{100'000}}) {  // and the object's
    const std::string deep = std::string(levels, '[') + std::string(levels, ']');
    EXPECT_EQ(error_in("{\"x\": " + deep + ", \"pairs\": []}"), "pairs: nested deeper than 16 levels");
  }
  std::string keys = "{\"pairs\": []";
  for (int k = 0; k < 200'000; ++k) keys += ",\"k" + std::to_string(k) + "\":0";
  EXPECT_EQ(error_in(keys + "}"), "pairs: an object of more than 1000 keys");
}

TEST(PairClaim, PairsAreOrderedByDimensionBirthAndDeath) {
  CITES("FC-PERS-01");
  const std::vector<ListedPair> ordered = {{0, 0, Rational(1)}, {0, 0, Rational(2)}, {0, 0, std::nullopt},
                                           {0, 1, Rational(2)}, {1, 0, Rational(9)}, {1, 0, std::nullopt}};
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (std::size_t j = 0; j < ordered.size(); ++j) EXPECT_EQ(is_before(ordered[i], ordered[j]), i < j);
  }
}

}  // namespace
}  // namespace flowcert::pair_claim_test
