// `flowcert orbit` as a user calls it: the table, the JSON object of spec/formats/orbit.md, and every
// kind of input that it refuses.
//
// Guarantees: start, segments and limit are those that the oracle's program prints for the same input, for
// point sets of every dimension, from every kind of Voronoi face, with all kernels and both searches.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::orbit_command_test {
namespace {

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
constexpr char kPair[] = "0 0 0\n2 0 0\n";
// The origin is a regular stationary point of kind 2-3.
constexpr char kKind23[] = "5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n";

// A file, and orbits among its points.
class Points {
 public:
  explicit Points(const std::string& points, const std::string& name = "points.xyz")
      : path_(scratch_.file(name, points)) {}

  [[nodiscard]] Finished text(const std::string& from) const { return flowcert({"orbit", path_, "--from", from}); }
  [[nodiscard]] ordered_json as_json(const std::string& from, const Words& options = {}) const {
    Words words = {"orbit", path_, "--from", from, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return parsed(flowcert(words));
  }
  [[nodiscard]] ordered_json by_oracle(const std::string& from) const {
    return parsed(flowcert_oracle({"orbit", path_, "--from", from, "--json"}));
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  static ordered_json parsed(const Finished& finished) {
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.out;
    ordered_json answer = ordered_json::parse(finished.out, nullptr, false);
    EXPECT_TRUE(answer.is_object()) << finished.out;
    return answer.is_object() ? answer : ordered_json::object();
  }

  Scratch scratch_;
  std::string path_;
};

Words keys_of(const ordered_json& object) {
  Words keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

TEST(OrbitJson, HasTheKeysOfTheFormatInTheirOrder) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FILE-20");
  const Points cube(kCube);
  const ordered_json answer = cube.as_json("0.25,0.5,0.125");
  EXPECT_EQ(keys_of(answer), (Words{"format", "format_version", "version", "commit", "kernel", "compiler", "cgal",
                                    "input_sha256", "start", "segments", "limit"}));
  EXPECT_EQ(answer["format"], "flowcert-orbit");
  EXPECT_EQ(answer["format_version"], 1);
  const ordered_json summary = ordered_json::parse(flowcert({"compute", cube.path(), "--json"}).out);
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal", "input_sha256"}) {
    EXPECT_EQ(answer[key], summary[key]);
  }
  EXPECT_EQ(answer["start"], ordered_json({"1/4", "1/2", "1/8"}));
  EXPECT_FALSE(answer["segments"].empty());
  for (const ordered_json& segment : answer["segments"]) {
    EXPECT_EQ(keys_of(segment), (Words{"type", "driver", "end", "start_contact", "crossed_contact", "end_contact"}));
  }
  EXPECT_EQ(keys_of(answer["limit"]), (Words{"kind", "index", "position", "contact", "squared_distance"}));
}

TEST(OrbitJson, TheKnownOrbitBetweenTwoPoints) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-04", "FC-FLOW-05");
  const ordered_json answer = Points(kPair).as_json("1/2,0,1");
  EXPECT_EQ(answer["segments"], ordered_json::parse(R"([
    {"type": "C-C-F", "driver": ["0", "0", "0"], "end": ["1", "0", "2"],
     "start_contact": [0], "crossed_contact": [0], "end_contact": [0, 1]},
    {"type": "F-F-inf", "driver": ["1", "0", "0"], "end": null,
     "start_contact": [0, 1], "crossed_contact": [0, 1], "end_contact": null}])"));
  EXPECT_EQ(answer["limit"], ordered_json::parse(R"({"kind": "infinity", "index": null, "position": null,
                                                     "contact": null, "squared_distance": null})"));
}

TEST(OrbitJson, EndsAtCriticalAndRegularPoints) {
  CITES("FC-FLOW-02", "FC-FLOW-05");
  const ordered_json up = Points(kCube).as_json("1/2,1/2,1/4");
  EXPECT_EQ(up["segments"], ordered_json::parse(R"([
    {"type": "E-E-V", "driver": ["1/2", "1/2", "0"], "end": ["1/2", "1/2", "1/2"],
     "start_contact": [0, 1, 2, 3], "crossed_contact": [0, 1, 2, 3],
     "end_contact": [0, 1, 2, 3, 4, 5, 6, 7]}])"));
  EXPECT_EQ(up["limit"], ordered_json::parse(R"({"kind": "critical", "index": 3,
    "position": ["1/2", "1/2", "1/2"], "contact": [0, 1, 2, 3, 4, 5, 6, 7], "squared_distance": "3/4"})"));
  const ordered_json regular = Points(kKind23).as_json("1,0,0");
  EXPECT_EQ(regular["segments"].size(), 1U);
  EXPECT_EQ(regular["segments"][0]["type"], "C-C-V");
  EXPECT_EQ(regular["limit"], ordered_json::parse(R"({"kind": "regular", "index": [2, 3],
    "position": ["0", "0", "0"], "contact": [0, 1, 2, 3], "squared_distance": "25"})"));
}

TEST(OrbitJson, AStationaryStartHasNoSegment) {
  CITES("FC-FLOW-03", "FC-CRIT-03", "FC-CRIT-04");
  const Points cube(kCube);
  const std::pair<const char*, int> starts[] = {{"1,0,1", 0}, {"1/2,0,1", 1}, {"1/2,1/2,1", 2}, {"1/2,1/2,1/2", 3}};
  for (const auto& [from, index] : starts) {
    const ordered_json answer = cube.as_json(from);
    EXPECT_EQ(answer["segments"], ordered_json::array()) << from;
    EXPECT_EQ(answer["limit"]["kind"], "critical") << from;
    EXPECT_EQ(answer["limit"]["index"], index) << from;
    EXPECT_EQ(answer["limit"]["position"], answer["start"]) << from;
  }
  const ordered_json regular = Points("0 0 0\n3 0 0\n0 4 0\n").as_json("3/2,2,0");
  EXPECT_EQ(regular["segments"], ordered_json::array());
  EXPECT_EQ(regular["limit"]["index"], ordered_json({1, 2}));
}

TEST(OrbitJson, RepeatedPointsGoByTheNameOfTheirClass) {
  CITES("FC-IN-03");
  const Points points("0 0 0\n-0.0 0 0\n2 0 0\n0 0 0\n");
  const ordered_json answer = points.as_json("1/2,0,1");
  ASSERT_EQ(answer["segments"].size(), 2U);
  EXPECT_EQ(answer["segments"][0]["end_contact"], ordered_json({0, 2}));
  EXPECT_EQ(points.text("0,0,0").err, "warning: " + points.path() + ": 2 repeated points merged\n");
}

struct Input {
  std::string name;
  std::string points;
};

// Inputs of every dimension, degenerate and not.
std::vector<Input> inputs() {
  std::string grid;
  for (int k = 0; k < 18; ++k) {
    grid += std::to_string(k % 3) + " " + std::to_string(k / 3 % 3) + " " + std::to_string(k / 9) + "\n";
  }
  return {{"one", "1 2 3\n"},
          {"pair", kPair},
          {"collinear", "0 0 0\n3 3 3\n1 1 1\n0.1 0.1 0.1\n7 7 7\n"},
          {"right triangle", "0 0 0\n3 0 0\n0 4 0\n"},
          {"obtuse triangle", "0 0 0\n9 0 0\n1 1 0\n"},
          {"square", "0 0 1\n1 0 1\n0 1 1\n1 1 1\n"},
          {"coplanar", "0 0 0\n4 0 0\n0 4 0\n4 4 0\n2 1 0\n1 3 0\n7 2 0\n2 9 0\n"},
          {"tetrahedron", "0 0 0\n4 0 0\n1 5 0\n2 1 3\n"},
          {"cube", kCube},
          {"kind 2-3", kKind23},
          {"kind 1-3", "1 0 0\n-1 0 0\n0 1 0\n0 0 1\n"},
          {"grid", grid},
          {"general",
           "0.3 1.7 2.9\n4.1 0.2 3.3\n1.9 5.5 0.7\n3.1 2.2 6.4\n5.9 4.8 1.1\n2.7 3.6 3.1\n"
           "0.9 0.1 5.2\n6.3 5.7 5.9\n"},
          {"magnitudes", "1e300 0 0\n-1e300 3 0\n0 1e-300 0\n0 1 1\n3 0.1 1e150\n"}};
}

// The starts are in cells, and on facets, edges and vertices of the inputs' Voronoi diagrams.
constexpr const char* kStarts[] = {"0,0,0",   "1/2,1/2,1/2", "1/2,1/2,0",    "-1,2,3",       "0.3,-0.2,0.1",
                                   "1/2,0,7", "2,2,-1/3",    "3/2,5/7,-2/9", "0x1p-3,1e3,0", "1,1,3/2"};

TEST(OrbitJson, IsTheOraclesOrbit) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-04", "FC-FLOW-05", "FC-IN-04");
  std::size_t segments = 0;
  std::set<std::string> limits;
  for (const Input& input : inputs()) {
    const Points points(input.points);
    for (const char* from : kStarts) {
      SCOPED_TRACE(input.name + " from " + from);
      const ordered_json ours = points.as_json(from), theirs = points.by_oracle(from);
      for (const char* key : {"start", "segments", "limit"}) EXPECT_EQ(ours[key], theirs[key]) << key;
      segments += ours["segments"].size();
      limits.insert(ours["limit"]["kind"].get<std::string>());
    }
  }
  EXPECT_GT(segments, 200U);
  EXPECT_EQ(limits, (std::set<std::string>{"critical", "regular", "infinity"}));
}

