// `flowcert persistence` as a user calls it: the .pers text, the table, the JSON object of
// spec/formats/persistence.md, and every kind of input that it refuses.
//
// Guarantees: known diagrams, on inputs of every dimension; the text is read back by GUDHI's own reader, to
// the bit.
#include <gtest/gtest.h>
#include <gudhi/read_persistence_from_file.h>

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "flowcert/rational.h"
#include "geometry/difference_of_roots.h"
#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::persistence_command_test {
namespace {

using geometry::RootDifference;
using nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr char kTetrahedron[] = "0 0 0\n1 1 0\n1 0 1\n0 1 1\n";
constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
// The origin is a regular stationary point of kind 1-3. The second input has points of kind 1-2 as well.
constexpr char kKind13[] = "1 0 0\n-1 0 0\n0 1 0\n0 0 1\n";
constexpr char kFive[] = "0 0 1\n1 0 0\n0 0 0\n1 1 1\n1 0 1\n";
// The boundary of its maximum's boundary is not zero.
constexpr char kNoComplex[] = "0 5 0\n-3 0 -2\n3 0 -2\n0 0 12\n0 -5 0\n";

Finished persistence(const std::string& path, Words options = {}) {
  options.insert(options.begin(), {"persistence", path});
  return flowcert(options);
}

// With the pairs on standard output.
Finished text_of(const std::string& path, Words options = {}) {
  options.insert(options.end(), {"-o", "-"});
  return persistence(path, options);
}

// The lines without the comments in front.
Words pairs_of(const Finished& finished) {
  EXPECT_EQ(finished.status, 0) << finished.err;
  Words lines = lines_of(finished.out);
  std::erase_if(lines, [](const std::string& line) { return line.starts_with("#"); });
  return lines;
}

Words pairs_of(const std::string& points, const Words& options = {}) {
  const Scratch scratch;
  return pairs_of(text_of(scratch.file("points.xyz", points), options));
}

ordered_json json_of(const std::string& path, Words options = {}) {
  options.emplace_back("--json");
  const Finished finished = persistence(path, options);
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.out;
  ordered_json answer = ordered_json::parse(finished.out, nullptr, false);
  EXPECT_TRUE(answer.is_object()) << finished.out;
  return answer.is_object() ? answer : ordered_json::object();
}

Words keys_of(const ordered_json& object) {
  Words keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

// Status 2, one line that says this, and no output.
void expect_refused(const Finished& finished, const std::string& reason) {
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
  EXPECT_TRUE(finished.err.starts_with("flowcert: ")) << finished.err;
  EXPECT_NE(finished.err.find(reason), std::string::npos) << finished.err << "not: " << reason;
}

TEST(PersistenceText, KnownDiagrams) {
  CITES("FC-PERS-01", "FC-PERS-02", "FC-IN-04", "FC-FILE-22");
  EXPECT_EQ(pairs_of(kTetrahedron),
            (Words{"0 0 0.5", "0 0 0.5", "0 0 0.5", "0 0 inf", "1 0.5 0.6666666666666666", "1 0.5 0.6666666666666666",
                   "1 0.5 0.6666666666666666", "2 0.6666666666666666 0.75"}));
  Words cube(7, "0 0 0.25");
  cube.emplace_back("0 0 inf");
  cube.insert(cube.end(), 5, "1 0.25 0.5");
  cube.emplace_back("2 0.5 0.75");
  EXPECT_EQ(pairs_of(kCube), cube);
  EXPECT_EQ(pairs_of("0 0 1\n1 0 1\n0 1 1\n1 1 1\n"),
            (Words{"0 0 0.25", "0 0 0.25", "0 0 0.25", "0 0 inf", "1 0.25 0.5"}));
}

TEST(PersistenceText, FewPoints) {
  CITES("FC-PERS-02", "FC-IN-03", "FC-IN-04");
  EXPECT_EQ(pairs_of("# none\n"), Words{});
  EXPECT_EQ(pairs_of("1 2 3\n"), (Words{"0 0 inf"}));
  EXPECT_EQ(pairs_of("1 2 3\n1 2 3\n"), (Words{"0 0 inf"}));
  EXPECT_EQ(pairs_of("7 0 0\n0 0 0\n2 0 0\n3 0 0\n"), (Words{"0 0 0.25", "0 0 1", "0 0 4", "0 0 inf"}));
}

TEST(PersistenceText, SaysWhatItIsInComments) {
  const Scratch scratch;
  const std::string path = scratch.file("cube.xyz", kCube);
  const Words lines = lines_of(text_of(path).out);
  ASSERT_GT(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            "# Persistence of the distance function: dimension, birth, death. The values are squared distances.");
  const ordered_json json = json_of(path);
  std::string made_by = lines_of(flowcert({"--version"}).out).at(0);
  EXPECT_EQ(lines[1], "# " + made_by + ", input_sha256 " + json["input_sha256"].get<std::string>());
  EXPECT_EQ(lines[2], "# Without pairs of length zero.");
  EXPECT_EQ(lines_of(text_of(path, {"--zero"}).out)[2], "# With regular stationary points, as pairs of length zero.");
}

TEST(PersistenceText, RegularStationaryPointsArePairsOfLengthZero) {
  CITES("FC-PERS-03", "FC-INV-02", "FC-CRIT-03");
  const Words plain = pairs_of(kKind13), with_zero = pairs_of(kKind13, {"--zero"});
  Words added;
  std::ranges::set_difference(with_zero, plain, std::back_inserter(added));
  EXPECT_EQ(added, (Words{"1 1 1", "2 1 1"}));
  EXPECT_EQ(plain.size() + 2, with_zero.size());
  EXPECT_EQ(pairs_of("0 0 0\n3 0 0\n0 4 0\n", {"--zero"}), (Words{"0 0 2.25", "0 0 4", "0 0 inf", "1 6.25 6.25"}));
  EXPECT_EQ(pairs_of("5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n", {"--zero"}).back(), "2 25 25");
}

// A triangle whose angle at the last point falls short of a right one by so little that the squared radius of
// its circle, 1 + 2^-56 or so, has the nearest double 1: that of its longest side.
TEST(PersistenceText, PairsThatDoublesCannotTellApartAreKept) {
  CITES("FC-PERS-03", "FC-NUM-02");
  const std::string points = "-1 0 0\n1 0 0\n0 0x1.0000001p0 0\n";
  EXPECT_EQ(pairs_of(points).back(), "1 1 1");
  const Scratch scratch;
  const ordered_json pair = json_of(scratch.file("points.xyz", points))["pairs"].back();
  EXPECT_EQ(pair["birth"]["squared_distance"], "1");
  EXPECT_NE(pair["death"]["squared_distance"], "1");
  EXPECT_EQ(pair["death"]["squared_distance_double"], 1.0);
}

TEST(PersistenceText, IsReadByGudhi) {
  const Scratch scratch;
  const std::string path = scratch.file("points.xyz", kFive), output = scratch.path("points.pers");
  ASSERT_EQ(persistence(path, {"-o", output}).status, 0);
  const auto read = Gudhi::read_persistence_intervals_grouped_by_dimension(output);
  std::map<int, std::vector<std::pair<double, double>>> expected;
  const ordered_json json = json_of(path);
  for (const ordered_json& pair : json["pairs"]) {
    const double death = pair["death"].is_null() ? std::numeric_limits<double>::infinity()
                                                 : pair["death"]["squared_distance_double"].get<double>();
    expected[pair["dimension"]].emplace_back(pair["birth"]["squared_distance_double"], death);
  }
  EXPECT_EQ(read, expected);
  EXPECT_EQ(read.at(0).size(), 5U);
  const auto finite =
      Gudhi::Persistence_representations::read_persistence_intervals_in_one_dimension_from_file(output, 0);
  EXPECT_EQ(finite.size(), 4U);
}

TEST(PersistenceText, TheSeedOfTiesDoesNotShow) {
  CITES("FC-PERS-01", "FC-PERS-04", "FC-CHAIN-02");
  const Scratch scratch;
  for (const char* points : {kKind13, kFive, kNoComplex, kCube}) {
    const std::string path = scratch.file("points.xyz", points);
    const std::string expected = text_of(path, {"--zero"}).out;
    for (const char* seed : {"1", "2", "18446744073709551615"}) {
      EXPECT_EQ(text_of(path, {"--zero", "--seed-ties", seed}).out, expected) << points << seed;
    }
  }
  const ordered_json json = json_of(scratch.file("points.xyz", kNoComplex), {"--seed-ties", "9"});
  EXPECT_EQ(json["seed"], 9);
  EXPECT_EQ(json["ties_broken"], 1);
}

TEST(PersistenceFile, HasTheTextAndLeavesATable) {
  const Scratch scratch;
  const std::string path = scratch.file("cube.xyz", kCube), output = scratch.path("cube.pers");
  const Finished finished = persistence(path, {"-o", output});
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.err, "");
  EXPECT_EQ(content_of(output), text_of(path).out);
  const Words lines = lines_of(finished.out);
  ASSERT_EQ(lines.size(), 30U) << finished.out;
  EXPECT_EQ(lines[0], path + " (table)");
  EXPECT_EQ(lines[3], "pairs of dimension 0                           7   components; 1 lasts");
  EXPECT_EQ(lines[4], "pairs of dimension 1                           5   tunnels; 0 last");
  EXPECT_EQ(lines[5], "pairs of dimension 2                           1   voids; 0 last");
  EXPECT_TRUE(lines[6].ends_with("--zero writes them")) << lines[6];
  EXPECT_TRUE(lines[11].ends_with(" x the triangulation")) << lines[11];
  // JSON is printed instead of the table. The file is the same.
  const std::string again = scratch.path("again.pers");
  EXPECT_EQ(json_of(path, {"-o", again})["pairs"].size(), 14U);
  EXPECT_EQ(content_of(again), content_of(output));
}

// Roots of the squares, in a file that says so, and that nobody takes for squares.
TEST(PersistenceFile, OfPlainDistancesIsMarkedAndNotJudged) {
  CITES("FC-FILE-22");
  const Scratch scratch;
  const std::string path = scratch.file("cube.xyz", kCube), output = scratch.path("cube.pers");
  ASSERT_EQ(persistence(path, {"-o", output, "--plain"}).status, 0);
  const Words lines = lines_of(content_of(output));
  EXPECT_EQ(lines.at(0), "# Persistence of the distance function: dimension, birth, death. The values are distances.");
  EXPECT_EQ(lines.at(3), "# flowcert: plain values, not squared");
  EXPECT_EQ(lines.at(4), "0 0 0.5");
  EXPECT_EQ(lines.back(), "2 0.7071067811865476 0.8660254037844386");
  for (const std::string& claim : {output, scratch.file("cube.txt", content_of(output))}) {
    expect_refused(flowcert({"check", path, claim}), "the values are plain distances (persistence --plain)");
  }
}

// The lines below the title of the longest pairs, by words.
std::vector<Words> longest_rows(const std::string& table) {
  std::vector<Words> rows;
  bool is_below = false;
  for (const std::string& line : lines_of(table)) {
    std::istringstream words(line);
    Words row{std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
    if (is_below && row.empty()) break;
    if (is_below) rows.push_back(row);
    is_below = is_below || (!row.empty() && row[0] == "dimension");
  }
  return rows;
}

TEST(PersistenceTable, HasTheLongestPairsOfEachDimension) {
  CITES("FC-PERS-01", "FC-PERS-02");
  const Scratch scratch;
  std::string points;
  std::mt19937 numbers(11);
  for (int k = 0; k < 180; ++k) points += std::to_string(numbers() % 1000) + (k % 3 == 2 ? "\n" : " ");
  const std::string input = scratch.file("points.xyz", points);
  const Finished finished = persistence(input, {"-o", scratch.path("out.pers")});
  ASSERT_EQ(finished.status, 0) << finished.err;
  const std::vector<Words> rows = longest_rows(finished.out);
  const ordered_json answer = json_of(input);
  std::size_t row = 0;
  for (int dimension = 0; dimension < 3; ++dimension) {
    std::vector<std::pair<RootDifference, const ordered_json*>> pairs;
    for (const auto& pair : answer["pairs"]) {
      if (pair["dimension"] != dimension || pair["death"].is_null()) continue;
      const Rational birth(pair["birth"]["squared_distance"].get<std::string>()),
          death(pair["death"]["squared_distance"].get<std::string>());
      pairs.emplace_back(RootDifference{death, birth}, &pair);
    }
    std::ranges::stable_sort(pairs, [](const auto& a, const auto& b) { return a.first > b.first; });
    ASSERT_GE(pairs.size(), 5U);
    if (dimension == 0) {
      EXPECT_EQ(rows.at(row++), (Words{"0", "inf", "0.0", "inf", "0", "never"}));
    }
    for (std::size_t k = 0; k < (dimension == 0 ? 4U : 5U); ++k, ++row) {
      Words expected{std::to_string(dimension)};
      const auto& pair = *pairs[k].second;
      const auto& [death, birth] = pairs[k].first;
      // The spacing is between 100 and 1000, so that there is one decimal.
      for (const RootDifference& value : {pairs[k].first, RootDifference{birth}, RootDifference{death}}) {
        std::ostringstream text;
        text << std::fixed << std::setprecision(1) << geometry::nearest_difference_of_roots(value.square, value.less);
        expected.push_back(text.str());
      }
      for (const char* end : {"birth", "death"}) {
        for (const auto& name : pair[end]["contact"]) expected.push_back(std::to_string(name.get<int>()));
      }
      EXPECT_EQ(rows.at(row), expected);
    }
  }
  EXPECT_EQ(rows.size(), row);
}

TEST(PersistenceTable, EqualPairsComeInTheirOrderAndLongContactSetsAreCut) {
  CITES("FC-PERS-02");
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube);
  const std::vector<Words> rows = longest_rows(persistence(input, {"-o", scratch.path("out.pers")}).out);
  ASSERT_EQ(rows.size(), 11U);
  EXPECT_EQ(rows[1], (Words{"0", "0.500", "0.000", "0.500", "1", "0", "1"}));
  EXPECT_EQ(rows[10],
            (Words{"2", "0.159", "0.707", "0.866", "4", "5", "6", "7", "0", "1", "2", "3", "and", "4", "more"}));
  const std::string none = scratch.file("none.off", "OFF\n0 0 0\n");
  EXPECT_EQ(longest_rows(persistence(none, {"-o", scratch.path("out.pers")}).out).size(), 0U);
}

TEST(PersistenceJson, HasTheKeysOfTheFormatInTheirOrder) {
  CITES("FC-PERS-01", "FC-OUT-01", "FC-FILE-23", "FC-FILE-03");
  const Scratch scratch;
  const std::string path = scratch.file("points.xyz", kTetrahedron);
  const ordered_json json = json_of(path);
  EXPECT_EQ(keys_of(json), (Words{"format", "format_version", "version", "commit", "kernel", "compiler", "cgal",
                                  "input_sha256", "points", "merged_duplicates", "critical", "regular_stationary",
                                  "counts", "ties_broken", "seed", "has_zero", "pairs"}));
  EXPECT_EQ(json["format"], "flowcert-persistence");
  EXPECT_EQ(json["format_version"], 1);
  EXPECT_EQ(json["critical"], ordered_json({4, 6, 4, 1}));
  EXPECT_EQ(json["counts"], ordered_json::parse(R"([{"positive": 3, "zero": 0, "lasting": 1},
    {"positive": 3, "zero": 0, "lasting": 0}, {"positive": 1, "zero": 0, "lasting": 0}])"));
  EXPECT_EQ(json["ties_broken"], 0);
  EXPECT_EQ(json["seed"], 0);
  EXPECT_EQ(json["has_zero"], false);
  const ordered_json& last = json["pairs"].back();
  EXPECT_EQ(last["dimension"], 2);
  EXPECT_EQ(last["birth"]["contact"].size(), 3U);
  EXPECT_EQ(last["birth"]["squared_distance"], "2/3");
  EXPECT_EQ(last["birth"]["squared_distance_double"], 2.0 / 3);
  EXPECT_EQ(last["death"],
            ordered_json::parse(R"({"record": 14, "contact": [0, 1, 2, 3], "center": ["1/2", "1/2", "1/2"],
                              "center_double": [0.5, 0.5, 0.5], "squared_distance": "3/4", "squared_distance_double": 0.75})"));
  EXPECT_EQ(json["pairs"][3]["birth"]["contact"], ordered_json::array({0}));
  EXPECT_TRUE(json["pairs"][3]["death"].is_null());
}

TEST(PersistenceJson, CountsAreThoseOfThePairs) {
  CITES("FC-PERS-02", "FC-PERS-03");
  const Scratch scratch;
  for (const char* points : {kKind13, kFive, kNoComplex, kCube, "# none\n", "1 2 3\n", "0 0 0\n3 0 0\n0 4 0\n"}) {
    SCOPED_TRACE(points);
    const ordered_json json = json_of(scratch.file("points.xyz", points), {"--zero"});
    EXPECT_EQ(json["has_zero"], true);
    ordered_json counts = ordered_json::array();
    for (int k = 0; k < 3; ++k) counts.push_back({{"positive", 0}, {"zero", 0}, {"lasting", 0}});
    for (const ordered_json& pair : json["pairs"]) {
      const bool lasts = pair["death"].is_null(), is_zero = pair["death"] == pair["birth"];
      ordered_json& count = counts[pair["dimension"].get<std::size_t>()][lasts     ? "lasting"
                                                                         : is_zero ? "zero"
                                                                                   : "positive"];
      count = count.get<int>() + 1;
    }
    EXPECT_EQ(json["counts"], counts);
  }
}

TEST(PersistenceCommand, ValuesBeyondTheDoublesNeedJson) {
  CITES("FC-NUM-02", "FC-IN-04");
  const Scratch scratch;
  const std::string path = scratch.file("far.xyz", "1e200 0 0\n-1e200 0 0\n");
  expect_refused(text_of(path), path + ": a squared distance is beyond the largest double");
  EXPECT_EQ(pairs_of(text_of(path, {"--plain"})), (Words{"0 0 1e+200", "0 0 inf"}));
  EXPECT_EQ(persistence(path).status, 0);
  expect_refused(persistence(path, {"-o", scratch.path("far.pers")}), "--json has it exactly");
  EXPECT_EQ(scratch.names(), (std::set<std::string>{"far.xyz"}));
  const ordered_json death = json_of(path)["pairs"][0]["death"];
  EXPECT_GT(death["squared_distance"].get<std::string>().size(), 300U);
  EXPECT_TRUE(death["squared_distance_double"].is_null());
}

TEST(PersistenceCommand, WhatIsNoInputIsStatus2) {
  CITES("FC-IN-01", "FC-IN-05");
  const Scratch scratch;
  expect_refused(persistence(scratch.file("short.xyz", "0 0 0\n1 1\n")), "short.xyz:2: ");
  expect_refused(persistence(scratch.file("nan.xyz", "0 0 nan\n")), "nan.xyz:1: ");
  expect_refused(persistence(scratch.file("empty.xyz", "")), "empty.xyz");
  expect_refused(persistence(scratch.path("none.xyz")), "No such file or directory");
  const std::string cube = scratch.file("cube.xyz", kCube);
  expect_refused(persistence(cube, {"-o", scratch.path("none/cube.pers")}), "cannot be written");
  expect_refused(persistence(cube, {"-o", "/dev/full"}), "cannot be written");
  expect_refused(flowcert({"persistence"}), "(see flowcert persistence --help)");
  for (const Words& usage : {Words{"-o"}, Words{"--seed-ties"}, Words{"--seed-ties", "x"}, Words{"--seed-ties", "-1"},
                             Words{"--seed-ties", "18446744073709551616"}, Words{"--bogus"}, Words{"--plain"}}) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    expect_refused(persistence(cube, usage), "(see flowcert persistence --help)");
  }
  const Finished full =
      flowcert({"persistence", cube}, {.standard_input = "/dev/null", .standard_output = "/dev/full"});
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(full.err, "flowcert: standard output cannot be written: No space left on device\n");
}

