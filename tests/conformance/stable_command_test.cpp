// `flowcert compute --manifolds s2` as a user calls it: the summary, the table, the keys of records
// (src/cli/manual/summary.md, spec/formats/stationary_points.md), and what it refuses.
//
// Guarantees: the expected skeletons are worked out by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cites.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::stable_command_test {
namespace {

using nlohmann::json;

// An acute triangle: its circle is around (2, 1), all three sides are Gabriel edges.
constexpr char kAcute[] = "0 0 0\n4 0 0\n1 3 0\n";
// A right triangle: its circle is around the middle of the longest side, a regular stationary point.
constexpr char kRight[] = "0 0 0\n3 0 0\n0 4 0\n";
// Two triangles with the side from (0,0) to (8,0) in common: acute above, and obtuse below.
constexpr char kTwoTriangles[] = "0 0 0\n8 0 0\n4 7 0\n4 -3 0\n";

std::vector<json> records_of(const std::string& points, const std::vector<std::string>& options) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", points), output = scratch.path("records");
  std::vector<std::string> words = {"compute", input, "-o", output, "--manifolds", "s2"};
  words.insert(words.end(), options.begin(), options.end());
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  std::vector<json> records;
  for (const std::string& line : lines_of(content_of(output))) records.push_back(json::parse(line));
  records.erase(records.begin());
  return records;
}

TEST(StableCommand, TheSkeletonOfAnAcuteTriangle) {
  CITES("FC-STAB-04", "FC-STAB-07", "FC-FILE-08");
  const auto records = records_of(kAcute, {"--skeletons"});
  const json& saddle = records.at(6);
  EXPECT_EQ(saddle["index"], 2);
  EXPECT_EQ(saddle["stable"], json::parse(R"({"segments":3,"has_vertex":false,"has_interval":false,
                                             "boundary":[[0,1],[0,2],[1,2]],"walk":[0,1,2]})"));
  EXPECT_EQ(saddle["skeleton"]["intervals"], json::array());
  EXPECT_EQ(saddle["skeleton"]["sectors"], json::array());
  ASSERT_EQ(saddle["skeleton"]["segments"].size(), 3U);
  EXPECT_EQ(saddle["skeleton"]["segments"][1],
            json::parse(R"({"samples":[0,2],"front":["2","1","0"],"back":["1/2","3/2","0"],
                            "front_contact":[0,1,2],"back_contact":[0,2],"back_kind":"critical"})"));
  EXPECT_EQ(records.at(3)["samples"], json::parse("[0,1]"));
  EXPECT_FALSE(records.at(3).contains("stable"));
}

TEST(StableCommand, TheSkeletonOfARegularStationaryPoint) {
  CITES("FC-STAB-01", "FC-STAB-03");
  const json regular = records_of(kRight, {"--skeletons"}).at(5);
  EXPECT_EQ(regular["kind"], "regular");
  EXPECT_EQ(regular["stable"], json::parse(R"({"segments":2,"has_vertex":false,"has_interval":false,"walk":[0,1,2]})"));
  EXPECT_EQ(regular["skeleton"]["segments"][0]["back"], json::parse(R"(["3/2","0","0"])"));
}

// The branch through the common side comes from the lower triangle's centre (4,7/6), which is above that side. The
// branch goes on through the two other sides of the lower triangle.
TEST(StableCommand, ABranchGoesOnThroughAnObtuseTriangle) {
  CITES("FC-STAB-04", "FC-STAB-06");
  const json saddle = records_of(kTwoTriangles, {"--skeletons"}).at(8);
  EXPECT_EQ(saddle["contact"], json::parse("[0,1,2]"));
  EXPECT_EQ(saddle["stable"]["segments"], 5);
  EXPECT_EQ(saddle["stable"]["boundary"], json::parse("[[0,2],[0,3],[1,2],[1,3]]"));
  const json& segments = saddle["skeleton"]["segments"];
  ASSERT_EQ(segments.size(), 5U);
  EXPECT_EQ(segments[0], json::parse(R"({"samples":[0,1],"front":["4","33/14","0"],"back":["4","7/6","0"],
                                         "front_contact":[0,1,2],"back_contact":[0,1,3],"back_kind":"edge"})"));
  EXPECT_EQ(segments[2], json::parse(R"({"samples":[0,3],"front":["4","7/6","0"],"back":["2","-3/2","0"],
                                         "front_contact":[0,1,3],"back_contact":[0,3],"back_kind":"critical"})"));
}

TEST(StableCommand, TheSummaryHasTheKeysOfS2AndNoneOfU2) {
  const Scratch scratch;
  const Finished finished =
      flowcert({"compute", scratch.file("points.xyz", kTwoTriangles), "--manifolds", "s2", "--json", "--stats"});
  ASSERT_EQ(finished.status, 0) << finished.err;
  const json summary = json::parse(finished.out);
  ASSERT_TRUE(summary.contains("s2"));
  const json& s2 = summary["s2"];
  const std::set<std::string> keys = {
      "kernel",         "search",        "sets",       "triangles", "largest_triangles", "largest_contact",
      "through_vertex", "with_interval", "to_regular", "n_s2",      "triangles_of_set",  "primitives"};
  std::set<std::string> there;
  for (const auto& [key, value] : s2.items()) there.insert(key);
  EXPECT_EQ(there, keys);
  EXPECT_EQ(s2["triangles"].get<std::size_t>() % 2, 0U);
  EXPECT_EQ(s2["n_s2"]["count"].get<std::size_t>() > 0, summary["critical"][2].get<std::size_t>() > 0);
  EXPECT_TRUE(summary["seconds"].contains("s2"));
  EXPECT_FALSE(summary["seconds"].contains("u2"));
  EXPECT_TRUE(summary["ratio_to_delaunay"].contains("s2"));
}

