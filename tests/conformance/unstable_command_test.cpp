// `flowcert compute --manifolds u2`: its rows, its keys of the summary and of the records
// (src/cli/manual/summary.md, spec/formats/stationary_points.md), and what it refuses.
//
// Guarantees: every U2 is compared, segment by segment, with the orbit that the oracle's program prints from
// a point of its first segment; every statistic of lengths and types is counted again from the polylines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>

#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::unstable_command_test {
namespace {

using nlohmann::ordered_json;
using oracle::Rational;
using RationalPoint = std::array<Rational, 3>;
using Words = std::vector<std::string>;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
constexpr char kTriangle[] = "0 0 0\n2 0 0\n1 2 0\n";

struct Input {
  std::string name;
  std::string points;
};

std::vector<Input> inputs() {
  return {{"triangle", kTriangle},
          {"square", "0 0 1\n1 0 1\n0 1 1\n1 1 1\n"},
          {"coplanar", "0 0 0\n4 0 0\n0 4 0\n4 4 0\n2 1 0\n1 3 0\n7 2 0\n2 9 0\n"},
          {"cube", kCube},
          {"kind 2-3", "5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n"},
          {"coarse", lattice_points(1, 24, 3)},
          {"fine", lattice_points(2, 16, 7)},
          {"general", lattice_points(3, 14, 1000003)}};
}

ordered_json parsed(const Finished& finished) {
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.out;
  ordered_json answer = ordered_json::parse(finished.out, nullptr, false);
  EXPECT_TRUE(answer.is_object()) << finished.out;
  return answer.is_object() ? answer : ordered_json::object();
}

ordered_json summary_of(const std::string& path, const Words& options = {}) {
  Words words = {"compute", path, "--json", "--manifolds", "u2"};
  words.insert(words.end(), options.begin(), options.end());
  return parsed(flowcert(words));
}

struct Written {
  std::string header;
  std::vector<ordered_json> records;
};

Written records_of(const Scratch& scratch, const std::string& input, const Words& options) {
  const std::string output = scratch.path("records.jsonl");
  Words words = {"compute", input, "-o", output};
  words.insert(words.end(), options.begin(), options.end());
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  Written written;
  for (const std::string& line : lines_of(content_of(output))) {
    if (written.header.empty()) {
      written.header = line;
    } else {
      written.records.push_back(ordered_json::parse(line));
    }
  }
  return written;
}

Words keys_of(const ordered_json& object) {
  Words keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

const Words kPlainKeys = {"kernel",      "search",     "sharing",     "orbits",
                          "to_critical", "to_regular", "to_infinity", "segments_computed"};

TEST(UnstableSummary, HasTheKeysOfTheFormatInTheirOrder) {
  CITES("FC-FLOW-07");
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube);
  const ordered_json summary = summary_of(input);
  EXPECT_EQ(keys_of(summary["seconds"]), (Words{"delaunay", "critical", "u2"}));
  EXPECT_EQ(keys_of(summary["ratio_to_delaunay"]), (Words{"critical", "u2", "all"}));
  for (const ordered_json& seconds : summary["seconds"]) EXPECT_GT(seconds.get<double>(), 0);
  const ordered_json& ratio = summary["ratio_to_delaunay"];
  EXPECT_NEAR(ratio["all"].get<double>(), ratio["critical"].get<double>() + ratio["u2"].get<double>(), 1e-6);
  EXPECT_EQ(keys_of(summary["u2"]), kPlainKeys);
  EXPECT_EQ(summary["u2"]["kernel"], "cascade");
  EXPECT_EQ(summary["u2"]["search"], "binary");
  EXPECT_EQ(summary["u2"]["sharing"], true);

  const ordered_json u2 = summary_of(input, {"--stats"})["u2"];
  Words all = kPlainKeys;
  for (const char* key : {"n_u2", "n_wcc", "census", "primitives", "exact_bytes", "depth"}) all.push_back(key);
  EXPECT_EQ(keys_of(u2), all);
  for (const char* key : {"n_u2", "n_wcc"}) {
    EXPECT_EQ(keys_of(u2[key]), (Words{"count", "mean", "max", "stddev", "mode", "median", "histogram"}));
  }
  EXPECT_EQ(keys_of(u2["census"]), (Words{"V-V-V", "V-E-V", "V-E-inf", "V-F-V", "V-F-E", "V-F-inf", "E-E-V", "E-E-inf",
                                          "E-F-V", "E-F-E", "E-F-inf"}));
  EXPECT_FALSE(u2["primitives"].empty());
  for (const ordered_json& primitive : u2["primitives"]) {
    EXPECT_EQ(keys_of(primitive), (Words{"calls", "failures"}));
    EXPECT_LE(primitive["failures"].get<std::uint64_t>(), primitive["calls"].get<std::uint64_t>());
  }
  EXPECT_EQ(keys_of(u2["exact_bytes"]), (Words{"count", "mean", "max", "histogram"}));
  EXPECT_TRUE(u2["depth"].is_number_unsigned());
}

TEST(UnstableSummary, TheKnownOrbitsOfTheCube) {
  CITES("FC-FLOW-07");
  const Scratch scratch;
  const ordered_json u2 = summary_of(scratch.file("cube.xyz", kCube), {"--stats"})["u2"];
  EXPECT_EQ(u2["orbits"], 12);
  EXPECT_EQ(u2["to_critical"], 6);
  EXPECT_EQ(u2["to_regular"], 0);
  EXPECT_EQ(u2["to_infinity"], 6);
  EXPECT_EQ(
      u2["n_u2"],
      ordered_json::parse(
          R"({"count": 12, "mean": 1.0, "max": 1, "stddev": 0.0, "mode": 1, "median": 1.0, "histogram": [[1, 12]]})"));
  EXPECT_EQ(u2["n_wcc"]["count"], 0);
  for (const auto& [type, count] : u2["census"].items()) {
    EXPECT_EQ(count, type == "E-E-V" || type == "E-E-inf" ? 6 : 0) << type;
  }
}

TEST(UnstableSummary, SmallAndFlatSetsHaveAnAnswer) {
  CITES("FC-IN-04", "FC-FLOW-07");
  const Scratch scratch;
  const std::pair<const char*, int> sets[] = {{"# nothing but a comment\n", 0},
                                              {"1 2 3\n", 0},
                                              {"0 0 0\n1 0 0\n", 0},
                                              {"0 0 0\n3 3 3\n1 1 1\n", 0},
                                              {kTriangle, 2},
                                              {"0 0 1\n1 0 1\n0 1 1\n1 1 1\n", 2},
                                              {"0 0 0\n3 0 0\n0 4 0\n", 0},
                                              {"1.7e308 0 0\n-1.7e308 0 0\n0 1.7e308 1e308\n", 2}};
  for (const auto& [points, orbits] : sets) {
    SCOPED_TRACE(points);
    const ordered_json summary = summary_of(scratch.file("points.xyz", points), {"--stats"});
    const ordered_json& u2 = summary["u2"];
    EXPECT_EQ(u2["orbits"], orbits);
    EXPECT_EQ(u2["to_infinity"], orbits);
    EXPECT_EQ(u2["census"]["E-E-inf"], orbits);
    EXPECT_EQ(u2["n_u2"]["count"], orbits);
    EXPECT_EQ(u2["n_u2"]["mean"], orbits == 0 ? 0.0 : 1.0);
    EXPECT_EQ(summary["ratio_to_delaunay"]["u2"].is_null(), lines_of(points).size() < 4);
  }
}

// What must not depend on how it is computed.
ordered_json answers(const ordered_json& u2) {
  ordered_json result;
  for (const char* key : {"orbits", "to_critical", "to_regular", "to_infinity", "n_u2", "n_wcc", "census"}) {
    result[key] = u2[key];
  }
  return result;
}

TEST(UnstableSummary, SharingKernelAndSearchDoNotMatter) {
  CITES("FC-FLOW-08", "FC-NUM-01");
  const Scratch scratch;
  std::size_t saved = 0;
  for (const Input& input : inputs()) {
    SCOPED_TRACE(input.name);
    const std::string path = scratch.file("points.xyz", input.points);
    const ordered_json shared = summary_of(path, {"--stats"})["u2"];
    for (const Words& options :
         {Words{"--alone"}, Words{"--kernel", "exact"}, Words{"--search", "linear"},
          Words{"--alone", "--kernel", "exact", "--search", "linear"}, Words{"--kernel", "lazy"},
          Words{"--kernel", "cascade"}, Words{"--alone", "--kernel", "cascade", "--search", "linear"}}) {
      SCOPED_TRACE(::testing::PrintToString(options));
      Words all = {"--stats"};
      all.insert(all.end(), options.begin(), options.end());
      const ordered_json u2 = summary_of(path, all)["u2"];
      const auto has = [&](const char* word) {
        return std::find(options.begin(), options.end(), word) != options.end();
      };
      EXPECT_EQ(u2["sharing"], !has("--alone"));
      EXPECT_EQ(u2["kernel"], has("exact") ? "exact" : has("lazy") ? "lazy" : "cascade");
      EXPECT_EQ(u2["search"], has("linear") ? "linear" : "binary");
      EXPECT_EQ(answers(u2), answers(shared));
    }
    const ordered_json alone = summary_of(path, {"--stats", "--alone"})["u2"];
    std::size_t segments = 0;
    for (const ordered_json& count : alone["census"]) segments += count.get<std::size_t>();
    EXPECT_EQ(alone["segments_computed"], segments);
    EXPECT_LE(shared["segments_computed"].get<std::size_t>(), segments);
    saved += segments - shared["segments_computed"].get<std::size_t>();
  }
  EXPECT_GT(saved, 0U);
}

TEST(UnstableSummary, RunsAreCountedAndMeasuredTogether) {
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube);
  EXPECT_EQ(summary_of(input, {"--runs", "3"})["runs"], 3);
  const Finished finished = flowcert({"compute", input, "--manifolds", "u2", "--runs", "3"});
  EXPECT_NE(finished.out.find("median of 3 runs"), std::string::npos) << finished.out;
}

