// `flowcert-oracle orbit` as its users see it: the JSON object, the table, the positions that it takes, and
// what it cannot use.
//
// Guarantees: the orbits were worked out by hand, or are checked against the definitions by the oracle's
// library.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "oracle/orbit.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::oracle_orbit_command_test {
namespace {

using nlohmann::ordered_json;

constexpr char kTriangle[] = "0 0 0\n4 0 0\n0 4 0\n";
constexpr char kTetrahedron[] = "0 0 0\n1 1 0\n1 0 1\n0 1 1\n";

// The one object that is printed for a start among these points.
ordered_json orbit_json(const std::string& points, const std::string& from) {
  const Scratch scratch;
  const Finished finished = flowcert_oracle({"orbit", scratch.file("points.xyz", points), "--from", from, "--json"});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.err, "");
  EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.out;
  return ordered_json::parse(finished.out);
}

std::string orbit_text(const std::string& points, const std::string& from) {
  const Scratch scratch;
  const Finished finished = flowcert_oracle({"orbit", scratch.file("points.xyz", points), "--from", from});
  EXPECT_EQ(finished.status, 0) << finished.err;
  return finished.out;
}

TEST(OracleOrbitCommand, PrintsAnOrbitToInfinity) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-05", "FC-NUM-02");
  // The orbit runs through the cell of the origin, the facet x = 2, and the line of centres over (2,2,0).
  EXPECT_EQ(
      orbit_json(kTriangle, "1,1/2,1").dump(),
      R"({"format":"oracle-orbit","format_version":1,"start":["1","1/2","1"],"segments":[)"
      R"({"type":"C-C-F","driver":["0","0","0"],"end":["2","1","2"],"start_contact":[0],"crossed_contact":[0],"end_contact":[0,1]},)"
      R"({"type":"F-F-E","driver":["2","0","0"],"end":["2","2","4"],"start_contact":[0,1],"crossed_contact":[0,1],"end_contact":[0,1,2]},)"
      R"({"type":"E-E-inf","driver":["2","2","0"],"end":null,"start_contact":[0,1,2],"crossed_contact":[0,1,2],"end_contact":null}],)"
      R"("limit":{"kind":"infinity","index":null,"position":null,"contact":null,"squared_distance":null}})");
}

TEST(OracleOrbitCommand, PrintsAnOrbitToACriticalPoint) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-05", "FC-CRIT-02", "FC-NUM-02");
  EXPECT_EQ(
      orbit_json(kTetrahedron, "1/8,1/8,1/8").dump(),
      R"({"format":"oracle-orbit","format_version":1,"start":["1/8","1/8","1/8"],"segments":[)"
      R"({"type":"C-C-V","driver":["0","0","0"],"end":["1/2","1/2","1/2"],"start_contact":[0],"crossed_contact":[0],"end_contact":[0,1,2,3]}],)"
      R"("limit":{"kind":"critical","index":3,"position":["1/2","1/2","1/2"],"contact":[0,1,2,3],"squared_distance":"3/4"}})");
}

TEST(OracleOrbitCommand, AStationaryStartHasNoSegments) {
  CITES("FC-FLOW-03", "FC-CRIT-03", "FC-CRIT-04");
  EXPECT_EQ(
      orbit_json(kTriangle, "2,2,0").dump(),
      R"({"format":"oracle-orbit","format_version":1,"start":["2","2","0"],"segments":[],)"
      R"("limit":{"kind":"regular","index":[1,2],"position":["2","2","0"],"contact":[0,1,2],"squared_distance":"8"}})");
  const ordered_json minimum = orbit_json("7 8 9\n", "7 8 9");
  EXPECT_EQ(minimum["segments"], ordered_json::array());
  EXPECT_EQ(minimum["limit"].dump(),
            R"({"kind":"critical","index":0,"position":["7","8","9"],"contact":[0],"squared_distance":"0"})");
}

