// `flowcert compute --manifolds all` as a user calls it: λ-lists, connections and volumes in the file of records, the
// summary and the table (spec/formats/stationary_points.md, src/cli/manual/summary.md), and what it refuses.
//
// Guarantees: the expected numbers are worked out by hand, or are the oracle's.
#include <gtest/gtest.h>

#include "oracle/stable_pieces.h"
#include "oracle/unstable_set.h"
#include "tests/cites.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/written_complex.h"

namespace flowcert::conformance::whole_complex_command_test {
namespace {

using Names = std::set<std::string>;

Names keys_of(const json& object) {
  Names keys;
  for (const auto& item : object.items()) keys.insert(item.key());
  return keys;
}

// By contact sets, of those that are positive.
std::map<json, std::string> volumes_of(const Written& file) {
  std::map<json, std::string> volumes;
  for (const json& record : file.records) {
    if (record["volume"] != "0") volumes[record["contact"]] = record["volume"];
  }
  return volumes;
}

TEST(WholeComplex, KnownVolumes) {
  CITES("FC-VOL-01");
  using Volumes = std::map<json, std::string>;
  for (const auto& [points, hull, expected] :
       {std::tuple(kCube, "1", Volumes{{{0, 1, 2, 3, 4, 5, 6, 7}, "1"}}),
        std::tuple(kOctahedron, "4/3", Volumes{{{0, 1, 2, 3, 4, 5}, "4/3"}}),
        std::tuple(kHalfOctahedron, "2/3", Volumes{{{0, 1, 2, 3, 4}, "2/3"}}),
        std::tuple(kPyramid, "4", Volumes{{{0, 1, 2, 3, 4}, "4"}}),
        std::tuple(kChain, "1/3", Volumes{{{0, 1, 2, 3}, "1/6"}, {{1, 2, 3, 4}, "1/6"}}),
        std::tuple(kSaddleToSaddle, "140", Volumes{{{0, 3, 4}, "50"}, {{0, 1, 3, 4}, "45"}, {{0, 2, 3, 4}, "45"}}),
        std::tuple("0 0 0\n3 0 0\n0 4 0\n", "0", Volumes{}), std::tuple("1 2 3\n", "0", Volumes{}),
        std::tuple("# none\n", "0", Volumes{})}) {
    const Written file = written(points);
    EXPECT_EQ(file.header["hull_volume"], hull) << points;
    EXPECT_EQ(volumes_of(file), expected) << points;
  }
}

TEST(WholeComplex, EveryRecordHasAVolumeAndSharesAddUpToIt) {
  CITES("FC-VOL-01", "FC-NUM-02");
  for (const std::string& points : {std::string(kSaddleToSaddle), lattice_points(7, 25, 5), lattice_points(8, 25, 9)}) {
    std::size_t with_shares = 0;
    for (const json& record : written(points).records) {
      SCOPED_TRACE(record.dump());
      const oracle::Rational volume = rational(record.at("volume"));
      EXPECT_TRUE(oracle::is_nearest_double(record.at("volume_double"), volume));
      ASSERT_EQ(record.contains("shares"), volume > 0);
      if (volume == 0) continue;
      ++with_shares;
      oracle::Rational sum = 0;
      long before = -1;
      for (const json& share : record["shares"]) {
        EXPECT_GT(share[0].get<long>(), before);
        EXPECT_GT(rational(share[1]), 0);
        before = share[0];
        sum += rational(share[1]);
      }
      EXPECT_EQ(sum, volume);
    }
    EXPECT_GT(with_shares, 0U);
  }
  EXPECT_EQ(written(kCube).of({0, 1, 2, 3, 4, 5, 6, 7})["shares"],
            json::parse(R"([[0,"1/8"],[1,"1/8"],[2,"1/8"],[3,"1/8"],[4,"1/8"],[5,"1/8"],[6,"1/8"],[7,"1/8"]])"));
}

TEST(WholeComplex, TheListOfAnEdgeOfTheCube) {
  CITES("FC-UNST-01", "FC-UNST-02", "FC-FILE-10");
  const json record = written(kCube).of({0, 1});
  EXPECT_EQ(record["lambda"], json::parse(R"({"directions":[
      {"exit":["1/2","0","1/2"],"exit_double":[0.5,0.0,0.5],"limit":[0,1,4,5]},
      {"exit":["1/2","1/2","0"],"exit_double":[0.5,0.5,0.0],"limit":[0,1,2,3]}],
      "arcs":[null,[0,1,2,3,4,5,6,7]]})"));
  EXPECT_EQ(record["connections"], json::parse(R"([{"to":[0,1,2,3],"orbits":1,"families":0},
      {"to":[0,1,4,5],"orbits":1,"families":0},{"to":[0,1,2,3,4,5,6,7],"orbits":0,"families":1},
      {"to":null,"orbits":0,"families":1}])"));
}

TEST(WholeComplex, ListsThatAreNoCycleOrHaveNoDirection) {
  CITES("FC-UNST-01", "FC-UNST-02");
  EXPECT_EQ(written("0 0 0\n1 0 0\n").of({0, 1})["lambda"], json::parse(R"({"directions":[],"arcs":[null]})"));
  const Written chain = written(kChain);
  EXPECT_EQ(chain.of({0, 1, 2})["lambda"], json::parse(R"({"directions":[
      {"vector":["0","0","-1"],"vector_double":[0.0,0.0,-1.0],"limit":null},
      {"exit":["1/2","1/2","1/2"],"exit_double":[0.5,0.5,0.5],"limit":[0,1,2,3]}],"arcs":[null]})"));
  EXPECT_EQ(chain.of({0, 1, 2, 3})["connections"], json::parse(R"([{"to":null,"orbits":0,"families":1}])"));
  EXPECT_EQ(written(kHalfOctahedron).of({0, 1, 2, 3, 4})["lambda"], json::parse(R"({"directions":[
      {"vector":["0","0","-1"],"vector_double":[0.0,0.0,-1.0],"limit":null}],"arcs":[]})"));
}

