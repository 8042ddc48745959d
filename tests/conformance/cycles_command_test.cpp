// `flowcert cycles` as a user calls it: the JSON of spec/formats/cycles.md, the table and the levels of
// src/cli/manual/cycles.md, files, and what it refuses.
//
// Guarantees: what is expected of a square, a tetrahedron and an octahedron was worked out by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"
#include "tests/json_schema.h"

namespace flowcert::conformance::cycles_command_test {
namespace {

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr char kSquare[] = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n";
constexpr char kTetrahedron[] = "3 3 3\n3 -3 -3\n-3 3 -3\n-3 -3 3\n";
constexpr char kOctahedron[] = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n";
// The pair of birth 3/4 and death 9/8 has at the level 1 a loop of a class born at 1 (FC-CYC-03).
constexpr char kCarried[] = "0 1 1\n1 0 2\n1 2 0\n1 2 2\n2 0 2\n2 1 1\n";

Finished cycles(const std::string& points, Words options) {
  const Scratch scratch;
  Words words = {"cycles", scratch.file("points.xyz", points)};
  words.insert(words.end(), options.begin(), options.end());
  return flowcert(words);
}

ordered_json json_of(const std::string& points, Words options = {}) {
  static const flowcert_tests::JsonSchema schema(FLOWCERT_CYCLES_SCHEMA);
  options.emplace_back("--json");
  const Finished done = cycles(points, options);
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(schema.violations(nlohmann::json::parse(done.out)), "");
  return ordered_json::parse(done.out);
}

std::string refusal(const Words& options) {
  const Finished done = cycles(kSquare, options);
  EXPECT_EQ(done.status, 2) << done.out;
  EXPECT_EQ(done.out, "");
  return done.err;
}

TEST(CyclesCommand, TellsAllOfASquare) {
  CITES("FC-CYC-04", "FC-CYC-05", "FC-CYC-08", "FC-FILE-52");
  const ordered_json json = json_of(kSquare, {"--witness"});
  EXPECT_EQ(json["dimension"], 1);
  EXPECT_EQ(json["pairs"], 1);
  ASSERT_EQ(json["cycles"].size(), 1U);
  const ordered_json& cycle = json["cycles"][0];
  EXPECT_EQ(cycle["birth"]["contact"], (ordered_json{2, 3}));
  EXPECT_EQ(cycle["death"]["contact"], (ordered_json{0, 1, 2, 3}));
  EXPECT_EQ(cycle["squared_level"], "5/4");
  EXPECT_EQ(cycle["edges"], (ordered_json{{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
  EXPECT_EQ(cycle["polygons"].dump(), "[[0,1,2,3]]");
  EXPECT_EQ(cycle["surface"].dump(), "[[0,1,2,3]]");
  EXPECT_EQ(cycle["loop_length"], 8.0);
  EXPECT_EQ(cycle["witness"]["loop"], cycle["edges"]);
  EXPECT_EQ(cycle["witness"]["surface"], cycle["surface"]);
  EXPECT_EQ(cycle["witness"]["cocycle"].dump(), "[[2,3]]");
  EXPECT_EQ(cycle["witness"]["met"].dump(), "[]");
}

TEST(CyclesCommand, TellsALevelAndNotABirth) {
  CITES("FC-CYC-02", "FC-CYC-03", "FC-CYC-04");
  const ordered_json all = json_of(kCarried, {"--persistence", "0"});
  for (const ordered_json& cycle : all["cycles"]) {
    EXPECT_NE(cycle["birth"]["squared_distance"], cycle["death"]["squared_distance"]);
  }
  const auto is_meant = [](const ordered_json& cycle) {
    return cycle["birth"]["squared_distance"] == "3/4" && cycle["death"]["squared_distance"] == "9/8";
  };
  ASSERT_TRUE(std::ranges::any_of(all["cycles"], is_meant));
  const ordered_json at_one = json_of(kCarried, {"--longest", "100", "--level", "1"});
  std::set<std::string> polygons;
  for (const ordered_json& cycle : at_one["cycles"]) {
    EXPECT_EQ(cycle["squared_level"], "1");
    for (const ordered_json& edge : cycle["edges"]) polygons.insert(edge.dump());
  }
  EXPECT_TRUE(polygons.contains("[0,2]") && polygons.contains("[2,5]") && polygons.contains("[0,5]"));
}

TEST(CyclesCommand, TellsVoidsAndComponents) {
  CITES("FC-CYC-06", "FC-CYC-07", "FC-FILE-52");
  const ordered_json voids = json_of(kOctahedron, {"--dimension", "2"});
  ASSERT_EQ(voids["cycles"].size(), 1U);
  EXPECT_EQ(voids["cycles"][0]["squared_level"], "3/4");
  EXPECT_EQ(voids["cycles"][0]["maxima"].dump(), "[[0,1,2,3,4,5]]");
  EXPECT_EQ(voids["cycles"][0]["walls"].size(), 8U);
  EXPECT_EQ(voids["cycles"][0]["volume"].dump(), "1.3333333333333333");
  const ordered_json joined = json_of("0 0 0\n1 0 0\n9 0 0\n11 0 0\n", {"--dimension", "0"});
  ASSERT_EQ(joined["cycles"].size(), 3U);
  EXPECT_EQ(joined["cycles"][0]["death"]["squared_distance"], "16");
  EXPECT_EQ(joined["cycles"][0]["components"].dump(), "[[0,1],[2,3]]");
}

TEST(CyclesCommand, ChoosesPairsAndLevels) {
  CITES("FC-CYC-03", "FC-CYC-04");
  EXPECT_EQ(json_of(kTetrahedron)["cycles"].size(), 3U);
  EXPECT_EQ(json_of(kTetrahedron, {"--longest", "2"})["cycles"].size(), 2U);
  EXPECT_EQ(json_of(kTetrahedron, {"--longest", "0"})["cycles"].size(), 0U);
  EXPECT_EQ(json_of(kTetrahedron, {"--persistence", "1"})["cycles"].size(), 0U);
  EXPECT_EQ(json_of(kTetrahedron, {"--persistence", "0.5"})["cycles"].size(), 3U);
  const ordered_json one = json_of(kTetrahedron, {"--longest", "1"});
  const std::string birth = one["cycles"][0]["birth"]["contact"].dump(),
                    death = one["cycles"][0]["death"]["contact"].dump();
  const std::string name = birth.substr(1, birth.size() - 2) + "/" + death.substr(1, death.size() - 2);
  EXPECT_EQ(json_of(kTetrahedron, {"--pair", name})["cycles"], one["cycles"]);
  // Births are 18, and deaths 24.
  EXPECT_EQ(json_of(kTetrahedron, {"--level", "birth"})["cycles"][0]["squared_level"], "18");
  EXPECT_EQ(json_of(kTetrahedron, {"--level", "50%"})["cycles"][0]["squared_level"], "21");
  EXPECT_EQ(json_of(kTetrahedron, {"--level", "4.5"})["cycles"][0]["squared_level"], "81/4");
  EXPECT_EQ(json_of(kTetrahedron, {"--level", "5"})["cycles"].size(), 0U);
  EXPECT_EQ(json_of(kTetrahedron, {"--level", "death"})["cycles"][0]["squared_level"], "18");
  // There is no void in a square.
  const Finished none = cycles(kSquare, {"--dimension", "2"});
  EXPECT_EQ(none.status, 0);
  EXPECT_NE(none.out.find("\nno such pair\n"), std::string::npos) << none.out;
}

TEST(CyclesCommand, PrintsTables) {
  const Finished loops = cycles(kSquare, {"--witness"});
  EXPECT_EQ(loops.status, 0);
  for (const char* text : {"pairs of dimension 1", "tunnels", "surfaces", "born at", "the witness of each pair"}) {
    EXPECT_NE(loops.out.find(text), std::string::npos) << text << '\n' << loops.out;
  }
  EXPECT_NE(cycles(kOctahedron, {"--dimension", "2"}).out.find("walls"), std::string::npos);
  EXPECT_NE(cycles(kSquare, {"--dimension", "0"}).out.find("joined to"), std::string::npos);
}

TEST(CyclesCommand, WritesFiles) {
  CITES("FC-FILE-03");
  const Scratch scratch;
  const std::string loops = scratch.path("loops"), voids = scratch.path("voids");
  EXPECT_EQ(cycles(kTetrahedron, {"--export", loops}).status, 0);
  EXPECT_EQ(cycles(kTetrahedron, {"--dimension", "2", "--export", voids}).status, 0);
  const auto names = [](const std::string& folder) {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      found.insert(entry.path().filename().string());
    return found;
  };
  EXPECT_EQ(names(loops),
            (std::set<std::string>{"loop_surfaces.vtp", "loops.vtp", "pair_0.ply", "pair_1.ply", "pair_2.ply"}));
  EXPECT_EQ(names(voids), (std::set<std::string>{"pair_0.ply", "voids.vtu"}));
  EXPECT_NE(content_of(loops + "/loops.vtp").find("flowcert-export 1"), std::string::npos);
}

TEST(CyclesCommand, ChecksWhatItWrites) {
  CITES("FC-CLAIM-25", "FC-FILE-53");
  const Scratch scratch;
  std::string rows;
  for (int k = 0; k < 80; ++k) rows += fmt::format("{} {} {}\n", k * k % 17, k * k * k % 19, k * 7 % 13);
  const std::string points = scratch.file("points.xyz", rows);
  for (const Words& words : {Words{"--dimension", "0"}, Words{"--dimension", "2", "--level", "birth"},
                             Words{"--longest", "40"}, Words{"--level", "death"}}) {
    Words cycles{"cycles", points, "--json"};
    cycles.insert(cycles.end(), words.begin(), words.end());
    const std::string claim = scratch.file("claim.json", flowcert(cycles).out);
    const Finished checked = flowcert({"check", points, claim});
    EXPECT_EQ(checked.status, 0) << checked.out;
    EXPECT_NE(checked.out.find("\nconforms (exact; truth by the fast implementation)\n"), std::string::npos);
  }
}

TEST(CyclesCommand, ChecksLinesOfOthers) {
  CITES("FC-CLAIM-25", "FC-FILE-53");
  const Scratch scratch;
  const std::string square = scratch.file("square.xyz", "0 0 0\n2 0 0\n2 2 0\n0 2 0\n");
  const std::string right = scratch.file("right.txt", "cycles 1 all\npair 1.0 2.0\nloop 3 2 1 0\n");
  const Finished conforms = flowcert({"check", square, right});
  EXPECT_EQ(conforms.status, 0);
  EXPECT_NE(conforms.out.find("conforms to 1.2, cycles, approximate within 1e-09"), std::string::npos);
  const std::string wrong = scratch.file("wrong.txt", "cycles 1\npair 0,1/0,1,2,3\nloop 0 1 2\n");
  const std::string junit = scratch.path("junit.xml");
  const Finished fails = flowcert({"check", square, wrong, "--junit", junit});
  EXPECT_EQ(fails.status, 1);
  EXPECT_NE(unbroken(fails.out).find(":2: edge-too-long [FC-CLAIM-25]: claimed cycle 0 of dimension 1"),
            std::string::npos)
      << fails.out;
  EXPECT_NE(fails.out.find("This loop leaves the balls that there are at its level. This is a bug."),
            std::string::npos);
  EXPECT_NE(content_of(junit).find("name=\"cycles\""), std::string::npos);
  const auto json = nlohmann::json::parse(flowcert({"check", square, wrong, "--json"}).out);
  EXPECT_EQ(json["claim_format"], "cycles");
  EXPECT_EQ(json["cycles"][1],
            nlohmann::json({{"dimension", 1}, {"claimed", 1}, {"true", 1}, {"wrong", 1}, {"missing", 0}}));
  EXPECT_EQ(json["findings"][0]["reason"], "edge-too-long");
  for (const Words& words : {Words{"--oracle"}, Words{"--highest-level", "2"}}) {
    Words check{"check", square, right};
    check.insert(check.end(), words.begin(), words.end());
    EXPECT_EQ(flowcert(check).status, 2);
  }
  const std::string refused = scratch.file("refused.txt", "cycles 1\npair 1 2\nloop 0 1 4\n");
  EXPECT_EQ(flowcert({"check", square, refused}).err,
            "flowcert: " + refused + ":2: there is no point 4; the ids are 0 to 3\n");
}

TEST(CyclesCommand, RefusesInOneLine) {
  for (const auto& [options, reason] : std::vector<std::pair<Words, std::string>>{
           {{"--level", "100%"}, "--level: a share is less than 100%"},
           {{"--level", "-3"}, "--level: less than 0"},
           {{"--level", "middle"}, "--level: neither a number"},
           {{"--level", "%"}, "--level: neither a number"},
           {{"--pair", "1,2"}, "--pair: not two lists of rows"},
           {{"--pair", "1,x/2"}, "--pair"},
           {{"--pair", "2,3/0,1"}, "no such pair: what is born at 2,3 dies at 0,1,2,3"},
           {{"--pair", "0,2/0,1,2,3"}, "no such pair: what dies at 0,1,2,3 is born at 2,3"},
           {{"--pair", "8/9"}, "no such pair: nothing is born at 8"},
           {{"--pair", "2,3/0,1,2,3", "--dimension", "2"}, "no such pair: its dimension is 1"},
           {{"--pair", "2,3/0,1,2,3", "--level", "7"}, "not there at this level"},
           {{"--dimension", "3"}, "--dimension"},
           {{"--dimension", "0", "--export", "x"}, "--export is for --dimension 1 and 2"},
           {{"--dimension", "2", "--witness"}, "--witness is for --dimension 1"},
           {{"--longest", "3", "--persistence", "0"}, "--"}}) {
    const std::string said = refusal(options);
    EXPECT_NE(said.find(reason), std::string::npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  }
}

}  // namespace
}  // namespace flowcert::conformance::cycles_command_test
