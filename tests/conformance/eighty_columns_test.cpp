// What people read is within 80 columns: the help of every command, and what each prints of inputs that make it wide:
// large counts, contact sets of hundreds of points, exact numbers of hundreds of digits, a long path.
//
// Guarantees: commands and options are taken from the help itself, so a new command is looked at, too. Long numbers are
// shortened in text and whole in --json.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "tests/conformance/help_text.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::eighty_columns_test {
namespace {

using Words = std::vector<std::string>;

std::size_t columns_in(const std::string& line) {
  return static_cast<std::size_t>(std::ranges::count_if(line, [](char c) { return (c & 0xc0) != 0x80; }));
}

// Runs it, and looks at each line of standard output.
std::string narrow_output(const Words& words) {
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.err, "") << words[0];
  EXPECT_LT(finished.status, 2) << words[0];
  EXPECT_NE(finished.out, "") << words[0];
  for (const std::string& line : lines_of(finished.out)) {
    EXPECT_LE(columns_in(line), 80U) << ::testing::PrintToString(words) << '\n' << line;
  }
  return finished.out;
}

TEST(EightyColumns, HelpOfEveryCommand) {
  const Words commands = commands_in(narrow_output({"--help"}));
  EXPECT_GE(commands.size(), 13U);
  for (const std::string& command : commands) {
    const std::string help = narrow_output({command, "--help"});
    EXPECT_NE(help.find("Example"), std::string::npos) << command;
  }
  EXPECT_EQ(commands_in(narrow_output({"fuzz", "--help"})), Words{"merge"});
  narrow_output({"fuzz", "merge", "--help"});
}

// An example of a help can be copied: a line that goes on ends with a backslash.
TEST(EightyColumns, ExamplesOfHelpAreWhole) {
  for (const std::string& command : commands_in(flowcert({"--help"}).out)) {
    bool is_below = false;
    std::string before;
    for (const std::string& line : lines_of(flowcert({command, "--help"}).out)) {
      if (is_below && !line.empty()) {
        const bool goes_on = line.starts_with("    ");
        EXPECT_EQ(before.ends_with(" \\"), goes_on) << command << ": " << line;
        EXPECT_EQ(line.starts_with("  flowcert "), !goes_on) << command << ": " << line;
      }
      is_below = line.ends_with("xamples:") || (is_below && !line.empty());
      before = line;
    }
  }
}

std::string random_rows(int count) {
  std::mt19937 random(7);
  std::ostringstream rows;
  for (int k = 0; k < count; ++k) rows << random() << ' ' << random() << ' ' << random() << '\n';
  return rows.str();
}

// 150 points of the sphere of squared radius 1189 in the lattice.
std::string sphere_rows() {
  std::ostringstream rows;
  int count = 0;
  for (int x = -34; x <= 34; ++x) {
    for (int y = -34; y <= 34; ++y) {
      for (int z = -34; z <= 34; ++z) {
        if (x * x + y * y + z * z == 1189 && count++ < 150) rows << x << ' ' << y << ' ' << z << '\n';
      }
    }
  }
  return rows.str();
}

constexpr char kLongNumbers[] =
    "1e150 1e-300 0.1\n-3e149 0.3 7e100\n1e-12 5e149 -1e120\n0.7 0.9 0.11\n3e149 3e149 3e149\n";