TEST(PersistenceCommand, HelpHasAnExample) {
  const Finished help = flowcert({"persistence", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("flowcert persistence bunny.obj -o bunny.pers"), std::string::npos) << help.out;
}

TEST(PersistenceCommand, ReadsStandardInput) {
  const Scratch scratch;
  const std::string cube = scratch.file("cube.xyz", kCube);
  const Finished finished = flowcert({"persistence", "-", "-o", "-"}, {.standard_input = cube, .standard_output = ""});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.out, text_of(cube).out);
}

// The block after <!-- example: persistence --> is a command line after a dollar, and all that it prints.
TEST(PersistenceCommand, TheReadmesExampleIsRight) {
  const Words lines = lines_of(content_of(FLOWCERT_CLI_README));
  auto line = std::find(lines.begin(), lines.end(), "<!-- example: persistence -->");
  ASSERT_GT(lines.end() - line, 3);
  line += 2;  // the mark, the fence
  ASSERT_TRUE(line->starts_with("$ ")) << *line;
  std::string command = line->substr(2);
  const std::string program = "build/flowcert";
  ASSERT_NE(command.find(program), std::string::npos) << command;
  command.replace(command.find(program), program.size(), "\"$0\"");
  std::string expected;
  while (++line != lines.end() && *line != "```") expected += *line + "\n";
  EXPECT_EQ(RunningProgram({"/bin/sh", "-c", command, FLOWCERT_PROGRAM}).finish().out, expected);
}

}  // namespace
}  // namespace flowcert::conformance::persistence_command_test