// Side 0 of {0,1,2} is below it: the ray never leaves its Voronoi edge.
TEST(WholeComplex, ASaddleThatFlowsToASaddle) {
  CITES("FC-UNST-02", "FC-FLOW-07");
  const json record = written(kSaddleToSaddle).of({0, 1, 2});
  EXPECT_EQ(record["limits"], json::parse("[null,[0,3,4]]"));
  EXPECT_EQ(record["lambda"], json::parse(R"({"directions":[
      {"vector":["0","2/5","-1"],"vector_double":[0.0,0.4,-1.0],"limit":null},
      {"exit":["0","0","3"],"exit_double":[0.0,0.0,3.0],"limit":[0,3,4]}],"arcs":[]})"));
  EXPECT_EQ(record["connections"], json::parse(R"([{"to":[0,3,4],"orbits":1,"families":0},
                                                   {"to":null,"orbits":1,"families":0}])"));
}

TEST(WholeComplex, WhetherTheInputIsMorseSmale) {
  CITES("FC-CONN-03", "FC-CRIT-03", "FC-STAB-06");
  for (const char* points : {kCube, kOctahedron, kPyramid, "0 0 0\n4 0 0\n1 3 0\n", "1 2 3\n", "# none\n"}) {
    EXPECT_EQ(written(points).header["morse_smale"], true) << points;
  }
  for (const char* points : {kSaddleToSaddle, kHalfOctahedron, kChain, "0 0 0\n3 0 0\n0 4 0\n"}) {
    EXPECT_EQ(written(points).header["morse_smale"], false) << points;
  }
}

// ---- Against the oracle ----

using Way = std::pair<oracle::Point, json>;  // a direction, scaled, and its limit

oracle::Point scaled(oracle::Point vector) {
  oracle::Rational largest = 0;
  for (const oracle::Rational& x : vector) largest = std::max(largest, oracle::Rational(abs(x)));
  for (oracle::Rational& x : vector) x /= largest;
  return vector;
}

json limit_field(const std::optional<oracle::StationaryPoint>& limit) {
  return limit ? json(limit->contact) : json(nullptr);
}