TEST(UnstableTable, HasARowForEveryCount) {
  CITES("FC-FLOW-07");
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube);
  const Finished finished = flowcert({"compute", input, "--manifolds", "u2", "--stats"});
  EXPECT_EQ(finished.err, "");
  const Words lines = lines_of(finished.out);
  for (const char* row :
       {"unstable manifolds U2 +[0-9.]+ m?s   [0-9.]+ x the triangulation", "orbits +12   .*",
        "orbits to critical points +6", "orbits to regular points +0   .*", "orbits to infinity +6",
        "flow segments computed +\\d+", " +count +mean +max +stddev +mode +median",
        "  n_U2, orbits +12 +1\\.00 +1 +0\\.00 +1 +1", "  n_WCC, cascades +0 +0\\.00 +0 +0\\.00 +0 +0",
        "  start +cross V +cross E +cross F", "  V +V-V-V +0 +V-E-V +0 +V-F-V +0", "  E +E-E-V +6 +E-F-V +0",
        "  side_of_ray +\\d+ +\\d+", "bytes of exact coordinates .*", "deepest construction .*: \\d+"}) {
    const auto matches = std::count_if(
        lines.begin(), lines.end(), [&](const std::string& line) { return std::regex_match(line, std::regex(row)); });
    EXPECT_EQ(matches, 1) << row << "\n" << finished.out;
  }
  const Finished plain = flowcert({"compute", input, "--manifolds", "u2"});
  EXPECT_EQ(plain.out.find("n_WCC"), std::string::npos) << plain.out;
}

