// `flowcert pores` as a user calls it: the JSON of spec/formats/pores.md, the tables of src/cli/manual/pores.md, and
// what it refuses.
//
// Guarantees: the values of the cage of tests/inputs are roots that were worked out by hand from its coordinates: its
// atoms are placed symmetrically, with three decimals. So are those of small sets.
#include <expat.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::pores_command_test {
namespace {

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

const std::string kCage = std::string(FLOWCERT_USER_INPUTS) + "/cage.xyz";
// Four balls of radius 1, of FC-BALL-07.
constexpr char kFourBalls[] = "2 2 2 1\n2 -2 -2 1\n-2 2 -2 1\n-2 -2 2 1\n";

Finished pores(const std::string& file, const Words& options) {
  Words words = {"pores", file};
  words.insert(words.end(), options.begin(), options.end());
  return flowcert(words);
}

ordered_json json_of(const std::string& file, Words options) {
  options.emplace_back("--json");
  const Finished done = pores(file, options);
  EXPECT_EQ(done.status, 0) << done.err;
  return ordered_json::parse(done.out);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Expat reads XML that is well formed, and nothing else.
bool is_xml(const std::string& text) {
  XML_Parser parser = XML_ParserCreate(nullptr);
  const bool is_right = XML_Parse(parser, text.data(), static_cast<int>(text.size()), XML_TRUE) == XML_STATUS_OK;
  XML_ParserFree(parser);
  return is_right;
}

// ---- The cage ----

TEST(PoresCommand, PrintsDiametersOfTheCage) {
  CITES("FC-BALL-05", "FC-BALL-09", "FC-BALL-10", "FC-FILE-55");
  const Finished done = pores(kCage, {"--radii", "bondi", "--depth", "0.5", "--probe", "2"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("\nballs                                        168\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\nchambers                                       1"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\nclosed chambers                                1"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\nlargest cavity diameter                 5.397020"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\npore limiting diameter                  3.628998"), std::string::npos) << done.out;
  EXPECT_EQ(count_of(done.out, "  3.628998  outside  "), 4U) << done.out;
  EXPECT_NE(done.out.find("  closed\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("0  peak          12.400  12.400  12.400  1 C, 15 C, 29 C,"), std::string::npos) << done.out;
  for (const std::string& line : lines_of(done.out)) EXPECT_LE(line.size(), 80U) << line;
}

TEST(PoresCommand, WritesValuesOfTheCageExactly) {
  CITES("FC-BALL-08", "FC-BALL-10", "FC-FILE-56");
  const ordered_json json = json_of(kCage, {"--radii", "bondi", "--depth", "0.5", "--probe", "9/5"});
  EXPECT_EQ(json["format"], "flowcert-pores");
  EXPECT_EQ(json["format_version"], 1);
  EXPECT_EQ(json["radii"], "bondi");
  EXPECT_EQ(json["balls"], 168);
  EXPECT_EQ(json["hidden"], ordered_json::array());
  EXPECT_EQ(json["depth"], "1/2");
  EXPECT_EQ(json["probe"], "9/5");
  EXPECT_EQ(json["cavities_at_probe"], 0);
  ASSERT_EQ(json["chambers"].size(), 1U);
  const ordered_json& chamber = json["chambers"][0];
  EXPECT_EQ(chamber["is"], "open");
  EXPECT_EQ(chamber["handles"], ordered_json::array());
  // (s + 17/10)^2 is 19346891/1000000 at the peak.
  const ordered_json& peak = chamber["peak"];
  EXPECT_EQ(peak["value"]["polynomial"], (ordered_json{"1000000", "3400000", "-16456891"}));
  EXPECT_EQ(peak["value"]["root"], 1);
  EXPECT_NEAR(peak["value"]["double"].get<double>(), std::sqrt(19.346891) - 1.7, 1e-14);
  ASSERT_EQ(peak["points"].size(), 1U);
  EXPECT_EQ(peak["points"][0]["contact"], (ordered_json{1, 15, 29, 43, 57, 71, 85, 99, 113, 127, 141, 155}));
  EXPECT_EQ(peak["points"][0]["names"], ordered_json(Words(12, "C")));
  for (const ordered_json& coordinate : peak["points"][0]["center"]) {
    EXPECT_EQ(coordinate, ordered_json::parse(R"({"polynomial": ["5", "-62"], "root": 0, "double": 12.4})"));
  }
  // And 1543963/125000 at the gate.
  const ordered_json& gate = chamber["gate"];
  EXPECT_EQ(gate["value"]["polynomial"], (ordered_json{"125000", "425000", "-1182713"}));
  EXPECT_EQ(gate["value"]["root"], 1);
  EXPECT_NEAR(2 * gate["value"]["double"].get<double>(), 2 * (std::sqrt(1543963.0 / 125000) - 17.0 / 10), 1e-14);
  EXPECT_EQ(gate["points"].size(), 4U);
  EXPECT_EQ(chamber["exit"], gate["value"]);
  EXPECT_EQ(chamber["diameter"], 2 * peak["value"]["double"].get<double>());
  EXPECT_EQ(chamber["limiting_diameter"], 2 * gate["value"]["double"].get<double>());
  EXPECT_EQ(json["largest_cavity_diameter"], chamber["diameter"]);
  EXPECT_EQ(json["pore_limiting_diameter"], chamber["limiting_diameter"]);
  EXPECT_NEAR(json["largest_cavity_diameter"].get<double>(), 5.397020, 5e-7);
  EXPECT_EQ(json["cavities"], ordered_json::array({ordered_json::array({gate["value"], peak["value"]})}));
}

TEST(PoresCommand, FindsFourEqualWindowsOfTheCage) {
  CITES("FC-BALL-08", "FC-BALL-09", "FC-BALL-10", "FC-FILE-56");
  const ordered_json json = json_of(kCage, {"--radii", "bondi", "--depth", "0.5"});
  EXPECT_TRUE(json["probe"].is_null());
  EXPECT_FALSE(json.contains("cavities_at_probe"));
  EXPECT_FALSE(json["chambers"][0].contains("is"));
  EXPECT_EQ(json["chambers"][0]["windows"], (ordered_json{0, 1, 2, 3}));
  EXPECT_EQ(json["vestibules"], ordered_json::array());
  ASSERT_EQ(json["windows"].size(), 4U);
  for (const ordered_json& window : json["windows"]) {
    EXPECT_EQ(window["value"], json["chambers"][0]["gate"]["value"]);
    EXPECT_NEAR(window["diameter"].get<double>(), 3.628998, 5e-7);
    EXPECT_EQ(window["contact"].size(), 3U);
    EXPECT_EQ(window["names"], (ordered_json{"C", "C", "C"}));
    EXPECT_EQ(window["rooms"], (ordered_json{0, -1}));
  }
  EXPECT_EQ(json["windows"][0]["contact"], (ordered_json{1, 57, 113}));
}

TEST(PoresCommand, TakesOtherRadii) {
  CITES("FC-FILE-55", "FC-BALL-05");
  const auto peak = [](const Words& options) {
    return json_of(kCage, options)["chambers"].at(0)["diameter"].get<double>() / 2;
  };
  EXPECT_NEAR(peak({"--radii", "bondi,C=1.5"}), std::sqrt(19.346891) - 1.5, 1e-14);
  EXPECT_NEAR(peak({"--radii", "alvarez"}), std::sqrt(19.346891) - 1.77, 1e-14);
  const Scratch scratch;
  const std::string table = scratch.file("radii.txt", "# of my own\nH 1.1\nC 1.6\nN 1.55\nO 1.5\n");
  EXPECT_NEAR(peak({"--radii", "table:" + table}), std::sqrt(19.346891) - 1.6, 1e-14);
}

// ---- Small sets ----

TEST(PoresCommand, WritesTables) {
  CITES("FC-BALL-05", "FC-BALL-06", "FC-BALL-07", "FC-BALL-08", "FC-FILE-55");
  const Scratch scratch;
  const std::string file = scratch.file("four.csv", kFourBalls), rows = scratch.path("rows.csv"),
                    windows = scratch.path("windows.csv"), curve = scratch.path("curve.csv");
  const Words options = {"--radii", "column:4", "--probe", "2.3"};
  Words words = options;
  words.insert(words.end(), {"--csv", rows, "--windows-csv", windows, "--curve", curve});
  const Finished done = pores(file, words);
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("the number of cavities"), std::string::npos) << done.out;
  EXPECT_EQ(content_of(rows),
            "chamber,x,y,z,peak,gate,depth,exit,diameter,limiting_diameter,windows,handles,peaks,is,peak_atoms,"
            "gate_atoms\n"
            "0,0,0,0,2.4641016151377544,2.265986323710904,0.19811529142685044,2.265986323710904,4.928203230275509,"
            "4.531972647421808,4,0,1,closed,0;1;2;3,0;1;2;3\n");
  const Words lines = lines_of(content_of(windows));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "chamber,window,x,y,z,value,diameter,rooms,atoms");
  EXPECT_EQ(lines[1],
            "0,0,0.6666666666666666,0.6666666666666666,-0.6666666666666666,2.265986323710904,4.531972647421808,0;-1,"
            "0;1;2");
  EXPECT_EQ(content_of(curve), "up_to,cavities\n2.4641016151377544,1\n2.265986323710904,0\n");
  for (const auto& [option, path] : {std::pair("--csv", rows), std::pair("--windows-csv", windows)}) {
    Words to_output = options;
    to_output.insert(to_output.end(), {option, "-"});
    EXPECT_EQ(pores(file, to_output).out, content_of(path));
  }
}

TEST(PoresCommand, NamesAtomsAndResidues) {
  CITES("FC-BALL-05", "FC-FILE-55", "FC-FILE-56");
  const Scratch scratch;
  std::string text;
  for (int k = 0; k < 4; ++k) {
    text += fmt::format("ATOM  {:>5}  CA  GLY A{:>4}    {:>8.3f}{:>8.3f}{:>8.3f}  1.00  0.00           C\n", k + 1,
                        7 + k / 2, k < 2 ? 2.0 : -2.0, k % 2 == 0 ? 2.0 : -2.0, k % 3 == 0 ? 2.0 : -2.0);
  }
  const std::string file = scratch.file("four.pdb", text);
  const Finished done = pores(file, {"--radii", "bondi,C=1", "--csv", "-"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find(",0;1;2;3,A GLY 7 CA; A GLY 7 CA; A GLY 8 CA; A GLY 8 CA,"), std::string::npos) << done.out;
  EXPECT_NE(pores(file, {"--radii", "bondi,C=1"}).out.find("  0 A GLY 7 CA,"), std::string::npos);
  const ordered_json json = json_of(file, {"--radii", "bondi,C=1"});
  EXPECT_EQ(json["chambers"][0]["peak"]["points"][0]["names"],
            (ordered_json{"A GLY 7 CA", "A GLY 7 CA", "A GLY 8 CA", "A GLY 8 CA"}));
  EXPECT_EQ(json["chambers"][0]["peak"]["value"]["polynomial"], (ordered_json{"1", "2", "-11"}));
}

TEST(PoresCommand, SaysThatThereIsNoChamber) {
  CITES("FC-BALL-05");
  const Scratch scratch;
  const std::string four = scratch.file("four.csv", kFourBalls), two = scratch.file("two.csv", "0 0 0\n4 0 0\n");
  const Finished too_deep = pores(four, {"--radii", "column:4", "--depth", "1/5"}), none = pores(two, {"--radii", "1"});
  EXPECT_EQ(too_deep.status, 0);
  EXPECT_NE(too_deep.out.find("no chamber is as deep as 0.2; --depth 0 tells all"), std::string::npos) << too_deep.out;
  EXPECT_EQ(none.status, 0);
  EXPECT_NE(none.out.find("no chamber: from wherever a probe fits, it can get out"), std::string::npos) << none.out;
  const ordered_json json = json_of(two, {"--radii", "1"});
  EXPECT_EQ(json["chambers"], ordered_json::array());
  EXPECT_TRUE(json["largest_cavity_diameter"].is_null());
  EXPECT_TRUE(json["pore_limiting_diameter"].is_null());
}

TEST(PoresCommand, SaysThatAGateIsBelowZero) {
  CITES("FC-BALL-05", "FC-BALL-06", "FC-BALL-07", "FC-FILE-56");
  // An octahedron of balls that overlap all around, and leave a tenth in the middle. The last one is hidden.
  const Scratch scratch;
  const std::string file =
      scratch.file("six.csv", "1 0 0 0.9\n-1 0 0 0.9\n0 1 0 0.9\n0 -1 0 0.9\n0 0 1 0.9\n0 0 -1 0.9\n1 0 0 0.5\n");
  const Finished done = pores(file, {"--radii", "column:4", "--probe", "0", "--depth", "0"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("hidden balls                                   1"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("  0.100000   < 0  0.100000   < 0        0  closed"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\nno window\n"), std::string::npos) << done.out;
  const ordered_json json = json_of(file, {"--radii", "column:4"});
  EXPECT_EQ(json["hidden"], ordered_json{6});
  ASSERT_EQ(json["chambers"].size(), 1U);
  EXPECT_EQ(json["chambers"][0]["depth"], 0.1);
  EXPECT_TRUE(json["chambers"][0]["gate"].is_null());
  EXPECT_TRUE(json["chambers"][0]["exit"].is_null());
  EXPECT_TRUE(json["chambers"][0]["limiting_diameter"].is_null());
  EXPECT_EQ(json["chambers"][0]["peak"]["value"]["polynomial"], (ordered_json{"10", "-1"}));
  EXPECT_EQ(json["chambers"][0]["peak"]["value"]["root"], 0);
  EXPECT_TRUE(json["cavities"][0][0].is_null());
}

TEST(PoresCommand, DrawsTheCurve) {
  CITES("FC-BALL-07");
  const Scratch scratch;
  const std::string picture = scratch.path("curve.svg"), name = "a<b&\"c\".xyz";
  const std::string file = scratch.file(name, content_of(kCage));
  const Finished done = pores(file, {"--radii", "bondi", "--curve", picture});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("\n  2.698510         1\n  1.814499         0\n"), std::string::npos) << done.out;
  const std::string svg = content_of(picture);
  EXPECT_TRUE(is_xml(svg)) << svg;
  EXPECT_FALSE(is_xml(svg.substr(0, svg.size() / 2)));
  EXPECT_NE(svg.find("<path d=\"M"), std::string::npos) << svg;
  EXPECT_NE(svg.find("radii bondi"), std::string::npos) << svg;
}

TEST(PoresCommand, DoesNotDependOnThreads) {
  CITES("FC-BALL-09");
  const Words one = {"--radii", "bondi", "--depth", "0", "--json", "--threads", "1"};
  Words several = one;
  several.back() = "3";
  EXPECT_EQ(pores(kCage, one).out, pores(kCage, several).out);
}

// ---- What it refuses ----

TEST(PoresCommand, RefusesWhatItCannotUse) {
  CITES("FC-BALL-01", "FC-FILE-55");
  const Scratch scratch;
  const auto refuses = [](const std::string& file, const Words& options, const Words& reasons) {
    const Finished done = pores(file, options);
    EXPECT_EQ(done.status, 2) << done.out;
    EXPECT_TRUE(done.out.empty()) << done.out;
    for (const std::string& reason : reasons) EXPECT_NE(done.err.find(reason), std::string::npos) << done.err;
  };
  refuses(kCage, {}, {"--radii"});
  refuses(kCage, {"--radii", "bondy"},
          {"--radii:1: bondi, alvarez, pqr, column:N, table:FILE or one radius", "'bondy'"});
  refuses(kCage, {"--radii", "0"}, {"a radius is above 0"});
  refuses(kCage, {"--radii", "bondi", "--depth", "-1/2"}, {"--depth: not 0 or more: -1/2"});
  refuses(kCage, {"--radii", "bondi", "--depth", "deep"}, {"--depth"});
  refuses(kCage, {"--radii", "bondi", "--probe", "-1"}, {"--probe: not 0 or more: -1"});
  const std::string only_one = "only one of --csv, --windows-csv and --json can write to standard output";
  refuses(kCage, {"--radii", "bondi", "--json", "--csv", "-"}, {only_one});
  refuses(kCage, {"--radii", "bondi", "--windows-csv", "-", "--csv", "-"}, {only_one});
  refuses(kCage, {"--radii", "bondi", "--csv", ""}, {"the path is empty"});
  const std::string iron = scratch.file("iron.xyz", "3\nwith iron\nC 0 0 0\nFe 2.5 0 0\nO 0 2.5 0\n");
  refuses(iron, {"--radii", "bondi"}, {iron + ":4: ", "atom 1 (Fe)", "'bondi' has no radius of Fe", "bondi,Fe=R"});
  EXPECT_EQ(pores(iron, {"--radii", "bondi,Fe=2.04"}).status, 0);
  const std::string crystal =
      scratch.file("crystal.xyz", "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3\nC 0 0 0\n");
  refuses(crystal, {"--radii", "bondi"}, {"--finite"});
  EXPECT_EQ(pores(crystal, {"--radii", "bondi", "--finite"}).status, 0);
}

// The block after <!-- example: pores --> is a command line after a dollar, and all that it prints.
TEST(PoresCommand, TheReadmesExampleIsRight) {
  CITES("FC-BALL-10");
  const Words lines = lines_of(content_of(FLOWCERT_CLI_README));
  auto line = std::find(lines.begin(), lines.end(), "<!-- example: pores -->");
  ASSERT_GT(lines.end() - line, 3);
  line += 2;  // the mark, the fence
  ASSERT_TRUE(line->starts_with("$ ")) << *line;
  std::string command = line->substr(2);
  const std::pair<std::string, std::string> names[] = {{"build/flowcert", "\"$0\""}, {"tests/inputs", "\"$1\""}};
  for (const auto& [name, meant] : names) {
    ASSERT_NE(command.find(name), std::string::npos) << command;
    command.replace(command.find(name), name.size(), meant);
  }
  std::string expected;
  while (++line != lines.end() && *line != "```") expected += *line + "\n";
  EXPECT_EQ(RunningProgram({"/bin/sh", "-c", command, FLOWCERT_PROGRAM, FLOWCERT_USER_INPUTS}).finish().out, expected);
}

}  // namespace
}  // namespace flowcert::conformance::pores_command_test