void expect_list_of_oracle(const json& record, const oracle::PointSet& set, const oracle::StationaryPoint& y) {
  SCOPED_TRACE(record.dump());
  std::vector<Way> ways, expected;
  std::vector<json> arcs = record["lambda"]["arcs"], expected_arcs;
  for (const json& direction : record["lambda"]["directions"]) {
    const bool is_vector = direction.contains("vector");
    const oracle::Point way =
        is_vector ? position(direction["vector"]) : oracle::minus(position(direction["exit"]), y.center);
    EXPECT_TRUE(!is_vector || way == scaled(way));
    ways.emplace_back(scaled(way), direction["limit"]);
  }
  for (const oracle::UnstableEntry& entry : oracle::lambda_list(set, y)) {
    if (entry.is_arc) {
      expected_arcs.push_back(limit_field(entry.limit));
    } else {
      expected.emplace_back(*entry.from, limit_field(entry.limit));
    }
  }
  // The oracle's cycle begins elsewhere.
  if (!ways.empty() && y.face_dimension == 1 && y.hull_dimension == 1) {
    const auto first = std::find(expected.begin(), expected.end(), ways.front());
    ASSERT_NE(first, expected.end());
    std::rotate(expected_arcs.begin(), expected_arcs.begin() + (first - expected.begin()), expected_arcs.end());
    std::rotate(expected.begin(), first, expected.end());
  }
  EXPECT_EQ(ways, expected);
  EXPECT_EQ(arcs, expected_arcs);
}

// A cycle begins with its least exit.
void expect_right_begin(const json& record) {
  const json& directions = record["lambda"]["directions"];
  if (record["index"] != 1 || directions.empty()) return;
  for (const json& direction : directions) {
    EXPECT_LE(position(directions[0]["exit"]), position(direction["exit"])) << record;
  }
}

// Directions beside an arc of their own limit belong to it.
void expect_connections_of_list(const json& record) {
  const json &directions = record["lambda"]["directions"], &arcs = record["lambda"]["arcs"];
  std::map<json, std::pair<std::size_t, std::size_t>> expected, found;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const json& limit = directions[i]["limit"];
    const bool is_cycle = record["index"] == 1;
    const bool is_before_arc = i < arcs.size() && arcs[i] == limit;
    const bool is_after_arc = (i > 0 && i - 1 < arcs.size() && arcs[i - 1] == limit) ||
                              (i == 0 && is_cycle && arcs[arcs.size() - 1] == limit);
    if (!is_before_arc && !is_after_arc) ++expected[limit].first;
  }
  for (const json& limit : arcs) ++expected[limit].second;
  for (const json& one : record["connections"]) found[one["to"]] = {one["orbits"], one["families"]};
  EXPECT_EQ(found, expected) << record;
  EXPECT_EQ(record["connections"].size(), expected.size()) << "none is listed twice";
}

TEST(WholeComplex, ListsAndVolumesAreTheOracles) {
  CITES("FC-UNST-01", "FC-UNST-02", "FC-UNST-03", "FC-CONN-01", "FC-VOL-01", "FC-OUT-01");
  std::size_t lists = 0, positive = 0;
  for (const std::string& points :
       {std::string(kCube), std::string(kChain), std::string(kHalfOctahedron), std::string(kSaddleToSaddle),
        lattice_points(1, 9, 3), lattice_points(2, 10, 4), lattice_points(3, 11, 6), lattice_points(4, 12, 30)}) {
    const oracle::PointSet set(rows_of(points));
    const oracle::Answer truth = oracle::stationary_points(set);
    const Written file = written(points);
    ASSERT_EQ(file.records.size(), truth.stationary.size());
    for (std::size_t i = 0; i < file.records.size(); ++i) {
      const oracle::StationaryPoint& y = truth.stationary[i];
      const json& record = file.records[i];
      ASSERT_EQ(record["contact"], y.contact);
      ASSERT_EQ(record.contains("lambda"), y.face_dimension == 1 || y.face_dimension == 2);
      ASSERT_EQ(record.contains("connections"), record.contains("lambda"));
      EXPECT_EQ(rational(record["volume"]), oracle::volume(set, oracle::stable_set(set, y))) << record;
      positive += record["volume"] != "0" ? 1 : 0;
      if (!record.contains("lambda")) continue;
      ++lists;
      expect_list_of_oracle(record, set, y);
      expect_right_begin(record);
      expect_connections_of_list(record);
    }
  }
  EXPECT_GT(lists, 150U);
  EXPECT_GT(positive, 20U);
}