TEST(EightyColumns, WhatCommandsPrint) {
  const Scratch scratch;
  const std::pair<std::string, std::string> inputs[] = {
      {"random.xyz", random_rows(3000)},
      {"sphere.xyz", sphere_rows()},
      {"long.xyz", kLongNumbers},
      {std::string(120, 'a') + ".xyz", "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n"}};
  for (const auto& [name, rows] : inputs) {
    const std::string input = scratch.file(name, rows);
    narrow_output({"compute", input});
    narrow_output({"compute", input, "--manifolds", "u2,s2", "--stats"});
    narrow_output({"stats", input});
    narrow_output({"persistence", input, "-o", scratch.path("out.pers")});
    for (const char* dimension : {"0", "1", "2"}) narrow_output({"cycles", input, "--dimension", dimension});
    narrow_output({"cycles", input, "--witness"});
    narrow_output({"surface", input, "-o", scratch.path("out.ply")});
    narrow_output({"explain", input, "--ids", "0,1,2,3"});
    narrow_output({"explain", input, "--at", "0,0,0"});
    narrow_output({"explain", input, "--at", "1e300,1/1" + std::string(90, '3') + ",-7e299"});
    narrow_output({"orbit", input, "--from", "0.123456789,-0.987654321,0.5"});
    narrow_output({"orbit", input, "--from", "0,0,0"});
    narrow_output({"orbit", input, "--from", "1e299,-1234567.125,1/3"});
  }
  const std::pair<std::string, std::string> balls[] = {{"few.xyz", random_rows(300)}, {"long.xyz", kLongNumbers}};
  for (const auto& [name, rows] : balls) {
    narrow_output({"pores", scratch.file(name, rows), "--radii", "1/4", "--depth", "0", "--probe", "1", "--curve",
                   scratch.path("curve.svg")});
  }
  narrow_output({"fuzz", "--families", "list"});
  narrow_output({"conformance", "--list"});
  narrow_output({"generate", "--level", "2", "--seed", "123456789012345678", "--cases", "100"});
}

// A path, and a command that can be copied, are whole.
void expect_narrow(const std::string& out) {
  EXPECT_NE(out, "");
  for (const std::string& line : lines_of(out)) {
    const bool is_to_be_copied = line.find("flowcert ") != std::string::npos || line.starts_with("    /");
    EXPECT_TRUE(is_to_be_copied || columns_in(line) <= 80) << line;
  }
}

TEST(EightyColumns, WhatIsSaidOfWrongClaims) {
  const Scratch scratch;
  const std::string input = scratch.file("sphere.xyz", sphere_rows());
  const std::string claim = scratch.path("claim.jsonl");
  EXPECT_EQ(flowcert({"compute", input, "--manifolds", "u2,s2", "--polylines", "-o", claim}).status, 0);
  expect_narrow(flowcert({"check", input, claim}).out);
  const std::string wrong = scratch.file("wrong.csv", "index,x,y,z\n2,0.123456789012345678901,1e-200,1/3\n");
  expect_narrow(flowcert({"check", input, wrong}).out);
  const std::string peer = std::string(FLOWCERT_PEER) + " {in} {out}";
  expect_narrow(flowcert({"conformance", "--against", peer, "--group", "rounding", "--group", "invalid-input"}).out);
  expect_narrow(flowcert({"fuzz", "--against", peer, "--count", "40", "--out", scratch.path("campaign")}).out);
  const std::string cases = scratch.path("cases"), answers = scratch.path("answers");
  const std::string pipe = std::string(FLOWCERT_PROGRAM) + " generate --cases 80 >" + cases + " && " + FLOWCERT_MIDDLE +
                           " rounded drop 3 unreadable 5 refuse 7 skip 9 skip 20 <" + cases + " >" + answers;
  EXPECT_EQ(RunningProgram({"/bin/sh", "-c", pipe}).finish().status, 0);
  expect_narrow(RunningProgram({"/bin/sh", "-c", std::string(FLOWCERT_PROGRAM) + " verify <" + answers}).finish().out);
}

TEST(EightyColumns, LongNumbersAreShortenedInTextAlone) {
  const Scratch scratch;
  const std::string input = scratch.file("long.xyz", kLongNumbers);
  const std::string text = narrow_output({"explain", input, "--ids", "0,1,2"});
  EXPECT_TRUE(std::regex_search(text, std::regex("[0-9]{10}\\.\\.\\.[0-9]{10}"))) << text;
  EXPECT_FALSE(std::regex_search(text, std::regex("[0-9]{25}"))) << text;
  const auto json = nlohmann::json::parse(flowcert({"explain", input, "--ids", "0,1,2", "--json"}).out);
  const auto squared_radius = json.at("squared_radius").get<std::string>();
  EXPECT_GT(squared_radius.size(), 300U);
  EXPECT_EQ(squared_radius.find("..."), std::string::npos);
}

}  // namespace
}  // namespace flowcert::conformance::eighty_columns_test