TEST(OracleOrbitCommand, NamesAreThoseOfTheClasses) {
  CITES("FC-IN-03", "FC-FLOW-01");
  const ordered_json orbit = orbit_json("0 0 0\n-0.0 0 0\n4 0 0\n4 0 0\n", "1,1,0");
  EXPECT_EQ(orbit["segments"][0]["end_contact"], (ordered_json{0, 2}));
}

TEST(OracleOrbitCommand, AnObjFileHasTheSameOrbit) {
  CITES("FC-FLOW-01");
  const Scratch scratch;
  const std::string input = scratch.file("points.obj", "o t\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
  const Finished finished = flowcert_oracle({"orbit", "--json", input, "--from", "1,1/2,1"});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.out, orbit_json(kTriangle, "1,1/2,1").dump() + "\n");
}

TEST(OracleOrbitCommand, PositionsAreTakenExactly) {
  CITES("FC-IN-02", "FC-NUM-02");
  const ordered_json expected = {"-1/2", "1/4", "3"};
  for (const char* from : {"-1/2,0.25,3", "-2/4 1/4 6/2", " -0x1p-1,\t+2/8 , 0x1.8p+1 ", "-.5,25e-2,3.0"}) {
    EXPECT_EQ(orbit_json(kTriangle, from)["start"], expected) << from;
  }
  // A decimal means the nearest double, so that a row of the file is a point of the file.
  EXPECT_EQ(orbit_json("0.1 0.2 0.3\n5 5 5\n", "0.1,0.2,0.3")["limit"]["contact"], ordered_json{0});
  EXPECT_EQ(orbit_json("0.1 0.2 0.3\n5 5 5\n", "1/10,0.2,0.3")["limit"]["kind"], "infinity");
  EXPECT_EQ(orbit_json(kTriangle, "1/10,-0.0,1e-400")["start"], (ordered_json{"1/10", "0", "0"}));
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kTriangle);
  EXPECT_EQ(flowcert_oracle({"orbit", input, "--from=-1,-2,-3"}).status, 0);
}

// The numbers of a long orbit on many points, against the definitions.
TEST(OracleOrbitCommand, EverySegmentIsOneOfTheFlow) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-05", "FC-DIST-01", "FC-DIST-02");
  const Scratch scratch;
  std::string rows;
  std::uint64_t state = 1;  // a half sphere, with noise: orbits below it are long
  for (int k = 0; k < 400; ++k) {
    double x[3];
    for (double& coordinate : x) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      coordinate = static_cast<double>(state >> 40) / 8388608.0 - 1;
    }
    rows += std::to_string(x[0]) + " " + std::to_string(x[1]) + " " +
            std::to_string(2 - x[0] * x[0] - x[1] * x[1] + x[2] / 50) + "\n";
  }
  const std::string input = scratch.file("points.xyz", rows);
  const oracle::PointSet set(oracle::read_point_file(input));
  std::size_t longest = 0;
  for (const char* from : {"0.3,0.4,1.5", "-1/3,1/7,1", "0.01,0.9,0.8", "1/2,1/2,9/7"}) {
    const ordered_json orbit = orbit_json(rows, from);
    const auto point = [](const ordered_json& texts) {
      oracle::Point result;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto written = oracle::parse_rational(texts.at(axis).get<std::string>());
        EXPECT_TRUE(written && written->canonical) << texts;
        result[axis] = written->value;
      }
      return result;
    };
    oracle::Point x = point(orbit["start"]);
    longest = std::max(longest, orbit["segments"].size());
    for (const ordered_json& segment : orbit["segments"]) {
      const oracle::FlowSegment expected = *oracle::flow_segment(set, x);
      EXPECT_EQ(segment["type"], oracle::segment_type(set, expected));
      EXPECT_EQ(point(segment["driver"]), expected.driver);
      EXPECT_EQ(segment["start_contact"], expected.start_contact);
      EXPECT_EQ(segment["crossed_contact"], expected.crossed_contact);
      ASSERT_EQ(segment["end"].is_null(), !expected.end);
      EXPECT_EQ(segment["end_contact"].is_null(), !expected.end);
      if (!expected.end) break;
      EXPECT_EQ(segment["end_contact"], expected.end_contact);
      x = point(segment["end"]);
      EXPECT_EQ(x, *expected.end);
    }
    if (orbit["limit"]["kind"] == "infinity") continue;
    EXPECT_FALSE(oracle::flow_segment(set, x));
    EXPECT_EQ(point(orbit["limit"]["position"]), x);
  }
  EXPECT_GE(longest, 5U);
}