TEST(OrbitJson, KernelAndSearchDoNotMatter) {
  CITES("FC-NUM-01", "FC-FLOW-05");
  for (const Input& input : inputs()) {
    const Points points(input.points);
    for (const char* from : {"0.3,-0.2,0.1", "3/2,5/7,-2/9"}) {
      SCOPED_TRACE(input.name + " from " + from);
      const std::string expected = points.as_json(from).dump();
      for (const Words& options :
           {Words{"--kernel", "exact"}, Words{"--search", "linear"}, Words{"--kernel", "exact", "--search", "linear"},
            Words{"--kernel", "lazy", "--search", "binary"}, Words{"--kernel", "lazy", "--search", "linear"},
            Words{"--kernel", "cascade", "--search", "binary"}, Words{"--kernel", "cascade", "--search", "linear"}}) {
        EXPECT_EQ(points.as_json(from, options).dump(), expected) << ::testing::PrintToString(options);
      }
    }
  }
}

TEST(OrbitTable, IsAlignedAndEndsWithTheLimit) {
  CITES("FC-FLOW-02", "FC-FLOW-05");
  const Finished away = Points(kPair).text("1/2,0,1");
  EXPECT_EQ(away.status, 0);
  EXPECT_EQ(away.err, "");
  EXPECT_EQ(away.out,
            "orbit from 1/2, 0, 1\n"
            "     type     driver   end       contact set of the end\n"
            "  1  C-C-F    0, 0, 0  1, 0, 2   0 1\n"
            "  2  F-F-inf  1, 0, 0  infinity\n"
            "goes to infinity\n");
  const Words up = lines_of(Points(kCube).text("1/2,1/2,1/4").out);
  ASSERT_EQ(up.size(), 5U);
  EXPECT_EQ(up[3], "ends at a maximum (critical point of index 3), contact set 0 1 2 3 4 5 6 7,");
  EXPECT_EQ(up[4], "  squared distance 3/4");
  const Words regular = lines_of(Points(kKind23).text("1,0,0").out);
  ASSERT_EQ(regular.size(), 5U);
  EXPECT_EQ(regular[3], "ends at a regular stationary point of kind 2-3, contact set 0 1 2 3, squared");
  EXPECT_EQ(regular[4], "  distance 25");
}