// ---- What options leave out ----

TEST(WholeComplex, RecordsHaveAllKeysOfBothManifoldsAndTheirOwn) {
  CITES("FC-OUT-01", "FC-FILE-09");
  const Scratch scratch;
  const std::vector<std::string> others = {"--manifolds", "u2,s2", "--polylines", "--skeletons"};
  for (const char* points : {kSaddleToSaddle, kChain, kHalfOctahedron}) {
    std::string without;
    for (const std::string& line : lines_of(
             file_of(scratch, points, {"--manifolds", "all", "--volumes", "exact", "--polylines", "--skeletons"}))) {
      auto record = nlohmann::ordered_json::parse(line);
      if (record.contains("kind") && record["kind"] == "infinity") continue;
      for (const char* key :
           {"lambda", "connections", "volume", "volume_double", "shares", "morse_smale", "hull_volume", "volumes"}) {
        record.erase(key);
      }
      if (record.contains("index") && record["index"] == 3) record.erase("skeleton");
      without += record.dump() + '\n';
    }
    EXPECT_EQ(without, file_of(scratch, points, others));
  }
}

// The two sectors beside each of the twelve edges are triangles, with a corner in the middle of the cube.
TEST(WholeComplex, MaximaHaveSkeletonsThatAreJudged) {
  CITES("FC-STAB-05", "FC-CLAIM-10");
  const Scratch scratch;
  const std::string text = file_of(scratch, kCube, {"--manifolds", "all", "--skeletons", "--volumes", "exact"});
  std::vector<std::string> lines = lines_of(text);
  json record;
  std::size_t at = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const json next = json::parse(lines[k]);
    if (next.contains("index") && next["index"] == 3) at = k, record = next;
  }
  const json& skeleton = record["skeleton"];
  EXPECT_EQ(skeleton["segments"].size(), 12U);
  EXPECT_EQ(skeleton["intervals"].size(), 6U);
  EXPECT_EQ(skeleton["sectors"].size(), 24U);
  EXPECT_FALSE(skeleton.contains("orbits"));
  const auto check = [&](const json& changed) {
    lines[at] = changed.dump();
    std::string file;
    for (const std::string& line : lines) file += line + "\n";
    return flowcert({"check", scratch.file("cube.xyz", kCube), scratch.file("claim.jsonl", file)});
  };
  EXPECT_EQ(check(record).status, 0);
  for (const char* part : {"segments", "intervals", "sectors"}) {
    json less = record;
    less["skeleton"][part].erase(3);
    const Finished finished = check(less);
    EXPECT_EQ(finished.status, 1) << part << finished.out;
  }
}

