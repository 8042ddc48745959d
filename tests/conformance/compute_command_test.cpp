// What `flowcert compute` prints and writes, against src/cli/manual/summary.md and spec/formats/stationary_points.md.
//
// Guarantees: the table, the summary and the file of records are read by a JSON parser and checked key by
// key; digests are sha256sum's, and whether a double is the nearest one is decided by the oracle's
// arithmetic, not by the program's.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::compute_command_test {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
// Regular stationary points of kinds 1-2 and 1-3.
constexpr char kFive[] = "0 0 1\n1 0 0\n0 0 0\n1 1 1\n1 0 1\n";
// A regular stationary point of kind 2-3.
constexpr char kKind23[] = "5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n";

json summary_of(const Scratch& scratch, const std::string& points) {
  const Finished finished = flowcert({"compute", scratch.file("points.xyz", points), "--json"});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.out;
  return json::parse(finished.out);
}

struct Written {
  json header;
  std::vector<json> records;
};

Written records_of(const Scratch& scratch, const std::string& points, const std::vector<std::string>& options = {}) {
  const std::string output = scratch.path("records.jsonl");
  std::vector<std::string> words = {"compute", scratch.file("points.xyz", points), "-o", output};
  words.insert(words.end(), options.begin(), options.end());
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  Written written;
  for (const std::string& line : lines_of(content_of(output))) {
    (written.header.is_null() ? written.header : written.records.emplace_back()) = json::parse(line);
  }
  return written;
}

Names keys_of(const json& object) {
  Names keys;
  for (const auto& item : object.items()) keys.insert(item.key());
  return keys;
}

std::string sha256sum(const std::string& path) {
  return RunningProgram({"/usr/bin/sha256sum", path}).finish().out.substr(0, 64);
}

// The bytes that the formats (spec/formats/README.md) hash, hashed by another program.
std::string digest_of(const Scratch& scratch, const std::vector<double>& coordinates) {
  std::string bytes;
  for (const double value : coordinates) {
    unsigned char raw[8];
    std::memcpy(raw, &value, 8);  // little-endian, as all machines of this program
    bytes.append(raw, raw + 8);
  }
  return sha256sum(scratch.file("coordinates", bytes));
}

TEST(ComputeTable, HasARowForEveryCount) {
  CITES("FC-IN-03");
  const Scratch scratch;
  const std::string input = scratch.file("five.xyz", std::string(kFive) + "1 0 1\n");
  const Finished finished = flowcert({"compute", input});
  EXPECT_EQ(finished.status, 0);
  const std::vector<std::string> lines = lines_of(finished.out);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines[0], input + " (table)");
  for (const char* row : {"points +6", "merged duplicates +1", "critical points of index 0 +5 .*",
                          "critical points of index 1 +5 .*", "critical points of index 2 +1 .*",
                          "critical points of index 3 +0 .*", "regular stationary points 1-2 +2( .*)?",
                          "regular stationary points 1-3 +1( .*)?", "regular stationary points 2-3 +0( .*)?",
                          "Euler sum +1", "Delaunay triangulation +[0-9.]+ m?s", "critical points +[0-9.]+ m?s .*",
                          "filter failures, angle +\\d+   of \\d+ calls", "peak memory +[0-9.]+ MiB"}) {
    const auto matches = std::count_if(
        lines.begin(), lines.end(), [&](const std::string& line) { return std::regex_match(line, std::regex(row)); });
    EXPECT_EQ(matches, 1) << row << "\n" << finished.out;
  }
}