TEST(OrbitTable, SaysThatAStationaryStartStays) {
  CITES("FC-FLOW-03");
  const Points cube(kCube);
  const std::pair<const char*, const char*> starts[] = {
      {"1,0,1", "C-C-C, a minimum (critical point of index 0), contact set 5, squared distance 0"},
      {"1/2,0,1", "F-F-F, a saddle (critical point of index 1), contact set 4 5, squared distance 1/4"},
      {"1/2,1/2,1", "E-E-E, a saddle (critical point of index 2), contact set 4 5 6 7, squared distance 1/2"},
      {"1/2,1/2,1/2",
       "V-V-V, a maximum (critical point of index 3), contact set 0 1 2 3 4 5 6 7, squared distance 3/4"}};
  for (const auto& [from, what] : starts) {
    // A line that goes on is indented.
    const std::string told = std::regex_replace(cube.text(from).out, std::regex("\n  "), " ");
    const Words lines = lines_of(told);
    ASSERT_EQ(lines.size(), 2U) << from;
    EXPECT_EQ(lines[1], std::string("stays: ") + what);
  }
}

TEST(OrbitTable, LongExactNumbersAreRounded) {
  CITES("FC-NUM-02");
  const std::string far = "1" + std::string(320, '0') + "/1";
  const Finished finished = Points(kPair).text("0.1,1/3," + far);
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_TRUE(finished.out.starts_with("orbit from 0.1, 1/3, > 1.8e308\n")) << finished.out;
  for (const std::string& line : lines_of(finished.out)) EXPECT_LT(line.size(), 160U) << line;
}