// Three samples of a right triangle. The three facets are half planes.
TEST(WholeComplex, TheLastLineTellsWhatFlowsToInfinity) {
  CITES("FC-STAB-08", "FC-CLAIM-16", "FC-OUT-01", "FC-FILE-09");
  const Scratch scratch;
  const std::string points = "0 0 0\n4 0 0\n0 4 0\n";
  std::vector<std::string> lines = lines_of(file_of(scratch, points, {"--manifolds", "all", "--skeletons"}));
  EXPECT_EQ(lines.size(), 1 + 3 + 2 + 1 + 1U);
  const json infinity = json::parse(lines.back());
  EXPECT_EQ(infinity["kind"], "infinity");
  EXPECT_FALSE(infinity.contains("index"));
  const json& skeleton = infinity["skeleton"];
  for (const char* part : {"segments", "intervals", "sectors"}) EXPECT_TRUE(skeleton[part].empty()) << part;
  // Each facet has one ray straight out, and those beside acute corners one up and one down, too.
  EXPECT_EQ(skeleton["unbounded_segments"].size(), 3 + 2 * 2U);
  EXPECT_EQ(skeleton["unbounded_segments"][0],
            json::parse(R"({"samples":[0,1],"vector":["0","-1","0"],"back":["2","0","0"],"back_contact":[0,1],)"
                        R"("back_kind":"critical"})"));
  EXPECT_EQ(
      skeleton["unbounded_intervals"],
      json::parse(R"([{"polygon":[0,1,2],"vector":["0","0","-1"],"back":["2","2","0"],"back_is_stationary":true},)"
                  R"({"polygon":[0,1,2],"vector":["0","0","1"],"back":["2","2","0"],"back_is_stationary":true}])"));
  // Two beside each ray straight out, and two beside each interval.
  EXPECT_EQ(skeleton["unbounded_sectors"].size(), 3 * 2 + 2 * 2U);
  EXPECT_EQ(skeleton["unbounded_sectors"][0],
            json::parse(R"({"samples":[0,1],"corners":[["2","0","0"],["2","2","0"],{"vector":["0","0","-1"]}]})"));
  EXPECT_EQ(skeleton["unbounded_sectors"][2],
            json::parse(R"({"samples":[0,1],"corners":[["2","0","0"],{"vector":["0","-1","0"]},)"
                        R"({"vector":["0","0","-1"]}]})"));
  const auto check = [&](const json& last) {
    lines.back() = last.dump();
    std::string file;
    for (const std::string& line : lines) file += line + "\n";
    return flowcert({"check", scratch.file("points.xyz", points), scratch.file("claim.jsonl", file)});
  };
  EXPECT_EQ(check(infinity).status, 0);
  for (const char* part : {"unbounded_segments", "unbounded_intervals", "unbounded_sectors"}) {
    json less = infinity;
    less["skeleton"][part].erase(1);
    const Finished finished = check(less);
    EXPECT_EQ(finished.status, 1) << part;
    EXPECT_NE(finished.out.find("FC-CLAIM-16"), std::string::npos) << finished.out;
  }
  const std::vector<std::string> without = lines_of(file_of(scratch, points, {"--manifolds", "all"}));
  EXPECT_EQ(without.size(), lines.size() - 1);
}

// The samples of an octahedron have equal parts of its volume, which is 4/3.
TEST(WholeComplex, SharesInDoubles) {
  CITES("FC-VOL-02", "FC-NUM-02");
  const Written file = written("1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n", {"--volumes", "shares"});
  EXPECT_EQ(file.header["volumes"], "shares");
  std::size_t count = 0;
  for (const json& record : file.records) {
    EXPECT_FALSE(record.contains("shares") || record.contains("volume"));
    if (!record.contains("shares_double")) continue;
    ++count;
    ASSERT_EQ(record["shares_double"].size(), 6U);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(record["shares_double"][k], json::array({k, 2.0 / 9}));
  }
  EXPECT_EQ(count, 1U);
}

TEST(WholeComplex, CentersAndVolumesAreExactOrDoublesOrLeftOut) {
  CITES("FC-NUM-02", "FC-UNST-02");
  for (const std::string& points : {std::string(kSaddleToSaddle), std::string(kChain), lattice_points(9, 12, 4)}) {
    Written expected = written(points, {});
    EXPECT_EQ(expected.header["volumes"], "double");
    Written exact = written(points);
    EXPECT_EQ(exact.header["volumes"], "exact");
    for (json& record : exact.records) {
      record.erase("volume");
      record.erase("shares");
    }
    EXPECT_EQ(exact.records, expected.records);
    EXPECT_EQ(written(points, {"--volumes", "double"}).records, expected.records);
    for (const std::string centers : {"double", "none"}) {
      for (json& record : expected.records) {
        const bool is_none = centers == "none";
        for (const char* key : {"center", "squared_distance"}) record.erase(key);
        if (is_none) record.erase("center_double"), record.erase("squared_distance_double");
        if (!record.contains("lambda")) continue;
        for (json& direction : record["lambda"]["directions"]) {
          for (const char* key : {"exit", "vector"}) direction.erase(key);
          if (is_none) direction.erase("exit_double"), direction.erase("vector_double");
        }
      }
      EXPECT_EQ(written(points, {"--centers", centers}).records, expected.records) << centers;
    }
  }
}