// Four points are integers near the origin, and four are decimals far from it, whose doubles are long. So the
// numbers have few bytes or many, and the table has the sizes in between.
TEST(UnstableTable, HasTheSizesOfExactNumbers) {
  const Scratch scratch;
  const std::string input =
      scratch.file("points.xyz", "7 2 7\n2 6 1\n6 3 7\n8 8 6\n91.1 99 95.3\n97.9 97.9 90\n99 97.9 99\n99 97.9 95.3\n");
  const Words options = {"--kernel", "exact", "--stats"};
  const ordered_json sizes = summary_of(input, options)["u2"]["exact_bytes"];
  EXPECT_EQ(sizes["histogram"], ordered_json::parse("[[8,1],[16,0],[32,2]]"));
  EXPECT_EQ(sizes["count"], 3);
  const Finished finished = flowcert({"compute", input, "--manifolds", "u2", "--kernel", "exact", "--stats"});
  const Words lines = lines_of(finished.out);
  const auto title = std::ranges::find(lines, "  from  numbers");
  ASSERT_GT(lines.end() - title, 3) << finished.out;
  EXPECT_EQ(title[1], "     8        1");
  EXPECT_EQ(title[2], "    16        0");
  EXPECT_EQ(title[3], "    32        2");
}

TEST(UnstableRecords, OnlyGainKeys) {
  CITES("FC-OUT-01", "FC-OUT-02", "FC-FLOW-07", "FC-FILE-07");
  const Scratch scratch;
  for (const Input& input : inputs()) {
    SCOPED_TRACE(input.name);
    const std::string path = scratch.file("points.xyz", input.points);
    const Written plain = records_of(scratch, path, {});
    const Written more = records_of(scratch, path, {"--manifolds", "u2"});
    const Written most = records_of(scratch, path, {"--manifolds", "u2", "--polylines"});
    EXPECT_EQ(more.header, plain.header);
    EXPECT_EQ(most.header, plain.header);
    ASSERT_EQ(more.records.size(), plain.records.size());
    ASSERT_EQ(most.records.size(), plain.records.size());
    for (std::size_t i = 0; i < plain.records.size(); ++i) {
      ordered_json expected = plain.records[i];
      if (expected["index"] == 1) expected["samples"] = expected["contact"];
      if (expected["index"] == 2) expected["limits"] = more.records[i]["limits"];
      EXPECT_EQ(more.records[i].dump(), expected.dump());
      if (expected["index"] == 2) expected["u2"] = most.records[i]["u2"];
      EXPECT_EQ(most.records[i].dump(), expected.dump());
    }
    // The oracle reads the file all the same.
    EXPECT_EQ(flowcert_oracle({"certify", path, scratch.path("records.jsonl")}).status, 0);
  }
}

