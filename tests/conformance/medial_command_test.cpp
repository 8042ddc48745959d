// `flowcert medial` as a user calls it: which saddles are chosen, the files of src/cli/manual/medial.md, and what it
// refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::medial_command_test {
namespace {

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
// An acute triangle whose smallest circle is seen under less than 150 degrees, and a point above.
constexpr char kTetrahedron[] = "0 0 0\n4 0 0\n2 3.5 0\n2 1.2 3\n";

std::size_t count_of(const ordered_json& json, int index) {
  std::size_t count = 0;
  for (const ordered_json& point : json["chosen"]) count += point["index"] == index ? 1 : 0;
  return count;
}

TEST(MedialCommand, ChoosesByAngleAndPersistence) {
  CITES("FC-MED-01", "FC-MED-02", "FC-MED-03");
  const Scratch scratch;
  const std::string cube = scratch.file("cube.xyz", kCube), tetrahedron = scratch.file("t.xyz", kTetrahedron);
  const auto chosen = [](const std::string& points, Words options) {
    options.insert(options.begin(), {"medial", points, "--json"});
    const Finished done = flowcert(options);
    EXPECT_EQ(done.status, 0) << done.err;
    const ordered_json json = ordered_json::parse(done.out);
    for (const char* key : {"persistence", "radius", "angle"}) {
      const auto given = std::ranges::find(options, std::string("--") + key);
      EXPECT_EQ(json.at(key), given == options.end() ? ordered_json() : ordered_json(*std::next(given)));
    }
    return std::pair(count_of(json, 1), count_of(json, 2));
  };
  using Counts = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(chosen(cube, {}), Counts(12, 6));
  EXPECT_EQ(chosen(cube, {"--angle", "179.9"}), Counts(12, 6));  // opposite corners of a square
  EXPECT_EQ(chosen(cube, {"--angle", "180"}), Counts(0, 0));
  // Seven edges join components: their pairs have the length 1/2. Five tunnels last from 1/2 to the root of 1/2, and
  // the void from there to that of 3/4.
  EXPECT_EQ(chosen(cube, {"--persistence", "0.1"}), Counts(12, 6));
  EXPECT_EQ(chosen(cube, {"--persistence", "0.2"}), Counts(12, 5));
  EXPECT_EQ(chosen(cube, {"--persistence", "1/4"}), Counts(7, 0));
  EXPECT_EQ(chosen(cube, {"--persistence", "1/2"}), Counts(0, 0));
  const Counts all = chosen(tetrahedron, {}), wide = chosen(tetrahedron, {"--angle", "150"});
  EXPECT_EQ(wide.first, all.first);
  EXPECT_LT(wide.second, all.second);
}

TEST(MedialCommand, WritesWhatFlowsFromChosenPoints) {
  CITES("FC-MED-01");
  const Scratch scratch;
  const std::string points = scratch.file("t.xyz", kTetrahedron), folder = scratch.path("axis");
  const Finished done = flowcert({"medial", points, "--angle", "150", "--export", folder});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("chosen of index 2"), std::string::npos) << done.out;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"medial_lines.vtp", "medial_sheets.ply", "medial_sheets.vtp"}));
  const std::string all = scratch.path("all");
  EXPECT_EQ(flowcert({"medial", points, "--export", all}).status, 0);
  EXPECT_EQ(content_of(all + "/medial_sheets.ply"), content_of(folder + "/medial_sheets.ply"));
  EXPECT_GT(content_of(all + "/medial_lines.vtp").size(), content_of(folder + "/medial_lines.vtp").size());
}

TEST(MedialCommand, RefusesWhatItCannotUse) {
  CITES("FC-MED-02");
  const Scratch scratch;
  const std::string points = scratch.file("cube.xyz", kCube), file = scratch.file("file", "");
  const auto refuses = [&](Words words, const std::string& reason) {
    words.insert(words.begin(), {"medial", points});
    const Finished done = flowcert(words);
    EXPECT_EQ(done.status, 2);
    EXPECT_NE(done.err.find(reason), std::string::npos) << done.err;
  };
  refuses({"--angle", "181"}, "--angle: not from 0 to 180 degrees");
  refuses({"--angle", "-1"}, "--angle: not from 0 to 180 degrees");
  refuses({"--angle", "wide"}, "not a number: 'wide'");
  refuses({"--persistence", "long"}, "not a number: 'long'");
  refuses({"--clip", "none"}, "--export");
  refuses({"--export", file}, "cannot be made");
  refuses({"--export", scratch.path("x"), "--clip", "0"}, "--clip");
}

}  // namespace
}  // namespace flowcert::conformance::medial_command_test