TEST(ComputeSummary, HasTheKeysOfTheFormat) {
  CITES("FC-INV-01");
  const Scratch scratch;
  const json summary = summary_of(scratch, kCube);
  EXPECT_EQ(keys_of(summary),
            (Names{"format", "format_version", "version", "commit", "kernel", "compiler", "cgal", "input_sha256",
                   "points", "merged_duplicates", "critical", "regular_stationary", "dimension", "euler", "runs",
                   "seconds", "ratio_to_delaunay", "filters", "peak_memory_bytes"}));
  EXPECT_EQ(summary["format"], "flowcert-summary");
  EXPECT_EQ(summary["format_version"], 1);
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal"}) {
    ASSERT_TRUE(summary[key].is_string()) << key;
    EXPECT_FALSE(summary[key].get<std::string>().empty()) << key;
  }
  EXPECT_EQ(summary["points"], 8);
  EXPECT_EQ(summary["merged_duplicates"], 0);
  EXPECT_EQ(summary["critical"], json({8, 12, 6, 1}));
  EXPECT_EQ(summary["regular_stationary"], json({{"1-2", 0}, {"2-3", 0}, {"1-3", 0}}));
  EXPECT_EQ(summary["dimension"], 3);
  EXPECT_EQ(summary["euler"], 1);
  EXPECT_EQ(summary["runs"], 1);
  EXPECT_EQ(keys_of(summary["seconds"]), (Names{"delaunay", "critical"}));
  EXPECT_EQ(keys_of(summary["ratio_to_delaunay"]), (Names{"critical", "all"}));
  for (const char* key : {"critical", "all"}) {
    ASSERT_TRUE(summary["ratio_to_delaunay"][key].is_number()) << key;
    EXPECT_GT(summary["ratio_to_delaunay"][key].get<double>(), 0) << key;
  }
  for (const json& seconds : summary["seconds"]) EXPECT_GT(seconds.get<double>(), 0);
  EXPECT_FALSE(summary["filters"].empty());
  for (const json& filter : summary["filters"]) {
    EXPECT_EQ(keys_of(filter), (Names{"calls", "failures"}));
    EXPECT_TRUE(filter["calls"].is_number_unsigned());
    EXPECT_LE(filter["failures"].get<std::uint64_t>(), filter["calls"].get<std::uint64_t>());
  }
  EXPECT_GT(summary["peak_memory_bytes"].get<std::uint64_t>(), 1U << 20);
}

struct SmallSet {
  std::string points;
  std::vector<int> critical;
  std::vector<int> regular;  // 1-2, 1-3, 2-3
  int dimension;
  int euler;
};

TEST(ComputeSummary, SmallAndFlatSetsHaveAnAnswer) {
  CITES("FC-IN-04", "FC-IN-05", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-04", "FC-INV-01");
  const SmallSet sets[] = {{"# nothing but a comment\n", {0, 0, 0, 0}, {0, 0, 0}, -1, 0},
                           {"1 2 3\n", {1, 0, 0, 0}, {0, 0, 0}, 0, 1},
                           {"1 2 3\n1 2 3\n", {1, 0, 0, 0}, {0, 0, 0}, 0, 1},
                           {"0 0 0\n1 0 0\n", {2, 1, 0, 0}, {0, 0, 0}, 1, 1},
                           {"0 0 0\n2 0 0\n1 2 0\n", {3, 3, 1, 0}, {0, 0, 0}, 2, 1},
                           {"0 0 0\n3 0 0\n0 4 0\n", {3, 2, 0, 0}, {1, 0, 0}, 2, 1},
                           {"0 0 0\n9 0 0\n1 1 0\n", {3, 2, 0, 0}, {0, 0, 0}, 2, 1},
                           {"0 0 0\n3 3 3\n1 1 1\n2 2 2\n7 7 7\n", {5, 4, 0, 0}, {0, 0, 0}, 1, 1},
                           {"0 0 1\n1 0 1\n0 1 1\n1 1 1\n", {4, 4, 1, 0}, {0, 0, 0}, 2, 1},
                           {kKind23, {4, 6, 3, 0}, {0, 0, 1}, 3, 1},
                           {kFive, {5, 5, 1, 0}, {2, 1, 0}, 3, 1},
                           {"0x1p-1074 0 0\n0 0 0\n0 0x1.fffffffffffffp1023 0\n", {3, 2, 0, 0}, {1, 0, 0}, 2, 1},
                           {"1.7e308 0 0\n-1.7e308 0 0\n", {2, 1, 0, 0}, {0, 0, 0}, 1, 1}};
  const Scratch scratch;
  for (const SmallSet& set : sets) {
    SCOPED_TRACE(set.points);
    const json summary = summary_of(scratch, set.points);
    EXPECT_EQ(summary["critical"], json(set.critical));
    EXPECT_EQ(summary["regular_stationary"],
              json({{"1-2", set.regular[0]}, {"1-3", set.regular[1]}, {"2-3", set.regular[2]}}));
    EXPECT_EQ(summary["dimension"], set.dimension);
    EXPECT_EQ(summary["euler"], set.euler);
    const auto distinct = summary["points"].get<int>() - summary["merged_duplicates"].get<int>();
    for (const json& ratio : summary["ratio_to_delaunay"]) EXPECT_EQ(ratio.is_null(), distinct < 4);
  }
}

TEST(ComputeSummary, RunsAreCounted) {
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube);
  EXPECT_EQ(json::parse(flowcert({"compute", input, "--json", "--runs", "3"}).out)["runs"], 3);
  const Finished finished = flowcert({"compute", input, "--runs", "3"});
  EXPECT_NE(finished.out.find("median of 3 runs"), std::string::npos) << finished.out;
}