TEST(UnstableRecords, ASecondRunWritesTheSameBytes) {
  CITES("FC-OUT-02", "FC-FLOW-08");
  const Scratch scratch;
  const std::string path = scratch.file("points.xyz", lattice_points(1, 24, 3));
  const Words base = {"compute", path, "--manifolds", "u2", "--polylines", "-o"};
  std::string first;
  for (const Words& options : {Words{}, Words{"--alone"}, Words{"--runs", "2", "--kernel", "exact"}}) {
    Words words = base;
    words.push_back(scratch.path("records.jsonl"));
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(flowcert(words).status, 0);
    const std::string content = content_of(scratch.path("records.jsonl"));
    EXPECT_FALSE(content.empty());
    if (first.empty()) first = content;
    EXPECT_EQ(content, first);
  }
}

RationalPoint point_of(const ordered_json& texts) {
  RationalPoint point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    point[axis] = oracle::parse_rational(texts.at(axis).get<std::string>()).value().value;
  }
  return point;
}

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::vector<RationalPoint> rows_of(const std::string& points) {
  std::vector<RationalPoint> rows;
  for (const std::string& line : lines_of(points)) {
    std::istringstream in(line);
    double x = 0, y = 0, z = 0;
    in >> x >> y >> z;
    rows.push_back({Rational(x), Rational(y), Rational(z)});
  }
  return rows;
}

// (b-a) x (c-a) for the first three contact points, or its opposite for side 0.
RationalPoint side_direction(const ordered_json& record, const std::vector<RationalPoint>& rows, std::size_t side) {
  const auto contact = record["contact"].get<std::vector<std::size_t>>();
  const RationalPoint& a = rows.at(contact.at(0));
  const RationalPoint up = cross(minus(rows.at(contact.at(1)), a), minus(rows.at(contact.at(2)), a));
  return side == 1 ? up : RationalPoint{-up[0], -up[1], -up[2]};
}

