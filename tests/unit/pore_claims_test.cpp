// Claims of pores, as they are read and judged. What is right of four balls was worked out by hand (FC-BALL-07).
#include "certify/pore_claims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cites.h"

namespace flowcert::pore_claims_test {
namespace {

// Twice 2 sqrt(3) - 1, and four times twice 4 sqrt(6) / 3 - 1.
const BallSet& four_balls() {
  static const BallSet balls({{{2, 2, 2}, 1}, {{2, -2, -2}, 1}, {{-2, 2, -2}, 1}, {{-2, -2, 2}, 1}});
  return balls;
}
const Pores& pores() {
  static const Pores found(four_balls(), Rational(1) / 10);
  return found;
}

PoreClaim read(const std::string& text) { return claimed_pores_of(text, "pores"); }

// Its reasons, in order.
std::vector<std::string> reasons(const std::string& text, double tolerance = kPoreTolerance) {
  std::vector<std::string> found;
  for (const PairDifference& each : judge_pores(read(text), pores(), tolerance, "pores").differences) {
    found.push_back(each.reason);
  }
  return found;
}
using Reasons = std::vector<std::string>;

std::string error_in(const std::string& text) {
  try {
    (void)judge_pores(read(text), pores(), kPoreTolerance, "pores");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "read without an error";
}

std::string truth_of(const std::string& text) {
  const auto judged = judge_pores(read(text), pores(), kPoreTolerance, "pores").differences;
  return judged.empty() ? "right" : judged[0].truth;
}

std::string json(const std::string& diameter, const std::string& more = "") {
  return R"({"pores": [{"kind": "cavity", "diameter": )" + diameter + more + "}]}";
}

TEST(PoreClaims, LinesHaveKindsDiametersAndPlaces) {
  CITES("FC-FILE-58", "FC-FILE-47");
  const PoreClaim claim = read(
      "# of mine\ndepth 1/2\nall\r\ncavity 5.40 # wide\nwindow 0x1p1 at 1 -2 .5 atoms 7 3 7\n"
      "gate none\nlimiting 3\nlimiting 3 atoms 0\n");
  EXPECT_EQ(claim.depth, Rational(1) / 2);
  EXPECT_TRUE(claim.is_whole);
  ASSERT_EQ(claim.pores.size(), 5U);
  EXPECT_EQ(claim.pores[0].line, 4U);
  EXPECT_EQ(claim.pores[0].diameter[0].value, QuadraticNumber(Rational(27) / 5));
  EXPECT_FALSE(claim.pores[0].diameter[0].is_exact);
  EXPECT_TRUE(claim.pores[1].diameter[0].is_exact);
  EXPECT_EQ(claim.pores[1].places[0].balls, (std::vector<PointId>{3, 7}));
  EXPECT_EQ((*claim.pores[1].places[0].position)[2][0].value, QuadraticNumber(Rational(1) / 2));
  EXPECT_TRUE(claim.pores[2].diameter.empty());
  EXPECT_TRUE(claim.pores[3].is_greatest);
  EXPECT_FALSE(claim.pores[4].is_greatest);
}

TEST(PoreClaims, WhatIsMalformedIsRefusedWithItsLine) {
  CITES("FC-FILE-58", "FC-FILE-18", "FC-FILE-19");
  for (const auto& [line, reason] : std::vector<std::pair<std::string, std::string>>{
           {"cavity", "not a kind (cavity, window, gate, limiting) and a diameter"},
           {"hole 3", "not a kind"},
           {"all of it", "not a kind"},
           {"cavity nan", "nan"},
           {"cavity none", "'none'"},
           {"cavity -1", "a negative distance: '-1'"},
           {"cavity 1e999999999", "an exponent too large"},
           {"cavity 1/0", "'1/0'"},
           {"cavity 3 4", "neither 'at X Y Z' nor 'atoms' with ids: '4'"},
           {"cavity 3 at 1 2", "neither 'at X Y Z' nor 'atoms' with ids: 'at'"},
           {"cavity 3 at 1 2 x", "'x'"},
           {"cavity 3 atoms", "neither 'at X Y Z' nor 'atoms' with ids: 'atoms'"},
           {"cavity 3 atoms -1", "not an id: '-1'"},
           {"cavity 3 atoms 4", "there is no ball 4; the input has 4"}}) {
    const std::string said = error_in("cavity 1\n" + line + "\n");
    EXPECT_TRUE(said.starts_with("pores:2: ") && said.find(reason) != std::string::npos) << line << ": " << said;
  }
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {json("NaN"), "pores:1: not JSON"},
           {json("1e999"), "pores:1: out of range of a double"},
           {json("\n-1"), "pores:1: the value of 'diameter' is not 0 or more"},
           {"\n" + json("null"), "pores:2: the value of 'diameter' is not a number"},
           {json("true"), "pores:1: the value of 'diameter' is not a rational in a string, or a number"},
           {json(R"({"polynomial": ["1", "0", "1"], "root": 1})"), "'polynomial' is not one that has real roots"},
           {json(R"({"polynomial": ["0", "1"], "root": 0})"), "'polynomial' is not two or three coefficients"},
           {json(R"({"polynomial": ["1", "-1"], "root": 1})"), "'root' is not 0 for degree 1"},
           {json("1", R"(, "contact": [])"), "'contact' is not a contact set"},
           {json("1", R"(, "contact": [9])"), "pores:1: there is no ball 9"},
           {json("1", R"(, "center": [0, 0])"), "'center' is not an array of 3"},
           {json("1", R"(, "diameter": 2)"), "pores:1: a key twice: 'diameter'"},
           {json(std::string(20, '[') + std::string(20, ']')), "pores:1: nested deeper than 16 levels"},
           {R"({"pores": [{"kind": "hole", "diameter": 1}]})",
            "'kind' is not 'cavity', 'window', 'gate' or 'limiting'"},
           {R"({"pores": [], "balls": 5})", "pores: a claim about 5 balls, and the input has 4"},
           {R"({"pores": [], "format": "flowcert-pockets"})", "'format' is not 'flowcert-pores'"},
           {R"({"chambers": [{"peak": {"value": 1, "points": []}}]})", "'peak' is not one with points"},
           {"{}", "pores:1: no key 'pores', and none of 'chambers' and 'windows'"},
           {" \n", "pores: empty"}}) {
    EXPECT_NE(error_in(text).find(reason), std::string::npos) << text << '\n' << error_in(text);
  }
}

TEST(PoreClaims, ExactNumbersHaveToBeEqual) {
  CITES("FC-CLAIM-26", "FC-CLAIM-05");
  // s^2 + 2 s - 11 for half of it.
  EXPECT_EQ(reasons(json(R"({"polynomial": ["1", "4", "-44"], "root": 1})"), 0), Reasons());
  EXPECT_EQ(reasons(json(R"({"polynomial": ["-2", "-8", "88"], "root": 1, "double": 4.928203230275509})"), 0),
            Reasons());
  EXPECT_EQ(error_in(json(R"({"polynomial": ["1", "4", "-44"], "root": -1})")),
            "pores:1: the value of 'diameter' is not 0 or more");
  EXPECT_EQ(reasons(json(R"({"polynomial": ["1", "4", "-44"], "root": 1, "double": 4.92821})")),
            Reasons{"wrong-diameter"});
  // The nearest double is right as a decimal, and wrong as a number.
  EXPECT_EQ(reasons("cavity 4.928203230275509\n", 0), Reasons());
  EXPECT_EQ(reasons("cavity 0x1.3b67ae8584caap+2\n"), Reasons{"rounding"});
  EXPECT_EQ(reasons("cavity 4.92820323\n"), Reasons());
  EXPECT_EQ(reasons("cavity 4.92820323\n", 0), Reasons{"rounding"});
}

TEST(PoreClaims, TheToleranceIsExact) {
  CITES("FC-CLAIM-26", "FC-CLAIM-23");
  // Twice the peak times 1 + 2^-20 is 4 (sqrt(3) - 1/2) (1 + 2^-20), 4.9282079301763559181790...: decimals on either
  // side of it.
  const std::string inside = "cavity 4.928207930176355918179", outside = "cavity 4.928207930176355918180";
  EXPECT_EQ(reasons(inside + "\n", 0x1p-20), Reasons());
  EXPECT_EQ(reasons(outside + "\n", 0x1p-20), Reasons{"wrong-diameter"});
}

TEST(PoreClaims, EachWindowIsClaimedOnce) {
  CITES("FC-CLAIM-26", "FC-CLAIM-24");
  const std::string window = "window 4.531973\n";
  EXPECT_EQ(reasons(window + window + window + window), Reasons());
  EXPECT_EQ(reasons(window + window + window + window + window), Reasons{"claimed-twice"});
  // The last ones leave the first ones no choice.
  EXPECT_EQ(reasons(window + window + "window 4.531973 atoms 0 1 2\nwindow 4.531973 atoms 0 3\n"), Reasons());
  EXPECT_EQ(reasons("window 4.531973 atoms 0 1 2\nwindow 4.531973 atoms 1 0 2\n"), Reasons{"claimed-twice"});
  EXPECT_EQ(reasons("cavity 4.928203\n" + window + "all\n"), (Reasons{"missing", "missing", "missing"}));
  const PoreJudgement part = judge_pores(read(window), pores(), kPoreTolerance, "pores");
  EXPECT_EQ(part.left_out, (std::array<std::size_t, 4>{1, 3, 0, 0}));
  EXPECT_EQ(part.truth, (std::array<std::size_t, 4>{1, 4, 1, 1}));
}

TEST(PoreClaims, ALimitingDiameterIsOfAllOrOfAChamber) {
  CITES("FC-CLAIM-26", "FC-BALL-10");
  EXPECT_EQ(reasons("limiting 4.531973\nlimiting 4.531973\nlimiting 4.531973 atoms 0 1 2 3\n"), Reasons());
  EXPECT_EQ(reasons("limiting none\nlimiting none atoms 1\nlimiting 4.5\nlimiting 4.6 atoms 0\n"),
            (Reasons{"wrong-diameter", "wrong-diameter", "rounding", "wrong-diameter"}));
  EXPECT_EQ(reasons("gate 4.531973 at 0 0 0\n"), Reasons());
  // No chamber is as deep as that.
  const Pores none(four_balls(), 1);
  EXPECT_TRUE(judge_pores(read("limiting none\nall\n"), none, kPoreTolerance, "pores").differences.empty());
  EXPECT_EQ(judge_pores(read("limiting 4.531973\n"), none, kPoreTolerance, "pores").differences.size(), 1U);
}

TEST(PoreClaims, WhatIsWrongSaysWhy) {
  CITES("FC-CLAIM-26");
  EXPECT_EQ(truth_of("cavity 4.9285\n"), "the cavity is 4.92820323, 0.000297 less");
  EXPECT_EQ(truth_of("cavity 2.4641016\n"), "it is half of the cavity 4.92820323 with atoms 0 1 2 3");
  EXPECT_EQ(truth_of("window 6.531973\n"), "less by twice the radius 1 it is the window 4.531972647 with atoms 0 1 2");
  EXPECT_EQ(
      truth_of("window 4.928203\n"),
      "it is that of a critical point of index 3 with atoms 0 1 2 3, the peak of chamber 0; the nearest window is "
      "4.531972647, 0.396 less");
  EXPECT_EQ(truth_of("window 3.656854\n").substr(0, 67),
            "it is that of a critical point of index 1 with atoms 0 1, inside of");
  EXPECT_EQ(truth_of("window 4.6 atoms 0 2 3\n"), "the window is 4.531972647, 0.068 less");
  EXPECT_EQ(truth_of("window 3.7 atoms 1 0\n"), "the nearest window is 4.531972647, 0.832 more");
  EXPECT_EQ(truth_of("window 4.6 atoms 0 1 2 3\n"),
            "a critical point of index 3 with atoms 0 1 2 3, the peak of chamber 0, diameter 4.92820323");
  EXPECT_EQ(truth_of("cavity 4.9282 at 0 0 .5\n"),
            "a ball of diameter 4.403124237 has room there; 0.5 away is the cavity 4.92820323 with atoms 0 1 2 3");
  EXPECT_EQ(truth_of("cavity 4.928203 at 0 0 0.000004\n"), "right");
}

}  // namespace
}  // namespace flowcert::pore_claims_test