TEST(ComputeSummary, TheDigestIsThatOfTheCoordinates) {
  CITES("FC-IN-02", "FC-IN-03", "FC-FILE-30");
  const Scratch scratch;
  // The digest is of the rows before merging, in the file's order. -0.0 counts as 0.0, and what is too small as 0.
  const std::string digest = digest_of(scratch, {0.1, 0.0, 3.0, 0x1p-1074, 0.0, 0x1.8p3, 0.1, 0.0, 3.0});
  const json summary = summary_of(scratch, "0.1 -0.0 3\n0x1p-1074,1e-400,0x1.8p3\n0.1 0 3\n");
  EXPECT_EQ(summary["input_sha256"], digest);
  EXPECT_EQ(records_of(scratch, "0.1 -0.0 3\n0x1p-1074,1e-400,0x1.8p3\n0.1 0 3\n").header["input_sha256"], digest);
  EXPECT_EQ(summary_of(scratch, "# none\n")["input_sha256"], digest_of(scratch, {}));
}

std::string compressed(const Scratch& scratch, const std::string& name, const std::string& content) {
  const std::string path = scratch.path(name);
  const gzFile file = ::gzopen(path.c_str(), "wb");
  EXPECT_EQ(::gzwrite(file, content.data(), static_cast<unsigned>(content.size())), static_cast<int>(content.size()));
  EXPECT_EQ(::gzclose(file), Z_OK);
  return path;
}

TEST(ComputeInput, FormatsAndCompressionDoNotMatter) {
  CITES("FC-IN-02");
  const Scratch scratch;
  const std::string ply_header =
      "element vertex 4\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  std::string binary = "ply\nformat binary_little_endian 1.0\n" + ply_header;
  for (const double value : {5.0, 0.0, 0.0, -3.0, 4.0, 0.0, -3.0, -4.0, 0.0, 0.0, 0.0, 5.0}) {
    char raw[8];
    std::memcpy(raw, &value, 8);
    binary.append(raw, raw + 8);
  }
  const std::string obj = "v 5 0 0\nv -3 4 0\nv -3 -4 0\nv 0 0 5\nf 1 2 3\n";
  const std::string reference = scratch.path("reference.jsonl");
  ASSERT_EQ(flowcert({"compute", scratch.file("a.xyz", kKind23), "-o", reference}).status, 0);
  const std::string inputs[] = {scratch.file("a.off", "OFF\n4 1 0\n" + std::string(kKind23) + "3 0 1 2\n"),
                                scratch.file("a.obj", obj),
                                scratch.file("ascii.ply", "ply\nformat ascii 1.0\n" + ply_header + kKind23),
                                scratch.file("binary.ply", binary),
                                compressed(scratch, "a.xyz.gz", kKind23),
                                compressed(scratch, "a.obj.gz", obj),
                                compressed(scratch, "binary.ply.gz", binary)};
  for (const std::string& input : inputs) {
    const std::string output = scratch.path("out.jsonl");
    const Finished finished = flowcert({"compute", input, "-o", output});
    EXPECT_EQ(finished.status, 0) << input << finished.err;
    EXPECT_EQ(content_of(output), content_of(reference)) << input;
  }
}