TEST(OracleOrbitCommand, TheTableHasARowForEachSegment) {
  CITES("FC-FLOW-02", "FC-FLOW-03");
  const std::vector<std::string> lines = lines_of(orbit_text(kTriangle, "1,1/2,1"));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0], "orbit from 1 1/2 1");
  EXPECT_TRUE(std::regex_match(lines[1], std::regex(" +type +driver +end +contact set of the end")));
  EXPECT_TRUE(std::regex_match(lines[2], std::regex("1 +C-C-F +0 0 0 +2 1 2 +0 1"))) << lines[2];
  EXPECT_TRUE(std::regex_match(lines[3], std::regex("2 +F-F-E +2 0 0 +2 2 4 +0 1 2"))) << lines[3];
  EXPECT_TRUE(std::regex_match(lines[4], std::regex("3 +E-E-inf +2 2 0 +infinity *"))) << lines[4];
  EXPECT_EQ(lines[5], "ends: infinity");
  EXPECT_EQ(orbit_text(kTriangle, "2,2,0"),
            "orbit from 2 2 0\nstays: index 1-2 at 2 2 0 contact 0 1 2 squared_distance 8\n");
  EXPECT_EQ(lines_of(orbit_text(kTetrahedron, "1/8 1/8 1/8")).back(),
            "ends: index 3 at 1/2 1/2 1/2 contact 0 1 2 3 squared_distance 3/4");
  // Long numbers are rounded and marked, also beyond the greatest double.
  const std::string rounded = orbit_text(kTriangle, "1/123456789012,1e308,-0x1p1023");
  EXPECT_TRUE(rounded.starts_with("orbit from ~8.1e-12 ~1e+308 ~-8.98847e+307\n")) << rounded;
}

TEST(OracleOrbitCommand, WhatCannotBeUsedIsStatus2) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kTriangle);
  const auto expect_error = [](const Finished& finished, const std::string& message) {
    EXPECT_EQ(finished.status, 2) << message;
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(finished.err.starts_with("flowcert-oracle: " + message)) << finished.err;
  };
  for (const char* from : {"",         " ",         "1",          "1,2",          "1,2,3,4",
                           "1,,3",     ",1,2",      "1,2,3,",     "1/0,0,0",      "0/0,0,0",
                           "0,1/-2,0", "+-1/2 0 0", "1.5/2,0,0",  "1/2/3,0,0",    "0,nan,0",
                           "0,0,-inf", "1e400,0,0", "-1e309,0,0", "0x1p1024,0,0", "0x1.00000000000001p0,0,0",
                           "x,y,z",    "1,2,3#",    "1;2;3",      "(1,2,3)",      "1,2\n3,4"}) {
    SCOPED_TRACE(from);
    expect_error(flowcert_oracle({"orbit", input, "--from", from}), "--from: ");
    expect_error(flowcert_oracle({"orbit", input, "--json", "--from", from}), "--from: ");
  }
  const std::string nothing = scratch.file("nothing.xyz", "# no point\n");
  expect_error(flowcert_oracle({"orbit", nothing, "--from", "0,0,0"}), nothing + ": there are no points");
  const std::string bad = scratch.file("bad.xyz", "0 0 0\n1 1\n");
  expect_error(flowcert_oracle({"orbit", bad, "--from", "0,0,0"}), bad + ":2: ");
  expect_error(flowcert_oracle({"orbit", input + ".none", "--from", "0,0,0"}), input + ".none: ");
  expect_error(flowcert_oracle({"orbit", input}), "--from");
  expect_error(flowcert_oracle({"orbit", "--from", "0,0,0"}), "INPUT");
}

}  // namespace
}  // namespace flowcert::conformance::oracle_orbit_command_test