// A point inside an orbit's first segment: halfway, or one step along its endless edge.
std::string inside_first(const ordered_json& record, const ordered_json& first, const RationalPoint& along) {
  const RationalPoint from = point_of(record["center"]);
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational x = first["end"].is_null() ? Rational(from[axis] + along[axis])
                                              : Rational((from[axis] + point_of(first["end"])[axis]) / 2);
    // The text is a fraction, because a decimal would be rounded.
    text += x.str();
    if (denominator(x) == 1) text += "/1";
    if (axis < 2) text += ",";
  }
  return text;
}

// Compares an orbit that leaves a saddle with the oracle's orbit from a point of its first segment.
void expect_oracles_orbit(const std::string& path, const ordered_json& record, const std::vector<RationalPoint>& rows,
                          std::size_t side) {
  SCOPED_TRACE(record["contact"].dump() + " side " + std::to_string(side));
  const ordered_json& segments = record["u2"].at(side);
  ASSERT_FALSE(segments.empty());
  const ordered_json& first = segments[0];
  EXPECT_TRUE(first["type"] == "E-E-V" || first["type"] == "E-E-inf") << first;
  EXPECT_EQ(first["driver"], record["center"]);
  const RationalPoint along = side_direction(record, rows, side);
  if (!first["end"].is_null()) {
    const RationalPoint way = minus(point_of(first["end"]), point_of(record["center"]));
    EXPECT_GT(dot(way, along), 0);
    EXPECT_EQ(cross(way, along), RationalPoint{});
  }
  const ordered_json judged =
      parsed(flowcert_oracle({"orbit", path, "--from", inside_first(record, first, along), "--json"}));
  ASSERT_EQ(judged["segments"].size(), segments.size());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (const char* key : {"type", "driver", "end"}) {
      EXPECT_EQ(segments[k][key], judged["segments"][k][key]) << k << " " << key;
    }
  }
  EXPECT_EQ(record["limits"][side], judged["limit"]["contact"]);
}

TEST(UnstableRecords, AreTheOraclesOrbits) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07", "FC-FLOW-08");
  const Scratch scratch;
  std::size_t orbits = 0;
  for (const Input& input : inputs()) {
    SCOPED_TRACE(input.name);
    const std::string path = scratch.file("points.xyz", input.points);
    const std::vector<RationalPoint> rows = rows_of(input.points);
    for (const ordered_json& record : records_of(scratch, path, {"--manifolds", "u2", "--polylines"}).records) {
      if (record["index"] != 2) continue;
      for (const std::size_t side : {0U, 1U}) expect_oracles_orbit(path, record, rows, side);
      orbits += 2;
    }
  }
  EXPECT_GT(orbits, 100U);
}

// Adds the lengths of the maximal runs of segments that end at a constructed point.
void add_cascades(const ordered_json& segments, std::vector<std::size_t>& lengths) {
  bool in_run = false;
  for (const ordered_json& segment : segments) {
    const bool constructs = segment["type"].get<std::string>().substr(1) == "-F-E";
    if (constructs && !in_run) lengths.push_back(0);
    if (constructs) ++lengths.back();
    in_run = constructs;
  }
}

