// `flowcert compute --manifolds all --sheets` as a user calls it: the unstable sets U1 in the file of records
// (spec/formats/stationary_points.md).
//
// Guarantees: the expected sets are worked out by hand, or are the oracle's.
#include "oracle/unstable_surface.h"
#include "tests/cites.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/written_complex.h"

namespace flowcert::conformance::unstable_surface_command_test {
namespace {

// From an edge of the cube to the two squares at it: a quarter of a plane, with its sides.
TEST(Sheets, OfAnEdgeOfTheCube) {
  CITES("FC-UNST-04", "FC-OUT-01", "FC-FILE-11");
  const Written file = written(kCube, {"--sheets"});
  EXPECT_EQ(file.of({0, 1})["u1"], json::parse(R"({"vertices":[["1/2","1/2","1/2"]],"traces":[
      {"polygon":[0,1,2,3],"from":["1/2","1/2","1/2"],"to":{"vector":["0","0","-1"]}},
      {"polygon":[0,1,4,5],"from":["1/2","1/2","1/2"],"to":{"vector":["0","-1","0"]}}],"runs":[],"sheets":[
      {"samples":[0,1],"corners":[["1/2","1/2","1/2"],{"vector":["0","-1","0"]},{"vector":["0","0","-1"]}]}],
      "segments":[]})"));
  // If the points do not span space, sheets are whole facets, and traces whole lines.
  EXPECT_EQ(written("-4 0 0\n4 0 0\n0 1 0\n", {"--sheets"}).of({0, 2})["u1"], json::parse(R"({"vertices":[],"traces":[
      {"polygon":[0,1,2],"from":{"vector":["0","0","-1"]},"to":{"vector":["0","0","1"]}}],"runs":[],"sheets":[
      {"samples":[0,1],"corners":[]},{"samples":[0,2],"corners":[]}],"segments":[]})"));
}

oracle::Corner corner(const json& field) {
  return field.is_object() ? oracle::Corner{position(field["vector"]), true} : oracle::Corner{position(field)};
}

std::vector<oracle::EdgePart> edge_parts(const json& field) {
  std::vector<oracle::EdgePart> parts;
  for (const json& part : field) parts.push_back({part["polygon"], corner(part["from"]), corner(part["to"])});
  return parts;
}

oracle::UnstableSurface unstable_surface(const json& field) {
  oracle::UnstableSurface set;
  for (const json& vertex : field["vertices"]) set.vertices.push_back(position(vertex));
  set.traces = edge_parts(field["traces"]);
  set.runs = edge_parts(field["runs"]);
  for (const json& sheet : field["sheets"]) {
    set.sheets.push_back({sheet["samples"], {}});
    for (const json& one : sheet["corners"]) set.sheets.back().corners.push_back(corner(one));
  }
  for (const json& segment : field["segments"]) {
    set.segments.push_back({segment["samples"], corner(segment["end"]), position(segment["start"])});
  }
  return set;
}

TEST(Sheets, AreTheOracles) {
  CITES("FC-UNST-04", "FC-UNST-05", "FC-UNST-06", "FC-OUT-01");
  std::size_t runs = 0, segments = 0, regular = 0;
  for (const std::string& points :
       {std::string(kChain), std::string(kHalfOctahedron), std::string(kSaddleToSaddle), lattice_points(1, 9, 3),
        lattice_points(2, 10, 4), lattice_points(3, 11, 6), lattice_points(4, 12, 30)}) {
    const oracle::PointSet set(rows_of(points));
    const oracle::Answer truth = oracle::stationary_points(set);
    const Written file = written(points, {"--sheets"});
    ASSERT_EQ(file.records.size(), truth.stationary.size());
    for (std::size_t i = 0; i < file.records.size(); ++i) {
      const oracle::StationaryPoint& y = truth.stationary[i];
      ASSERT_EQ(file.records[i].contains("u1"), y.face_dimension == 1);
      if (y.face_dimension != 1) continue;
      const oracle::UnstableSurface found = unstable_surface(file.records[i]["u1"]);
      EXPECT_EQ(found, oracle::unstable_surface(set, y)) << file.records[i];
      runs += found.runs.size(), segments += found.segments.size(), regular += y.hull_dimension > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(runs, 10U);
  EXPECT_GT(segments, 3U);
  EXPECT_GT(regular, 3U);
}

TEST(Sheets, AreAddedToWhatIsThere) {
  CITES("FC-OUT-01");
  const Scratch scratch;
  const std::string points = lattice_points(5, 200, 12);
  const auto file = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--manifolds", "all", "--centers", "double"});
    return file_of(scratch, points, more);
  };
  const std::string all = file({"--sheets", "--threads", "1"});
  EXPECT_EQ(file({"--sheets", "--threads", "3"}), all);
  EXPECT_EQ(file({"--sheets", "--kernel", "exact"}), all);
  std::string without;
  for (const std::string& line : lines_of(all)) {
    auto record = nlohmann::ordered_json::parse(line);
    record.erase("u1");
    without += record.dump() + '\n';
  }
  EXPECT_EQ(without, file({}));
}

TEST(Sheets, AreJudged) {
  CITES("FC-CLAIM-17", "FC-UNST-04");
  const Scratch scratch;
  const std::string points = lattice_points(3, 9, 4),
                    text = file_of(scratch, points, {"--manifolds", "all", "--sheets"});
  const auto check = [&](const std::string& claim, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"check", scratch.file("p.xyz", points), scratch.file("claim.jsonl", claim)};
    words.insert(words.end(), more.begin(), more.end());
    return flowcert(words);
  };
  for (const std::vector<std::string>& truth : {std::vector<std::string>{}, std::vector<std::string>{"--oracle"}}) {
    EXPECT_EQ(check(text, truth).status, 0);
    std::string wrong = text;
    const std::size_t at = wrong.find("\"sheets\":[{\"samples\":[");
    ASSERT_NE(at, std::string::npos);
    wrong.replace(wrong.find("\"samples\"", at), std::string("\"samples\"").size(), "\"samples\":[7,8],\"others\"");
    const Finished finished = check(wrong, truth);
    EXPECT_EQ(finished.status, 1);
    EXPECT_NE(finished.out.find("wrong-unstable-set"), std::string::npos) << finished.out;
    EXPECT_NE(finished.out.find("FC-UNST-04"), std::string::npos) << finished.out;
  }
}

TEST(Sheets, NeedAllManifoldsAndAFile) {
  CITES("FC-UNST-04");
  const Scratch scratch;
  const std::string input = scratch.file("cube.xyz", kCube), output = scratch.path("x.jsonl");
  using Words = std::vector<std::string>;
  for (const Words& options :
       {Words{"-o", output}, Words{"-o", output, "--manifolds", "u2,s2"}, Words{"--manifolds", "all"}}) {
    Words words = {"compute", input, "--sheets"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find("--sheets"), std::string::npos) << finished.err;
    EXPECT_EQ(scratch.names(), std::set<std::string>{"cube.xyz"});
  }
}

}  // namespace
}  // namespace flowcert::conformance::unstable_surface_command_test