TEST(StableCommand, KernelAndSearchDoNotMatter) {
  CITES("FC-NUM-01", "FC-STAB-04", "FC-STAB-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", lattice_points(4, 40, 5)), output = scratch.path("records");
  const auto records = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"compute", input, "--manifolds", "s2", "--skeletons", "--json", "-o", output};
    words.insert(words.end(), options.begin(), options.end());
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 0) << finished.err;
    const json s2 = json::parse(finished.out)["s2"];
    if (!options.empty()) {
      EXPECT_EQ(s2["kernel"], options[1]);
      EXPECT_EQ(s2["search"], options[3]);
    }
    return content_of(output);
  };
  const std::string expected = records({});
  EXPECT_NE(expected.find("\"back_contact\""), std::string::npos);
  for (const char* kernel : {"cascade", "lazy", "exact"}) {
    for (const char* search : {"binary", "linear"}) {
      EXPECT_EQ(records({"--kernel", kernel, "--search", search}), expected) << kernel << ", " << search;
    }
  }
}

// The points are rounded, so that there are ties and long orbits. An orbit is a chain of segments. There is
// one for each critical back, and the lengths are n_S2.
TEST(StableCommand, ConnectingOrbitsAreChainsOfSegments) {
  CITES("FC-STAB-06");
  const Scratch scratch;
  std::string rows;
  std::uint32_t state = 1;
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < 3; ++k) {
      state = state * 1664525U + 1013904223U;
      rows += std::to_string(state >> 26) + (k < 2 ? " " : "\n");
    }
  }
  const std::string input = scratch.file("points.xyz", rows), output = scratch.path("records");
  const Finished finished =
      flowcert({"compute", input, "--manifolds", "s2", "--json", "--stats", "--skeletons", "-o", output});
  ASSERT_EQ(finished.status, 0) << finished.err;
  std::size_t longest = 0, count = 0, total = 0;
  for (const std::string& line : lines_of(content_of(output))) {
    const json record = json::parse(line);
    if (!record.contains("skeleton") || record["kind"] != "critical") continue;
    if (record["stable"]["has_interval"] == true) continue;
    const json& segments = record["skeleton"]["segments"];
    std::size_t critical_backs = 0;
    for (const json& segment : segments) critical_backs += segment["back_kind"] == "critical" ? 1 : 0;
    EXPECT_EQ(record["skeleton"]["orbits"].size(), critical_backs) << line;
    for (const json& orbit : record["skeleton"]["orbits"]) {
      json at = record["center"];
      for (const json& place : orbit) {
        EXPECT_EQ(segments[place.get<std::size_t>()]["front"], at);
        at = segments[place.get<std::size_t>()]["back"];
      }
      EXPECT_EQ(segments[orbit.back().get<std::size_t>()]["back_kind"], "critical");
      longest = std::max(longest, orbit.size());
      total += orbit.size();
      ++count;
    }
  }
  const json n_s2 = json::parse(finished.out)["s2"]["n_s2"];
  EXPECT_GT(longest, 3U);
  EXPECT_LE(count, n_s2["count"].get<std::size_t>()) << "orbits of sets with intervals are counted too";
  EXPECT_GT(2 * count, n_s2["count"].get<std::size_t>());
  EXPECT_LE(longest, n_s2["max"].get<std::size_t>());
  EXPECT_GT(total, count);
}

TEST(StableCommand, TheTableNamesTheLargest) {
  CITES("FC-STAB-06");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kAcute);
  const Finished finished = flowcert({"compute", input, "--manifolds", "u2,s2", "--stats"});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_NE(finished.out.find("of contact set 0 1 2"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("n_S2"), std::string::npos);
  EXPECT_NE(finished.out.find("n_U2"), std::string::npos);
}

TEST(StableCommand, RefusesWhatMeansNothing) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kAcute), output = scratch.path("records");
  const auto refuses = [&](const std::vector<std::string>& words, const std::string& what) {
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2) << what;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
  };
  refuses({"compute", input, "--manifolds", "s2,x"}, "--manifolds");
  refuses({"compute", input, "--manifolds", "s2", "--skeletons"}, "--skeletons");
  refuses({"compute", input, "--manifolds", "u2", "-o", output, "--skeletons"}, "--skeletons");
  refuses({"compute", input, "--manifolds", "s2", "-o", output, "--polylines"}, "--polylines");
  refuses({"compute", input, "--manifolds", "s2", "--alone"}, "--alone");
  EXPECT_FALSE(scratch.names().contains("records"));
}

}  // namespace
}  // namespace flowcert::conformance::stable_command_test