// Six classes, one of two and one of three ids; regular stationary points of kinds 1-2 and 1-3.
constexpr char kWithDuplicates[] = "0 0 1\n1 0 0\n0 0 0\n1 0 0\n1 1 1\n1 0 1\n0 0 1\n-0.0 0 1\n";

TEST(ComputeRecords, TheHeaderHasTheKeysOfTheFormat) {
  CITES("FC-IN-03", "FC-FILE-05", "FC-FILE-30");
  const Scratch scratch;
  const json header = records_of(scratch, kWithDuplicates).header;
  EXPECT_EQ(keys_of(header),
            (Names{"format", "format_version", "version", "commit", "kernel", "compiler", "cgal", "input_sha256",
                   "points", "merged_duplicates", "classes", "critical", "regular_stationary"}));
  EXPECT_EQ(header["format"], "flowcert-stationary-points");
  EXPECT_EQ(header["format_version"], 1);
  EXPECT_EQ(header["points"], 8);
  EXPECT_EQ(header["merged_duplicates"], 3);
  EXPECT_EQ(header["classes"], json({{0, 6, 7}, {1, 3}}));
  EXPECT_EQ(header["critical"], json({5, 5, 1, 0}));
  EXPECT_EQ(header["regular_stationary"], json({{"1-2", 2}, {"2-3", 0}, {"1-3", 1}}));
  const std::string version = flowcert({"--version"}).out;
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal"}) {
    EXPECT_NE(version.find(header[key].get<std::string>()), std::string::npos) << key;
  }
  EXPECT_EQ(records_of(scratch, kCube).header["classes"], json::array());
}

// The place of a record's index in the order of FC-OUT-02.
std::size_t rank(const json& index) {
  const json order = {0, 1, 2, 3, {1, 2}, {1, 3}, {2, 3}};
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), index) - order.begin());
}

void expect_exact(const json& text, const json& nearest) {
  const auto rational = oracle::parse_rational(text.get<std::string>());
  ASSERT_TRUE(rational && rational->canonical) << text;
  if (nearest.is_null()) {
    EXPECT_GE(abs(rational->value), oracle::Rational(std::numeric_limits<double>::max())) << text;
  } else {
    EXPECT_TRUE(oracle::is_nearest_double(nearest.get<double>(), rational->value)) << text;
  }
}

void expect_well_formed(const json& record) {
  SCOPED_TRACE(record.dump());
  EXPECT_EQ(keys_of(record), (Names{"index", "kind", "contact", "center", "squared_distance", "center_double",
                                    "squared_distance_double"}));
  EXPECT_LT(rank(record["index"]), 7U);
  EXPECT_EQ(record["kind"], record["index"].is_array() ? "regular" : "critical");
  const auto contact = record["contact"].get<std::vector<std::size_t>>();
  EXPECT_FALSE(contact.empty());
  EXPECT_TRUE(std::is_sorted(contact.begin(), contact.end(), std::less_equal<>()));
  ASSERT_EQ(record["center"].size(), 3U);
  ASSERT_EQ(record["center_double"].size(), 3U);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expect_exact(record["center"][axis], record["center_double"][axis]);
  }
  expect_exact(record["squared_distance"], record["squared_distance_double"]);
}

TEST(ComputeRecords, AreExactAndInOrder) {
  CITES("FC-OUT-01", "FC-OUT-02", "FC-NUM-02", "FC-CRIT-06", "FC-FILE-06");
  const Scratch scratch;
  for (const char* points : {kCube, kWithDuplicates, kKind23, "0.1 0.2 0.3\n1e-300 7 9\n3 1e200 0\n0 0 -5\n",
                             "0x1p-1074 0 0\n0 0 0\n0 0x1p-1074 0x1p-1074\n"}) {
    const Written written = records_of(scratch, points);
    std::size_t announced = 0;
    for (const json& count : written.header["critical"]) announced += count.get<std::size_t>();
    for (const json& count : written.header["regular_stationary"]) announced += count.get<std::size_t>();
    EXPECT_EQ(written.records.size(), announced);
    using Place = std::pair<std::size_t, std::vector<std::size_t>>;
    std::vector<Place> places;
    for (const json& record : written.records) {
      expect_well_formed(record);
      places.emplace_back(rank(record["index"]), record["contact"].get<std::vector<std::size_t>>());
    }
    EXPECT_TRUE(std::is_sorted(places.begin(), places.end(), std::less_equal<>())) << points;
  }
}

