// `flowcert check` of pores, as a user calls it (src/cli/manual/check.md).
//
// Guarantees: what is right of the cage of tests/inputs was worked out by hand, as in pores_command_test.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::check_pores_test {
namespace {

using Words = std::vector<std::string>;

const std::string kCage = std::string(FLOWCERT_USER_INPUTS) + "/cage.xyz";
constexpr char kRight[] =
    "cavity 5.397020\nwindow 3.628998\nwindow 3.628998\nwindow 3.628998\nwindow 3.628998\nlimiting 3.628998\n";

Finished check(const std::string& claim, const Words& more = {}) {
  const Scratch scratch;
  Words words = {"check", kCage, scratch.file("claim.txt", claim), "--radii", "bondi"};
  words.insert(words.end(), more.begin(), more.end());
  return flowcert(words);
}

std::string refusal(const Words& words) {
  const Finished done = flowcert(words);
  EXPECT_EQ(done.status, 2) << done.out;
  EXPECT_EQ(done.out, "");
  return done.err;
}

TEST(CheckPores, TakesDiametersOfTheCage) {
  CITES("FC-CLAIM-26", "FC-CLAIM-22", "FC-FILE-58");
  const Finished part = check(kRight, {"--claim-format", "pores"});
  EXPECT_EQ(part.status, 0) << part.out;
  EXPECT_NE(part.out.find("\nconforms (approximate, tolerance 1e-06; truth by the fast implementation)\n"),
            std::string::npos)
      << part.out;
  const Finished whole = check(std::string(kRight) + "all\ndepth 0.5\n");
  EXPECT_EQ(whole.status, 0) << whole.out;
  EXPECT_NE(whole.out.find("\nconforms to 1.2, pores, approximate within 1e-06\n"), std::string::npos) << whole.out;
  EXPECT_EQ(check(kRight, {"--tolerance", "1e-9"}).status, 1);
  const Finished left_out = check("window 3.628998\n");
  EXPECT_EQ(left_out.status, 0);
  EXPECT_NE(left_out.out.find("\nnot claimed, which is not wrong: 3 of the kind window\n"), std::string::npos)
      << left_out.out;
}

TEST(CheckPores, SaysWhatIsWrongAndWhy) {
  CITES("FC-CLAIM-26");
  // pywindow's estimate, a radius, a distance between centres, and one window too many.
  const std::string claim =
      "cavity 5.40\nwindow 1.814499\nwindow 7.028998\n" + std::string(kRight).substr(16) + "window 3.628998\n";
  const Finished wrong = check(claim);
  EXPECT_EQ(wrong.status, 1);
  for (const char* text :
       {":1: rounding [FC-CLAIM-26]: claimed cavity 5.4; truth: the cavity is 5.397020177, 0.00298 less",
        ":2: radius [FC-CLAIM-26]: claimed window 1.814499; truth: it is half of the window",
        ":3: to-centres [FC-CLAIM-26]: claimed window 7.028998; truth: less by twice the radius 1.7",
        ":9: claimed-twice [FC-CLAIM-26]: claimed window 3.628998"}) {
    EXPECT_NE(unbroken(wrong.out).find(text), std::string::npos) << text << '\n' << wrong.out;
  }
  EXPECT_EQ(check("cavity 5.40\n", {"--tolerance", "1e-3"}).status, 0);
  const auto json = nlohmann::json::parse(check(claim, {"--json"}).out);
  EXPECT_EQ(json["claim_format"], "pores");
  EXPECT_EQ(json["verdict"], "fails");
  EXPECT_EQ(json["pores"][1],
            nlohmann::json(
                {{"kind", "window"}, {"claimed", 7}, {"true", 4}, {"wrong", 3}, {"missing", 0}, {"not_claimed", 0}}));
  ASSERT_EQ(json["findings"].size(), 4U);
  EXPECT_EQ(json["findings"][1]["kind"], "window");
  EXPECT_EQ(json["findings"][1]["reason"], "radius");
  EXPECT_EQ(json["findings"][1]["sentence"], "It is a radius. This is a convention.");
  const Scratch scratch;
  EXPECT_EQ(check(claim, {"--junit", scratch.path("junit.xml")}).status, 1);
  EXPECT_NE(content_of(scratch.path("junit.xml")).find("name=\"pores\""), std::string::npos);
}

TEST(CheckPores, JudgesWhatPoresWrites) {
  CITES("FC-CLAIM-26", "FC-FILE-56", "FC-FILE-58");
  const Scratch scratch;
  // Four balls of FC-BALL-07, and four whose chamber has no gate, since they overlap all around.
  const std::string balls = scratch.file("balls.xyz",
                                         "2 2 2 1\n2 -2 -2 1\n-2 2 -2 1\n-2 -2 2 1\n31 31 31 1.65\n31 29 29 1.65\n"
                                         "29 31 29 1.65\n29 29 31 1.65\n");
  const Words radii = {"--radii", "column:4"};
  const auto judged = [&](const std::string& text, const char* as) {
    return flowcert({"check", balls, scratch.file("claim.json", text), radii[0], radii[1], as});
  };
  for (const char* depth : {"0", "0.1", "1"}) {
    const std::string text = flowcert({"pores", balls, radii[0], radii[1], "--depth", depth, "--json"}).out;
    const Finished own = judged(text, "--strict");
    EXPECT_EQ(own.status, 0) << own.out;
    EXPECT_NE(own.out.find("\nconforms to 1.2, pores, exact\n"), std::string::npos) << own.out;
  }
  auto changed =
      nlohmann::ordered_json::parse(flowcert({"pores", balls, radii[0], radii[1], "--depth", "0.15", "--json"}).out);
  ASSERT_EQ(changed["chambers"].size(), 1U);
  ASSERT_EQ(changed["windows"].size(), 4U);
  changed["chambers"][0]["exit"]["polynomial"][2] = "-30";
  changed["windows"][3]["center"][0]["double"] = 13.0;
  changed["pore_limiting_diameter"] = 3.7;
  const auto json = nlohmann::json::parse(judged(changed.dump(), "--json").out);
  Words reasons;
  for (const auto& finding : json["findings"]) reasons.push_back(finding["reason"]);
  EXPECT_EQ(reasons, (Words{"wrong-diameter", "wrong-place", "wrong-diameter", "missing"})) << json;
}

TEST(CheckPores, RefusesWhatItCannotJudge) {
  CITES("FC-FILE-58");
  const Scratch scratch;
  const std::string claim = scratch.file("claim.txt", kRight), cut = scratch.file("cut.txt", "cavity 5.4\nwindow\n"),
                    complex = scratch.file("claim.csv", "0,0,0,0\n");
  EXPECT_NE(refusal({"check", kCage, claim}).find("--radii is needed"), std::string::npos);
  EXPECT_NE(refusal({"check", kCage, complex, "--radii", "bondi"}).find("--radii is for claims of pores"),
            std::string::npos);
  EXPECT_NE(refusal({"check", kCage, claim, "--radii", "bondi", "--oracle"}).find("judges no pores"),
            std::string::npos);
  EXPECT_NE(refusal({"check", kCage, claim, "--radii", "bondi", "--highest-level", "2"}).find("--highest-level"),
            std::string::npos);
  EXPECT_EQ(refusal({"check", kCage, cut, "--radii", "bondi"}).find("flowcert: " + cut + ":2: not a kind"), 0U);
}

}  // namespace
}  // namespace flowcert::conformance::check_pores_test