TEST(WholeComplex, NumbersBeyondTheDoublesAreNull) {
  CITES("FC-NUM-02", "FC-VOL-01");
  const std::string points = "1e200 0 0\n-1e200 0 0\n0 1e200 0\n0 -1e200 0\n0 0 1e200\n0 0 -1e200\n";
  const json record = written(points).of({0, 1, 2, 3, 4, 5});
  EXPECT_TRUE(record["volume_double"].is_null());
  const oracle::Rational a(1e200);
  EXPECT_EQ(rational(record["volume"]), oracle::Rational(4 * a * a * a / 3));
  const Scratch scratch;
  const Finished finished = flowcert({"compute", scratch.file("points.xyz", points), "--manifolds", "all", "--json"});
  const json summary = json::parse(finished.out)["whole_complex"];
  EXPECT_TRUE(summary["hull_volume_double"].is_null());
  EXPECT_TRUE(summary["volume_to_infinity_double"].is_null());
  EXPECT_EQ(rational(summary["hull_volume"]), rational(record["volume"]));
}

TEST(WholeComplex, TheNumberOfThreadsAndTheKernelDoNotMatter) {
  CITES("FC-OUT-02", "FC-NUM-01");
  const Scratch scratch;
  const std::string points = lattice_points(5, 1500, 60);
  const auto file = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--manifolds", "all", "--centers", "double"};
    options.insert(options.end(), more.begin(), more.end());
    return file_of(scratch, points, options);
  };
  const std::string expected = file({"--threads", "1"});
  EXPECT_EQ(lines_of(expected).size() > 4096, true) << "several texts";
  EXPECT_EQ(file({"--threads", "2"}), expected);
  EXPECT_EQ(file({"--threads", "3", "--kernel", "exact"}), expected);
  const std::string small = lattice_points(5, 100, 8);
  EXPECT_EQ(file_of(scratch, small, {"--manifolds", "all", "--volumes", "exact", "--threads", "1"}),
            file_of(scratch, small, {"--manifolds", "all", "--volumes", "exact", "--threads", "4"}));
}

// ---- The summary and the table ----

TEST(WholeComplexSummary, HasTheKeysOfTheFormat) {
  CITES("FC-VOL-01", "FC-UNST-02");
  const Scratch scratch;
  const Finished finished =
      flowcert({"compute", scratch.file("points.xyz", kSaddleToSaddle), "--manifolds", "all", "--json", "--runs", "3"});
  ASSERT_EQ(finished.status, 0) << finished.err;
  const json summary = json::parse(finished.out);
  json whole = summary["whole_complex"];
  EXPECT_TRUE(whole["volumes_decided_exactly"].is_number_unsigned());
  whole.erase("volumes_decided_exactly");
  EXPECT_EQ(whole, json::parse(R"({"lists":16,"directions":38,"arcs":24,"connections":58,"morse_smale":false,
      "with_interval":1,"ends_elsewhere":2,"hull_volume":"140","hull_volume_double":140.0,
      "volume_to_infinity_double":0.0})"));
  EXPECT_TRUE(summary.contains("u2"));
  EXPECT_TRUE(summary.contains("s2"));
  EXPECT_EQ(keys_of(summary["seconds"]), (Names{"delaunay", "critical", "u2", "s2", "limits", "volumes"}));
  EXPECT_EQ(keys_of(summary["ratio_to_delaunay"]), (Names{"critical", "u2", "s2", "limits", "volumes", "all"}));
  EXPECT_GT(summary["seconds"]["limits"], 0.0);
  EXPECT_GT(summary["seconds"]["volumes"], 0.0);
}