TEST(ComputeRecords, TheKnownRecordOfARightTriangle) {
  CITES("FC-OUT-01", "FC-OUT-02", "FC-CRIT-03");
  const Scratch scratch;
  const Written written = records_of(scratch, "0 0 0\n3 0 0\n0 4 0\n0 4 0\n");
  ASSERT_EQ(written.records.size(), 6U);
  EXPECT_EQ(written.records[5], json({{"index", {1, 2}},
                                      {"kind", "regular"},
                                      {"contact", {0, 1, 2}},
                                      {"center", {"3/2", "2", "0"}},
                                      {"squared_distance", "25/4"},
                                      {"center_double", {1.5, 2.0, 0.0}},
                                      {"squared_distance_double", 6.25}}));
}

TEST(ComputeRecords, ADoubleThatWouldOverflowIsNull) {
  CITES("FC-NUM-02", "FC-IN-04");
  const Scratch scratch;
  const Written far = records_of(scratch, "1.7e308 0 0\n-1.7e308 0 0\n");
  ASSERT_EQ(far.records.size(), 3U);
  EXPECT_EQ(far.records[2]["center"], json({"0", "0", "0"}));
  EXPECT_EQ(far.records[2]["center_double"], json({0.0, 0.0, 0.0}));
  EXPECT_TRUE(far.records[2]["squared_distance_double"].is_null());
  expect_well_formed(far.records[2]);
  const oracle::Rational x(1.7e308);
  EXPECT_EQ(far.records[2]["squared_distance"], oracle::Rational(x * x).str());
}

TEST(ComputeRecords, CentersAreExactOrDoublesOrLeftOut) {
  CITES("FC-OUT-01", "FC-NUM-02", "FC-FILE-06");
  const Scratch scratch;
  const std::vector<std::string> manifolds = {"--manifolds", "u2,s2", "--polylines", "--skeletons"};
  const auto written = [&](const char* points, const char* centers, bool with_manifolds) {
    std::vector<std::string> options = {"--centers", centers};
    if (with_manifolds) options.insert(options.end(), manifolds.begin(), manifolds.end());
    return records_of(scratch, points, options);
  };
  for (const char* points : {kCube, kWithDuplicates, kKind23, "1.7e308 0 0\n-1.7e308 0 0\n", "1 2 3\n", "# none\n"}) {
    for (const bool with_manifolds : {false, true}) {
      Written expected = written(points, "exact", with_manifolds);
      EXPECT_FALSE(expected.header.contains("centers"));
      for (const char* centers : {"double", "none"}) {
        expected.header["centers"] = centers;
        for (json& record : expected.records) {
          for (const char* key : {"center", "squared_distance"}) record.erase(key);
          if (centers == std::string("double")) continue;
          for (const char* key : {"center_double", "squared_distance_double"}) record.erase(key);
        }
        const Written found = written(points, centers, with_manifolds);
        EXPECT_EQ(found.header, expected.header);
        EXPECT_EQ(found.records, expected.records) << points;
      }
    }
  }
}

TEST(ComputeRecords, CentersNeedAFileAndAKnownWord) {
  CITES("FC-OUT-01");
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"compute", input, "--centers", "double"},
        std::vector<std::string>{"compute", input, "-o", scratch.path("x.jsonl"), "--centers", "rounded"}}) {
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find("--centers"), std::string::npos) << finished.err;
  }
}