TEST(OrbitCommand, PositionsAreDecimalsHexFloatsOrFractions) {
  CITES("FC-IN-02", "FC-NUM-02", "FC-FILE-21");
  const Points pair(kPair);
  const std::pair<const char*, ordered_json> positions[] = {
      {"0.5,0.5,0.5", {"1/2", "1/2", "1/2"}},
      {"1/2,2/4,0x1p-1", {"1/2", "1/2", "1/2"}},
      {"-1,2,3", {"-1", "2", "3"}},
      {"-0x1p-1,-.5,-6/4", {"-1/2", "-1/2", "-3/2"}},
      {"0.1,1/10,1e-400", {"3602879701896397/36028797018963968", "1/10", "0"}}};
  for (const auto& [text, start] : positions) EXPECT_EQ(pair.as_json(text)["start"], start) << text;
  // The order of arguments does not matter.
  const std::string expected = pair.text("-1,2,3").out;
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(flowcert({"orbit", "--from", "-1,2,3", pair.path()}).out, expected);
  EXPECT_EQ(flowcert({"orbit", "--from=-1,2,3", pair.path()}).out, expected);
}

// Status 2, one line that says this, and no output.
void expect_refused(const Finished& finished, const std::string& reason) {
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
  EXPECT_TRUE(finished.err.starts_with("flowcert: ")) << finished.err;
  EXPECT_NE(finished.err.find(reason), std::string::npos) << finished.err << "not: " << reason;
}

TEST(OrbitCommand, WhatIsNoPositionIsStatus2) {
  CITES("FC-IN-01", "FC-IN-02", "FC-FILE-21");
  const Points cube(kCube);
  const std::pair<const char*, const char*> starts[] = {{"nan,0,0", "not a finite number"},
                                                        {"0,inf,0", "not a finite number"},
                                                        {"0,0,-inf", "not a finite number"},
                                                        {"1e999,0,0", "out of range of a double: '1e999'"},
                                                        {"0,0,-1e309", "out of range of a double"},
                                                        {"0,0,0x1p-1075", "not exactly a double"},
                                                        {"0,0,1/0", "the denominator is zero"},
                                                        {"0,0", "this has 2"},
                                                        {"0,0,0,0", "this has 4"},
                                                        {"", "this has 0"},
                                                        {"0,,", "this has 2"},
                                                        {"a,b,c", "not a number"},
                                                        {"0,0,1/-2", "not a number"},
                                                        {"0,0,0.5/2", "not a number"}};
  for (const auto& [from, reason] : starts) {
    SCOPED_TRACE(from);
    expect_refused(cube.text(from), std::string("--from: "));
    expect_refused(cube.text(from), reason);
    expect_refused(flowcert({"orbit", cube.path(), "--json", "--from", from}), reason);
  }
}

TEST(OrbitCommand, WhatIsNoInputIsStatus2) {
  CITES("FC-IN-05", "FC-FLOW-10");
  const Points nothing("# no point\n");
  expect_refused(nothing.text("0,0,0"), nothing.path() + ": there are no points");
  const Points damaged("0 0 0\n1 1\n");
  expect_refused(damaged.text("0,0,0"), damaged.path() + ":2: ");
  expect_refused(flowcert({"orbit", damaged.path() + ".none", "--from", "0,0,0"}), "No such file or directory");
  const Points pair(kPair);
  for (const Words& usage :
       {Words{"orbit"}, Words{"orbit", pair.path()}, Words{"orbit", pair.path(), "--from"},
        Words{"orbit", "--from", "0,0,0"}, Words{"orbit", pair.path(), "--from", "0,0,0", "--kernel", "fast"},
        Words{"orbit", pair.path(), "--from", "0,0,0", "--search", "none"},
        Words{"orbit", pair.path(), "--from", "0,0,0", "--bogus"}}) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    expect_refused(flowcert(usage), "(see flowcert orbit --help)");
  }
}

// The block after <!-- example: orbit --> is a command line after a dollar, and all that it prints.
TEST(OrbitCommand, TheReadmesExampleIsRight) {
  const Words lines = lines_of(content_of(FLOWCERT_CLI_README));
  auto line = std::find(lines.begin(), lines.end(), "<!-- example: orbit -->");
  ASSERT_GT(lines.end() - line, 3);
  line += 2;  // the mark, the fence
  const std::string program = "build/flowcert";
  std::string command = *line;
  ASSERT_TRUE(command.starts_with("$ "));
  ASSERT_NE(command.find(program), std::string::npos) << command;
  command = command.replace(command.find(program), program.size(), "\"$0\"").substr(2);
  std::string expected;
  while (++line != lines.end() && *line != "```") expected += *line + "\n";
  EXPECT_EQ(RunningProgram({"/bin/sh", "-c", command, FLOWCERT_PROGRAM}).finish().out, expected);
}

TEST(OrbitCommand, ReadsStandardInput) {
  const Points pair(kPair);
  const Finished finished =
      flowcert({"orbit", "-", "--from", "1/2,0,1"}, {.standard_input = pair.path(), .standard_output = ""});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.out, pair.text("1/2,0,1").out);
}

}  // namespace
}  // namespace flowcert::conformance::orbit_command_test
