// `flowcert explain` as a user calls it: what it says in words and in JSON, its exit status, and the forms in
// which a position can be given.
//
// Guarantees: verdicts on positions are compared with what the oracle's exact geometry says of the contact
// set: whether the position lies in its hull, and which point of the hull is nearest.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "oracle/program/read_records.h"
#include "oracle/stationary_points.h"
#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::explain_command_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

// The unit cube, then a far point; ids in the order of the digits z y x.
constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n9 9 9\n";

// A file to ask about.
class Asked {
 public:
  explicit Asked(const std::string& points) : path_(scratch_.file("points.xyz", points)) {}

  [[nodiscard]] Finished text(const std::string& option, const std::string& value) const {
    return flowcert({"explain", path_, option, value});
  }
  // The answer. The exit status is checked against the verdict.
  [[nodiscard]] json as_json(const std::string& option, const std::string& value) const {
    const Finished finished = flowcert({"explain", path_, option, value, "--json"});
    EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.err;
    json answer = json::parse(finished.out, nullptr, false);
    EXPECT_TRUE(answer.is_object()) << finished.out;
    if (!answer.is_object()) return json::object();
    EXPECT_EQ(finished.status, answer["stationary"] == true ? 0 : 1);
    return answer;
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  Scratch scratch_;
  std::string path_;
};

TEST(ExplainCommand, SaysWhatACriticalPointIs) {
  CITES("FC-CRIT-02", "FC-OUT-01");
  const Asked cube(kCube);
  const Finished text = cube.text("--ids", "7,0,1,2,3,4,5,6");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_EQ(text.err, "");
  EXPECT_TRUE(text.out.starts_with("points 7, 0, 1, 2, 3, 4, 5, 6: critical point of index 3\n")) << text.out;
  EXPECT_NE(text.out.find("[FC-CRIT-02]"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("1/2 (0.5), 1/2 (0.5), 1/2 (0.5)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("3/4 (0.75)"), std::string::npos) << text.out;

  const json answer = cube.as_json("--ids", "0,1,2,3");
  EXPECT_EQ(answer["format"], "flowcert-explain");
  EXPECT_EQ(answer["format_version"], 1);
  EXPECT_EQ(answer["input_sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(answer["stationary"], true);
  EXPECT_EQ(answer["index"], 2);
  EXPECT_EQ(answer["kind"], "critical");
  EXPECT_EQ(answer["clause"], "FC-CRIT-02");
  EXPECT_EQ(answer["center"], json({"1/2", "1/2", "0"}));
  EXPECT_EQ(answer["squared_radius"], "1/2");
  EXPECT_EQ(answer["squared_distance"], "1/2");
  EXPECT_EQ(answer["contact"], json({0, 1, 2, 3}));
  EXPECT_EQ(answer["witnesses"], json::array());
  EXPECT_TRUE(answer["driver"].is_null());
  EXPECT_TRUE(answer["reason"].is_string());
}

TEST(ExplainCommand, SaysWhatARegularStationaryPointIs) {
  CITES("FC-CRIT-03");
  const Asked triangle("0 0 0\n3 0 0\n0 4 0\n");
  const Finished text = triangle.text("--ids", "0,1,2");
  EXPECT_EQ(text.status, 0);
  EXPECT_TRUE(text.out.starts_with("points 0, 1, 2: regular stationary point of kind 1-2\n")) << text.out;
  const json answer = triangle.as_json("--at", "3/2,2,0");
  EXPECT_EQ(answer["index"], json({1, 2}));
  EXPECT_EQ(answer["kind"], "regular");
  EXPECT_EQ(answer["clause"], "FC-CRIT-03");
}

TEST(ExplainCommand, NamesTheConditionThatFails) {
  CITES("FC-CRIT-05");
  const Asked points("0 0 0\n4 0 0\n2 1 0\n2 -9 0\n2 9 0\n0 0 0\n");
  // (a) three points of a line have no common sphere.
  const json line = points.as_json("--ids", "2,3,4");
  EXPECT_EQ(line["clause"], "FC-CRIT-05 (a)");
  EXPECT_FALSE(line["witnesses"].empty());
  EXPECT_TRUE(line["center"].is_null());
  EXPECT_TRUE(line["squared_distance"].is_null());
  // (b) 2 lies inside the sphere of 0 and 1.
  const json inside = points.as_json("--ids", "0,1");
  EXPECT_EQ(inside["stationary"], false);
  EXPECT_TRUE(inside["index"].is_null());
  EXPECT_TRUE(inside["kind"].is_null());
  EXPECT_EQ(inside["clause"], "FC-CRIT-05 (b)");
  EXPECT_EQ(inside["witnesses"], json({2}));
  EXPECT_EQ(inside["squared_radius"], "4");
  EXPECT_EQ(inside["squared_distance"], "1");
  const Finished text = points.text("--ids", "0,1");
  EXPECT_EQ(text.status, 1);
  EXPECT_TRUE(text.out.starts_with("points 0, 1: no stationary point\n")) << text.out;
  EXPECT_NE(text.out.find("[FC-CRIT-05 (b)]"), std::string::npos) << text.out;
  // (c) a diagonal of a square.
  const json diagonal = Asked(kCube).as_json("--ids", "0,3");
  EXPECT_EQ(diagonal["clause"], "FC-CRIT-05 (c)");
  EXPECT_EQ(diagonal["witnesses"], json({1, 2}));
  // (d) an obtuse triangle, whose driver is the middle of its longest side.
  const json obtuse = Asked("0 0 0\n4 0 0\n2 1 0\n").as_json("--ids", "0,1,2");
  EXPECT_EQ(obtuse["clause"], "FC-CRIT-05 (d)");
  EXPECT_EQ(obtuse["driver"], json({"2", "0", "0"}));
}

TEST(ExplainCommand, RepeatedPointsGoByTheNameOfTheirClass) {
  CITES("FC-IN-03");
  const Asked points("0 0 0\n4 0 0\n-0.0 0 0\n4 0 0\n");
  EXPECT_EQ(points.as_json("--ids", "2,3,0")["contact"], json({0, 1}));
  EXPECT_EQ(points.as_json("--ids", "3")["contact"], json({1}));
  EXPECT_EQ(points.text("--ids", "2").err, "warning: " + points.path() + ": 2 repeated points merged\n");
}

oracle::Point as_point(const json& center) {
  oracle::Point point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    point[axis] = oracle::parse_rational(center.at(axis).get<std::string>()).value().value;
  }
  return point;
}

// y is the point of conv C nearest to x iff it lies in conv C, and no point of C is on x's side of the plane
// through y that is normal to x - y.
bool is_nearest_of_hull(const oracle::Point& y, const oracle::Point& x, const std::vector<oracle::Point>& c) {
  if (!oracle::face_dimension(c, y)) return false;
  for (const oracle::Point& p : c) {
    if (oracle::dot(oracle::minus(x, y), oracle::minus(p, y)) > 0) return false;
  }
  return true;
}

TEST(ExplainCommand, JudgesPositionsByTheirContactSet) {
  CITES("FC-DIST-01", "FC-DIST-02", "FC-CRIT-01", "FC-CRIT-02", "FC-CRIT-03");
  const std::vector<std::array<double, 3>> rows = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0},
                                                   {2, 2, 3}, {0, 0, 5}, {2, 6, 2}};
  std::string file;
  for (const auto& [x, y, z] : rows) {
    file += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  }
  const Asked asked(file);
  const oracle::PointSet set(rows);
  std::vector<oracle::Point> positions;
  positions.reserve(27);
  for (int k = 0; k < 27; ++k) positions.push_back({2 * (k % 3), 2 * (k / 3 % 3), k / 9});
  for (const oracle::StationaryPoint& s : oracle::stationary_points(rows).stationary) {
    positions.push_back(s.center);
  }
  int stationary = 0;
  for (const oracle::Point& x : positions) {
    const std::string text = x[0].str() + "," + x[1].str() + "," + x[2].str();
    SCOPED_TRACE(text);
    const json answer = asked.as_json("--at", text);
    const std::vector<std::size_t> contact = oracle::contact_set(set, x);
    EXPECT_EQ(answer["contact"], json(contact));
    std::vector<oracle::Point> hull;
    hull.reserve(contact.size());
    for (const std::size_t id : contact) hull.push_back(oracle::exact(rows[id]));
    EXPECT_EQ(answer["squared_distance"], oracle::squared_distance(x, hull[0]).str());
    const auto face = oracle::face_dimension(hull, x);
    EXPECT_EQ(answer["stationary"], face.has_value());
    if (face) {
      ++stationary;
      const int dimension = oracle::affine_dimension(hull);
      EXPECT_EQ(answer["index"], *face == dimension ? json(dimension) : json({*face, dimension}));
      EXPECT_TRUE(answer["driver"].is_null());
    } else {
      EXPECT_EQ(answer["clause"], "FC-CRIT-01");
      EXPECT_TRUE(is_nearest_of_hull(as_point(answer["driver"]), x, hull)) << answer["driver"];
    }
  }
  EXPECT_GT(stationary, 10);
  EXPECT_GT(static_cast<int>(positions.size()) - stationary, 10);
}

TEST(ExplainCommand, PositionsAreDecimalsHexFloatsOrFractions) {
  CITES("FC-IN-02", "FC-NUM-02");
  const Asked cube(kCube);
  const std::pair<const char*, json> positions[] = {{"0.5,0.5,0.5", {"1/2", "1/2", "1/2"}},
                                                    {"1/2,2/4,0x1p-1", {"1/2", "1/2", "1/2"}},
                                                    {" 5e-1 -0.0  +1 ", {"1/2", "0", "1"}},
                                                    {"-1/3,010/4,-6/3", {"-1/3", "5/2", "-2"}},
                                                    // A decimal means the nearest double. A fraction means itself.
                                                    {"0.1,1/10,0", {"3602879701896397/36028797018963968", "1/10", "0"}},
                                                    {"1e-400,0x1.8p1,7", {"0", "3", "7"}}};
  for (const auto& [text, center] : positions) EXPECT_EQ(cube.as_json("--at", text)["center"], center) << text;
}

TEST(ExplainCommand, WhatCannotBeAskedIsStatus2) {
  CITES("FC-IN-01", "FC-IN-02");
  const Asked cube(kCube);
  const std::pair<const char*, const char*> questions[] = {
      {"--at", "nan,0,0"},   {"--at", "0,inf,0"},  {"--at", "0,0,1e309"}, {"--at", "0,0,1/0"},
      {"--at", "0,0"},       {"--at", "0,0,0,0"},  {"--at", "0,,"},       {"--at", ""},
      {"--at", "0,0,x"},     {"--at", "0,0,1/-2"}, {"--at", "0,0,1/2/3"}, {"--at", "0x1p-1075,0,0"},
      {"--at", "0,0,0.5/2"}, {"--ids", "0,9"},     {"--ids", "9"},        {"--ids", "4294967295"},
      {"--ids", "0,-1"},     {"--ids", "0,1.5"},   {"--ids", ""},         {"--ids", "0 1"},
      {"--ids", "010"},      {"--ids", "0x1"},     {"--ids", "true"},     {"--ids", "+1"}};
  for (const auto& [option, value] : questions) {
    const Finished finished = cube.text(option, value);
    EXPECT_EQ(finished.status, 2) << option << " " << value;
    EXPECT_EQ(finished.out, "") << option << " " << value;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(finished.err.starts_with("flowcert: ")) << finished.err;
  }
  const Asked nothing("# no point\n");
  EXPECT_EQ(nothing.text("--at", "0,0,0").status, 2);
  EXPECT_EQ(nothing.text("--ids", "0").status, 2);
}

TEST(ExplainCommand, TheOrderOfArgumentsDoesNotMatter) {
  const Asked cube(kCube);
  const std::string expected = cube.text("--ids", "0,1").out;
  EXPECT_FALSE(expected.empty());
  for (const Words& words : {Words{"explain", "--ids", "0,1", cube.path()}, Words{"explain", "--ids=0,1", cube.path()},
                             Words{"explain", cube.path(), "--ids", "0", "--ids", "1"}}) {
    EXPECT_EQ(flowcert(words).out, expected) << ::testing::PrintToString(words);
  }
  EXPECT_EQ(flowcert({"explain", "--at", "-1,0,0", cube.path()}).status, 1);
}

}  // namespace
}  // namespace flowcert::conformance::explain_command_test