// A tetrahedron whose circumcentre is outside it: nothing but samples and edges keeps what flows.
TEST(WholeComplexSummary, TellsWhatFlowsToInfinity) {
  CITES("FC-VOL-01");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", "0 0 0\n2 0 0\n0 1 0\n0 0 1\n");
  const json whole = json::parse(flowcert({"compute", input, "--manifolds", "all", "--json"}).out)["whole_complex"];
  EXPECT_EQ(whole["hull_volume"], "1/3");
  EXPECT_EQ(whole["volume_to_infinity_double"], 1.0 / 3);
}

TEST(WholeComplexSummary, OtherManifoldsHaveNoneOfIt) {
  CITES("FC-OUT-01");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube);
  const json summary = json::parse(flowcert({"compute", input, "--manifolds", "u2,s2", "--json"}).out);
  EXPECT_FALSE(summary.contains("whole_complex"));
  EXPECT_EQ(keys_of(summary["seconds"]), (Names{"delaunay", "critical", "u2", "s2"}));
  const std::string table = flowcert({"compute", input, "--manifolds", "u2,s2"}).out;
  for (const char* row : {"Morse-Smale", "volume", "limits"}) EXPECT_EQ(table.find(row), std::string::npos) << row;
  const std::string file = file_of(scratch, kCube, {"--manifolds", "u2,s2"});
  for (const char* key : {"lambda", "volume", "morse_smale"}) EXPECT_EQ(file.find(key), std::string::npos) << key;
}

TEST(WholeComplexTable, HasARowForEveryNumber) {
  CITES("FC-VOL-01", "FC-UNST-02");
  const Scratch scratch;
  const auto table_of = [&](const char* points) {
    return flowcert({"compute", scratch.file("points.xyz", points), "--manifolds", "all"}).out;
  };
  const std::string table = table_of(kSaddleToSaddle);
  for (const char* row :
       {"\nlists of limits                               16   where all directions lead\n",
        "\nsingle directions in them                     38\n", "\narcs of directions in them                    24\n",
        "\nconnections                                   58   to points and to infinity\n",
        "\nvolume of the convex hull                    140\n",
        "\nvolume that flows to infinity                  0   hull - rounded volumes\n", "\nMorse-Smale   ",
        "\nlimits of all directions   ", "\nvolumes   "}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << table;
  }
  const auto morse_smale = [&](const char* points) {
    const std::string all = table_of(points);
    const std::size_t from = all.find("\nMorse-Smale") + 1;
    std::istringstream words(all.substr(from, all.find("\nvolume of the", from) - from));
    std::string text;
    for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    return text;
  };
  EXPECT_EQ(morse_smale(kCube), "Morse-Smale yes");
  EXPECT_EQ(morse_smale(kSaddleToSaddle), "Morse-Smale no S2 of dimension 3: 1, orbits of U2 to no maximum: 2");
  EXPECT_EQ(morse_smale(kHalfOctahedron), "Morse-Smale no regular points: 1, orbits of U2 to no maximum: 4");
}

// The block after <!-- example: whole complex --> is a command line after a dollar, and all that it prints.
TEST(WholeComplexTable, TheReadmesExampleIsRight) {
  const std::vector<std::string> lines = lines_of(content_of(FLOWCERT_CLI_README));
  auto line = std::find(lines.begin(), lines.end(), "<!-- example: whole complex -->");
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

// ---- What is refused ----

TEST(WholeComplex, VolumesNeedAllManifoldsAFileAndAKnownWord) {
  CITES("FC-VOL-01");
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube), output = scratch.path("x.jsonl");
  using Words = std::vector<std::string>;
  for (const Words& options :
       {Words{"-o", output, "--volumes", "exact"}, Words{"-o", output, "--manifolds", "u2,s2", "--volumes", "exact"},
        Words{"-o", output, "--manifolds", "s2", "--volumes", "double"},
        Words{"--manifolds", "all", "--volumes", "exact"},
        Words{"-o", output, "--manifolds", "all", "--volumes", "rounded"}}) {
    Words words = {"compute", input};
    words.insert(words.end(), options.begin(), options.end());
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find("--volumes"), std::string::npos) << finished.err;
    EXPECT_EQ(scratch.names(), Names{"cube.xyz"});
  }
}

}  // namespace
}  // namespace flowcert::conformance::whole_complex_command_test