void expect_distribution(const ordered_json& claimed, std::vector<std::size_t> values) {
  ASSERT_EQ(claimed["count"], values.size());
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  const double mean = static_cast<double>(std::accumulate(values.begin(), values.end(), std::size_t{0})) / n;
  double squares = 0;
  std::map<std::size_t, std::size_t> times;
  for (const std::size_t value : values) {
    squares += (static_cast<double>(value) - mean) * (static_cast<double>(value) - mean);
    ++times[value];
  }
  ordered_json histogram = ordered_json::array();
  for (const auto& [value, count] : times) histogram.push_back({value, count});
  EXPECT_EQ(claimed["histogram"], histogram);
  const auto mode =
      std::max_element(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const std::size_t low = values[(values.size() - 1) / 2], high = values[values.size() / 2];
  EXPECT_NEAR(claimed["mean"].get<double>(), mean, 1e-9 * mean);
  EXPECT_NEAR(claimed["stddev"].get<double>(), std::sqrt(squares / n), 1e-9 * mean);
  EXPECT_EQ(claimed["max"], values.back());
  EXPECT_EQ(claimed["mode"], mode->first);
  EXPECT_EQ(claimed["median"].get<double>(), static_cast<double>(low + high) / 2);
}

TEST(UnstableStatistics, AreThoseOfThePolylines) {
  CITES("FC-FLOW-02", "FC-FLOW-07", "FC-FLOW-08");
  const Scratch scratch;
  std::size_t cascades = 0, regular_limits = 0;
  for (const Input& input : inputs()) {
    SCOPED_TRACE(input.name);
    const std::string path = scratch.file("points.xyz", input.points);
    const ordered_json u2 = summary_of(path, {"--stats"})["u2"];
    std::map<std::string, std::size_t> census;
    std::vector<std::size_t> n_u2, n_wcc;
    std::size_t to_critical = 0, to_regular = 0, to_infinity = 0;
    const Written written = records_of(scratch, path, {"--manifolds", "u2", "--polylines"});
    std::map<std::string, bool> is_critical;
    for (const ordered_json& record : written.records) {
      is_critical[record["contact"].dump()] = record["kind"] == "critical";
    }
    for (const ordered_json& record : written.records) {
      if (record["index"] != 2) continue;
      for (const std::size_t side : {0U, 1U}) {
        const ordered_json& segments = record["u2"][side];
        n_u2.push_back(segments.size());
        add_cascades(segments, n_wcc);
        for (const ordered_json& segment : segments) ++census[segment["type"].get<std::string>()];
        const ordered_json& limit = record["limits"][side];
        ++(limit.is_null() ? to_infinity : is_critical.at(limit.dump()) ? to_critical : to_regular);
      }
    }
    expect_distribution(u2["n_u2"], n_u2);
    expect_distribution(u2["n_wcc"], n_wcc);
    EXPECT_EQ(u2["to_critical"], to_critical);
    EXPECT_EQ(u2["to_regular"], to_regular);
    EXPECT_EQ(u2["to_infinity"], to_infinity);
    for (const auto& [type, count] : u2["census"].items()) EXPECT_EQ(count, census[type]) << type;
    EXPECT_EQ(u2["census"].size(), 11U);
    cascades += n_wcc.size();
    regular_limits += to_regular;
  }
  EXPECT_GT(cascades, 10U);
  EXPECT_GT(regular_limits, 0U);
}

TEST(UnstableStatistics, TheHistogramOfBytesAddsUp) {
  const Scratch scratch;
  const std::string path = scratch.file("points.xyz", lattice_points(3, 14, 1000003));
  const ordered_json bytes = summary_of(path, {"--stats", "--kernel", "exact"})["u2"]["exact_bytes"];
  std::size_t numbers = 0, last = 0;
  for (const ordered_json& bin : bytes["histogram"]) {
    ASSERT_EQ(bin.size(), 2U);
    const auto from = bin[0].get<std::size_t>();
    EXPECT_EQ(from & (from - 1), 0U) << "no power of two";
    EXPECT_TRUE(last == 0 || from == 2 * last) << last << " " << from;
    last = from;
    numbers += bin[1].get<std::size_t>();
  }
  EXPECT_EQ(bytes["count"], numbers);
  if (numbers > 0) {
    EXPECT_LE(last, bytes["max"].get<std::size_t>());
    EXPECT_GT(2 * last, bytes["max"].get<std::size_t>());
  }
}

TEST(UnstableUsage, OptionsThatMeanNothingAreStatus2) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle), output = scratch.path("out.jsonl");
  const Words usages[] = {{"--stats"},
                          {"--alone"},
                          {"--kernel", "lazy"},
                          {"--search", "linear"},
                          {"--polylines", "-o", output},
                          {"--polylines", "--manifolds", "u2"},
                          {"--manifolds"},
                          {"--manifolds", "u9"},
                          {"--manifolds", ""},
                          {"--manifolds", "u2", "--kernel", "fast"},
                          {"--manifolds", "u2", "--search", "0"}};
  for (const Words& usage : usages) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    Words words = {"compute", input};
    words.insert(words.end(), usage.begin(), usage.end());
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(finished.err.ends_with("(see flowcert compute --help)\n")) << finished.err;
  }
  EXPECT_EQ(scratch.names(), (std::set<std::string>{"a.xyz"}));
}

}  // namespace
}  // namespace flowcert::conformance::unstable_command_test