TEST(ComputeRecords, GoToStandardOutputInsteadOfTheTable) {
  CITES("FC-OUT-01", "FC-IN-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kWithDuplicates), file = scratch.path("points.jsonl");
  ASSERT_EQ(flowcert({"compute", input, "-o", file}).status, 0);
  const Finished streamed = flowcert({"compute", input, "-o", "-"});
  EXPECT_EQ(streamed.status, 0) << streamed.err;
  EXPECT_EQ(streamed.out, content_of(file));
  const Finished pairs = flowcert({"persistence", input, "-o", "-"});
  EXPECT_EQ(pairs.status, 0) << pairs.err;
  const std::string diagram = scratch.path("points.pers");
  ASSERT_EQ(flowcert({"persistence", input, "-o", diagram}).status, 0);
  EXPECT_EQ(pairs.out, content_of(diagram));
  for (const char* command : {"compute", "persistence"}) {
    const Finished both = flowcert({command, input, "-o", "-", "--json"});
    EXPECT_EQ(both.status, 2);
    EXPECT_EQ(both.err, "flowcert: -o - and --json would both write to standard output\n");
    EXPECT_EQ(both.out, "");
    const Finished nowhere = flowcert({command, input, "-o", ""});
    EXPECT_EQ(nowhere.status, 2);
    EXPECT_NE(nowhere.err.find("the path is empty"), std::string::npos) << nowhere.err;
  }
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST(ComputeRecords, ASecondRunWritesTheSameBytes) {
  CITES("FC-OUT-02");
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", std::string(kCube) + kWithDuplicates + kKind23);
  const std::string first = scratch.path("first.jsonl"), second = scratch.path("second.jsonl");
  EXPECT_EQ(flowcert({"compute", input, "-o", first}).status, 0);
  EXPECT_EQ(flowcert({"compute", input, "-o", second, "--runs", "3", "--json"}).status, 0);
  EXPECT_FALSE(content_of(first).empty());
  EXPECT_EQ(content_of(first), content_of(second));
}

// All that a record says but its ids and its place. The key is its contact set with the ids mapped.
std::map<std::set<std::size_t>, json> by_contact(const Written& written, const std::vector<std::size_t>& id) {
  std::map<std::set<std::size_t>, json> result;
  for (json record : written.records) {
    std::set<std::size_t> contact;
    for (const json& name : record["contact"]) contact.insert(id.at(name.get<std::size_t>()));
    record.erase("contact");
    EXPECT_TRUE(result.emplace(contact, record).second) << record;
  }
  return result;
}

// There may be more threads than cores, and nothing is said about it.
TEST(ComputeRecords, AreTheSameForAnyNumberOfThreads) {
  CITES("FC-OUT-02");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", lattice_points(4, 2500, 14));
  const auto with = [&](const std::string& threads) {
    const std::string output = scratch.path("records.jsonl");
    const Finished finished = flowcert({"compute", input, "--manifolds", "u2,s2", "-o", output, "--threads", threads});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find("repeated points merged"), std::string::npos);
    return content_of(output);
  };
  const std::string alone = with("1");
  EXPECT_GT(lines_of(alone).size(), 2500U);
  for (const char* threads : {"2", "3", "8", "64"}) EXPECT_EQ(with(threads), alone) << threads;
}

TEST(ComputeRecords, TheOrderOfTheInputOnlyMovesIds) {
  CITES("FC-INV-04", "FC-OUT-02", "FC-VOR-04");
  const Scratch scratch;
  // Cospherical and collinear in many ways: the cube, its centre, and points on its axes.
  const std::vector<std::string> rows = lines_of(std::string(kCube) + "0.5 0.5 0.5\n0.5 0.5 2\n3 0 0\n3 1 0\n");
  const std::size_t n = rows.size();
  std::vector<std::size_t> same(n), id(n);
  std::string straight, shuffled;
  for (std::size_t k = 0; k < n; ++k) {
    same[k] = k;
    id[k] = 5 * k % n;  // row k of the shuffled file is row id[k] of the other
    straight += rows[k] + "\n";
    shuffled += rows[id[k]] + "\n";
  }
  const Written one = records_of(scratch, straight), other = records_of(scratch, shuffled);
  EXPECT_GT(one.records.size(), 2 * n);
  EXPECT_EQ(by_contact(one, same), by_contact(other, id));
}

}  // namespace
}  // namespace flowcert::conformance::compute_command_test
