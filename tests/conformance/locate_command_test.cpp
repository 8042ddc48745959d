// `flowcert locate` as a user calls it: text and JSON Lines of src/cli/manual/locate.md, ties, infinity, flat inputs,
// and what it refuses.
//
// Guarantees: each line says where `flowcert orbit` ends from the same position.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::locate_command_test {
namespace {

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";

Words lines_without_comments(const std::string& text) {
  Words lines;
  for (const std::string& line : lines_of(text)) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

TEST(LocateCommand, AnswersALineForEachPosition) {
  CITES("FC-LOC-01", "FC-FLOW-05", "FC-DIST-01");
  const Scratch scratch;
  const std::string cube = scratch.file("cube.xyz", kCube);
  const std::string positions =
      scratch.file("positions.xyz",
                   "0.25 0.25 0.25\n0 0 0\n0.5 0 0\n0.5 0.25 0\n0.5 0.5 0.5\n2 0.75 0.75\n2 0.5 0.5\n0.25 0.25 0.25\n");
  const Finished done = flowcert({"locate", cube, "--positions", positions});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(lines_without_comments(done.out),
            (Words{"3 0,1,2,3,4,5,6,7 0", "0 0 0", "1 0,1 0,1", "2 0,1,2,3 0,1", "3 0,1,2,3,4,5,6,7 0,1,2,3,4,5,6,7",
                   "infinity - 7", "infinity - 1,3,5,7", "3 0,1,2,3,4,5,6,7 0"}));
}

TEST(LocateCommand, SaysWhereOrbitsEnd) {
  CITES("FC-FLOW-05");
  const Scratch scratch;
  // A regular stationary point, a flat input, and one sample.
  const std::string inputs[] = {"5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n", "0 0 0\n4 0 0\n0 3 0\n5 5 0\n", "1 2 3\n"};
  const Words positions = {"0,0,0", "1,1,0.5", "0,0,0.5", "2,1.5,0", "-9,0.25,1e300", "1,2,3"};
  for (const std::string& input : inputs) {
    const std::string points = scratch.file("points.xyz", input);
    std::string rows;
    for (const std::string& position : positions) rows += position + '\n';
    const Finished located =
        flowcert({"locate", points, "--positions", scratch.file("positions.csv", rows), "--json", "--threads", "2"});
    ASSERT_EQ(located.status, 0) << located.err;
    const Words lines = lines_of(located.out);
    ASSERT_EQ(lines.size(), positions.size() + 1);
    EXPECT_EQ(ordered_json::parse(lines[0])["format"], "flowcert-locate");
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const ordered_json place = ordered_json::parse(lines[k + 1]);
      const ordered_json orbit =
          ordered_json::parse(flowcert({"orbit", points, "--from=" + positions[k], "--json"}).out);
      for (const char* key : {"kind", "index", "contact"}) EXPECT_EQ(place[key], orbit["limit"][key]) << lines[k + 1];
      const bool stays = orbit["segments"].empty();
      EXPECT_EQ(place["nearest"], stays ? orbit["limit"]["contact"] : orbit["segments"][0]["start_contact"]);
    }
  }
}

TEST(LocateCommand, WritesAFileAndASummary) {
  const Scratch scratch;
  const std::string cube = scratch.file("cube.xyz", kCube), out = scratch.path("places.txt");
  const Finished done = flowcert({"locate", cube, "--positions", scratch.file("q.xyz", "0.5 0.25 0\n"), "-o", out});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("positions"), std::string::npos) << done.out;
  EXPECT_EQ(lines_without_comments(content_of(out)), Words{"2 0,1,2,3 0,1"});
}

TEST(LocateCommand, RefusesWhatItCannotUse) {
  CITES("FC-LOC-02", "FC-FLOW-10");
  const Scratch scratch;
  const std::string cube = scratch.file("cube.xyz", kCube), empty = scratch.file("empty.xyz", "# nothing\n");
  const auto refuses = [](const Words& words, const std::string& reason) {
    const Finished done = flowcert(words);
    EXPECT_EQ(done.status, 2);
    EXPECT_EQ(lines_of(done.err).size(), 1U) << done.err;
    EXPECT_NE(done.err.find(reason), std::string::npos) << done.err;
  };
  refuses({"locate", empty, "--positions", cube}, "there are no points");
  refuses({"locate", cube, "--positions", scratch.file("bad.xyz", "0 0 0\n1 x 2\n")}, "bad.xyz:2");
  refuses({"locate", "-", "--positions", "-"}, "standard input");
  const Finished none = flowcert({"locate", cube, "--positions", empty});
  EXPECT_EQ(none.status, 0) << none.err;
  EXPECT_TRUE(lines_without_comments(none.out).empty());
}

}  // namespace
}  // namespace flowcert::conformance::locate_command_test
