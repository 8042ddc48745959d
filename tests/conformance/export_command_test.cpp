// `flowcert compute --export` and `flowcert surface` as a user calls them: what is selected, what is counted,
// what is refused, and that no file is left behind (src/cli/manual/exports.md, surfaces.md).
//
// Guarantees: selections are compared with the pairs of `flowcert persistence --json`, exactly. What is in
// the files is read elsewhere, by VTK and CGAL.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "flowcert/rational.h"
#include "geometry/difference_of_roots.h"
#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::export_command_test {
namespace {

using geometry::RootDifference;
using nlohmann::json;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

// The circle is around the origin, of radius 5.
constexpr char kRadiusFive[] = "5 0 0\n-3 4 0\n-3 -4 0\n";
// Six index-2 points, all of squared value 1/2; all gaps are 1/4.
constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
// An S2 with parts of dimension 3.
constexpr char kInterval[] = "-2 0 0\n2 0 0\n0 -1 1\n0 -1 -1\n0 5 0\n";
constexpr char kBeyondDoubles[] = "1e308 0 0\n-1e308 0 0\n0 1.5e308 0\n";
// Nearly flat: orbits pass a Voronoi vertex that is beyond the doubles, and go to infinity.
constexpr char kFarVertex[] = "0 0 0\n1 0 0\n0 1 0\n1.1 1 1e-310\n";

std::string random_points(unsigned seed, int count) {
  std::mt19937 numbers(seed);
  std::string text;
  for (int k = 0; k < 3 * count; ++k) {
    text += std::to_string(static_cast<double>(numbers() % 1000000) / 1e6) + (k % 3 == 2 ? "\n" : " ");
  }
  return text;
}

json json_of(const Words& words) {
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  json object = json::parse(finished.out, nullptr, false);
  EXPECT_TRUE(object.is_object()) << finished.out;
  return object.is_object() ? object : json::object();
}

json surface(const Scratch& scratch, const std::string& input, const Words& selections) {
  Words words = {"surface", input, "-o", scratch.path("surface.ply"), "--json"};
  for (const std::string& selection : selections) words.insert(words.end(), {"--select", selection});
  return json_of(words);
}

std::size_t selected(const std::string& points, const Words& selections) {
  const Scratch scratch;
  return surface(scratch, scratch.file("points.xyz", points), selections).at("selected");
}

void expect_refused(const Words& words, const std::string& what) {
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 2) << what;
  EXPECT_EQ(finished.out, "") << what;
  EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
  EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
}

// The lines without the comment that names the format.
Words without_comment(const std::string& ply) {
  Words lines = lines_of(ply);
  std::erase_if(lines, [](const std::string& line) { return line.starts_with("comment "); });
  return lines;
}

struct Gap {
  RootDifference length;
  Rational squared_radius;
};

std::vector<Gap> gaps_of(const std::string& input) {
  const json answer = json_of({"persistence", input, "--json"});
  std::vector<Gap> gaps;
  for (const json& pair : answer.at("pairs")) {
    if (pair.at("dimension") == 0) continue;
    const Rational birth(pair["birth"]["squared_distance"].get<std::string>()),
        death(pair["death"]["squared_distance"].get<std::string>());
    gaps.push_back({{death, birth}, pair["dimension"] == 1 ? death : birth});
  }
  return gaps;
}

TEST(ExportCommand, WithoutASelectionAllSurfacesAreWritten) {
  CITES("FC-STAB-04", "FC-STAB-06");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(1, 80)), files = scratch.path("a/b");
  const json summary = json_of({"compute", input, "--export", files, "--json"});
  const json all = surface(scratch, input, {});
  EXPECT_EQ(all["format"], "flowcert-surface-summary");
  EXPECT_EQ(all["format_version"], 1);
  EXPECT_EQ(all["sets"], summary["critical"][2]);
  EXPECT_EQ(all["selected"], summary["critical"][2]);
  EXPECT_EQ(all["triangles"], summary["s2"]["triangles"]);
  EXPECT_EQ(all["with_interval"], 0);
  EXPECT_EQ(without_comment(content_of(files + "/stable_surfaces.ply")),
            without_comment(content_of(scratch.path("surface.ply"))));
  EXPECT_EQ(scratch.names(), (std::set<std::string>{"a", "points.xyz", "surface.ply"}));
}

TEST(ExportCommand, AHyphenIsStandardOutput) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n");
  EXPECT_EQ(flowcert({"surface", input, "-o", scratch.path("a.ply")}).status, 0);
  const Finished streamed = flowcert({"surface", input, "-o", "-"});
  EXPECT_EQ(streamed.status, 0) << streamed.err;
  EXPECT_EQ(streamed.out, content_of(scratch.path("a.ply")));
  EXPECT_FALSE(std::filesystem::exists("-"));
  const Finished both = flowcert({"surface", input, "-o", "-", "--json"});
  EXPECT_EQ(both.status, 2);
  EXPECT_EQ(both.err, "flowcert: -o - and --json would both write to standard output\n");
}

TEST(ExportCommand, SelectionsAreThoseOfThePairs) {
  CITES("FC-PERS-01", "FC-PERS-02");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(2, 60));
  const std::vector<Gap> gaps = gaps_of(input);
  const json all = surface(scratch, input, {});
  ASSERT_EQ(all["sets"], gaps.size());
  const Rational persistence(1, 100), radius(1, 4);
  const auto lasts = [&](const Gap& gap) { return gap.length > RootDifference{persistence * persistence}; };
  const auto is_small = [&](const Gap& gap) { return gap.squared_radius < radius * radius; };
  const auto both = [&](const Gap& gap) { return lasts(gap) && is_small(gap); };
  const auto counted = [&](const auto& holds) { return std::ranges::count_if(gaps, holds); };
  EXPECT_EQ(surface(scratch, input, {"persistence>0.01"})["selected"], counted(lasts));
  EXPECT_EQ(surface(scratch, input, {"index2-radius<1/4"})["selected"], counted(is_small));
  EXPECT_EQ(surface(scratch, input, {"index2-radius < 25e-2", "persistence > 1/100"})["selected"], counted(both));
  EXPECT_GT(counted(both), 0);
  EXPECT_LT(counted(both), std::min(counted(lasts), counted(is_small)));
}

TEST(ExportCommand, TheLargestGapsAreThoseAboveTheNext) {
  CITES("FC-PERS-01");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(3, 60));
  std::vector<Gap> gaps = gaps_of(input);
  std::ranges::sort(gaps, std::greater(), &Gap::length);
  ASSERT_GT(gaps.size(), 10U);
  const json ten = surface(scratch, input, {"largest-gaps=10"});
  const std::string file = content_of(scratch.path("surface.ply"));
  EXPECT_EQ(ten["selected"], 10);
  // The eleventh gap is not above itself.
  ASSERT_GT(gaps[9].length, gaps[10].length);
  const Rational between(
      std::nextafter(geometry::nearest_difference_of_roots(gaps[10].length.square, gaps[10].length.less), HUGE_VAL));
  ASSERT_GT(gaps[9].length, RootDifference{between * between});
  EXPECT_EQ(surface(scratch, input, {"persistence>" + to_text(between)})["selected"], 10);
  EXPECT_EQ(content_of(scratch.path("surface.ply")), file);
}

TEST(ExportCommand, ThresholdsAreExact) {
  CITES("FC-NUM-02");
  EXPECT_EQ(selected(kRadiusFive, {"index2-radius<5"}), 0U);
  EXPECT_EQ(selected(kRadiusFive, {"index2-radius<10/2"}), 0U);
  EXPECT_EQ(selected(kRadiusFive, {"index2-radius<5.0000000000000000000000000001"}), 1U);
  EXPECT_EQ(selected(kRadiusFive, {"index2-radius<-6"}), 0U);
  // The roots of 1/4, 1/2 and 3/4 differ by these: five tunnels, and the void.
  EXPECT_EQ(selected(kCube, {"persistence>0.20710678118654753"}), 0U);
  EXPECT_EQ(selected(kCube, {"persistence>0.20710678118654752"}), 5U);
  EXPECT_EQ(selected(kCube, {"persistence>0.15891862259789113"}), 5U);
  EXPECT_EQ(selected(kCube, {"persistence>0.15891862259789112"}), 6U);
  EXPECT_EQ(selected(kCube, {"persistence>-1"}), 6U);
}

TEST(ExportCommand, OfEqualGapsTheFirstOfTheListAreTaken) {
  CITES("FC-OUT-02");
  EXPECT_EQ(selected(kCube, {"largest-gaps=0"}), 0U);
  EXPECT_EQ(selected(kCube, {"largest-gaps=4"}), 4U);
  EXPECT_EQ(selected(kCube, {"largest-gaps=4", "largest-gaps=2"}), 2U);
  EXPECT_EQ(selected(kCube, {"largest-gaps=100"}), 6U);
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube), output = scratch.path("one.off");
  ASSERT_EQ(flowcert({"surface", input, "--select", "largest-gaps=1", "-o", output}).status, 0);
  const Words lines = lines_of(content_of(output));
  // The face of 0, 1, 2 and 3: z = 0. Four samples, four midpoints, the centre.
  ASSERT_EQ(lines.at(2), "9 8 0");
  for (std::size_t k = 3; k < 12; ++k) EXPECT_TRUE(lines.at(k).ends_with(" 0")) << lines[k];
}

// The squares of these radii and spacings are beyond the doubles, or 0 as doubles.
TEST(ExportCommand, TheTableHasRadiiWhoseSquaresAreBeyondDoubles) {
  const Scratch scratch;
  for (const auto& [unit, spacing] : {std::pair("e-170", "1e-170"), std::pair("e200", "1e+200")}) {
    std::string points;
    for (const char* row : {"0 0 0", "1U 0 0", "0 1U 0", "0 0 1U", "0.9U 0.9U 0.9U"}) {
      for (const char* c = row; *c != '\0'; ++c) points += *c == 'U' ? std::string(unit) : std::string(1, *c);
      points += '\n';
    }
    const Finished table = flowcert(
        {"surface", scratch.file("points.xyz", points), "--select", "index2-radius<q0.9", "-o", scratch.path("s.ply")});
    EXPECT_EQ(table.status, 0) << table.err;
    EXPECT_NE(table.out.find(std::string(spacing) + "   median of nearest neighbours"), std::string::npos) << table.out;
    EXPECT_EQ(table.out.find("inf"), std::string::npos) << table.out;
  }
}

TEST(ExportCommand, TheTableTellsWhatNoSurfaceShows) {
  CITES("FC-STAB-06");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kInterval);
  const json summary = json_of({"compute", input, "--manifolds", "s2", "--json"});
  ASSERT_GT(summary["s2"]["with_interval"], 0);
  EXPECT_EQ(surface(scratch, input, {})["with_interval"], summary["s2"]["with_interval"]);
  const Finished finished = flowcert({"surface", input, "-o", scratch.path("surface.off")});
  EXPECT_EQ(finished.status, 0) << finished.err;
  for (const char* row : {"surfaces S2", "selected", "triangles", "vertices", "with parts of dimension 3"}) {
    EXPECT_NE(finished.out.find(row), std::string::npos) << finished.out;
  }
}

TEST(ExportCommand, CheckReadsItsOwnCriticalPoints) {
  CITES("FC-CLAIM-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(4, 50)), files = scratch.path("files");
  ASSERT_EQ(flowcert({"compute", input, "--export", files}).status, 0);
  const json report = json_of({"check", input, files + "/critical_points.vtp", "--json"});
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["claimed"], report["critical"]);
}

TEST(ExportCommand, RefusesWhatIsNoSelection) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube), output = scratch.path("surface.ply");
  const auto refuses = [&](const std::string& selection, const std::string& what) {
    expect_refused({"surface", input, "-o", output, "--select", selection}, what);
  };
  refuses("persistence", "'persistence'");
  refuses("persistence<1", "persistence>X");
  refuses("persistence>=1", "not a number");
  refuses("persistence>", "not a number");
  refuses("persistence>1/0", "denominator is zero");
  refuses("persistence>nan", "nan");
  refuses("index2-radius<1 m", "'1m'");
  refuses("index2-radius<1e1000000", "exponent");
  refuses("index2-radius<spacing", "not a number");
  refuses("index2-radius<3spacing^2", "'3spacing^2'");
  refuses("persistence>3spacing^2", "not of its square: '3spacing^2'");
  refuses("index2-radius<q1.5", "'q1.5'");
  refuses("persistence>q-0.1", "no quantile from 0 to 1: 'q-0.1'");
  refuses("index2-radius<q", "not a number");
  refuses("index2-radius<automatic", "'automatic'");
  refuses("largest-gaps=auto", "'auto'");
  refuses("largest-gaps=-1", "'-1'");
  refuses("largest-gaps=1.5", "'1.5'");
  refuses("", "''");
  expect_refused({"surface", input}, "--output");
  expect_refused({"surface", input, "-o", scratch.path("surface.stl")}, ".ply or .off");
  expect_refused({"surface", scratch.path("none.xyz"), "-o", output}, "none.xyz");
  expect_refused({"surface", input, "-o", scratch.path("none/surface.ply")}, "cannot be written");
  EXPECT_EQ(scratch.names(), std::set<std::string>{"points.xyz"});
}

TEST(ExportCommand, WhatDoublesCannotSayLeavesNoFile) {
  CITES("FC-NUM-02");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kBeyondDoubles);
  expect_refused({"compute", input, "--export", scratch.path("files")}, "points.xyz: a coordinate");
  EXPECT_EQ(scratch.names(), std::set<std::string>{"points.xyz"});
  // A surface can be written: only the squared distances are too large.
  EXPECT_EQ(surface(scratch, input, {})["selected"], 1);
}

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

// Every file of `some` is in `whole`, with the same bytes.
void expect_to_be_in(const std::string& whole, const std::string& some) {
  for (const std::string& name : files_in(some)) {
    EXPECT_TRUE(content_of(fs::path(some) / name) == content_of(fs::path(whole) / name)) << name;
  }
}

TEST(ExportCommand, OnlyTheFilesThatAreAskedForAreMade) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(5, 40)), whole = scratch.path("whole");
  ASSERT_EQ(flowcert({"compute", input, "--export", whole}).status, 0);
  const std::set<std::string> all = {"critical_points.vtp", "stable_surfaces.ply", "stable_surfaces.vtp",
                                     "unstable_lines.vtp"};
  EXPECT_EQ(files_in(whole), all);
  const std::pair<std::string, std::set<std::string>> choices[] = {
      {"critical", {"critical_points.vtp"}},
      {"surfaces", {"stable_surfaces.ply", "stable_surfaces.vtp"}},
      {"lines", {"unstable_lines.vtp"}},
      {"lines,critical", {"critical_points.vtp", "unstable_lines.vtp"}},
      {"critical,surfaces,lines", all}};
  for (const auto& [only, names] : choices) {
    const std::string files = scratch.path(only);
    const json summary = json_of({"compute", input, "--export", files, "--only", only, "--json"});
    EXPECT_EQ(files_in(files), names);
    expect_to_be_in(whole, files);
    // Nothing else is computed.
    EXPECT_EQ(summary.contains("u2"), names.contains("unstable_lines.vtp")) << only;
    EXPECT_EQ(summary.contains("s2"), names.contains("stable_surfaces.vtp")) << only;
  }
  // What is computed for other reasons makes no file.
  const json summary =
      json_of({"compute", input, "--export", scratch.path("u2"), "--only", "critical", "--manifolds", "u2", "--json"});
  EXPECT_TRUE(summary.contains("u2"));
  EXPECT_EQ(files_in(scratch.path("u2")), std::set<std::string>{"critical_points.vtp"});
}

TEST(ExportCommand, TheWholeComplexHasFansAndCells) {
  CITES("FC-UNST-02", "FC-VOL-01");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube), whole = scratch.path("whole"),
                    some = scratch.path("some");
  ASSERT_EQ(flowcert({"compute", input, "--manifolds", "all", "--export", whole, "--threads", "3"}).status, 0);
  ASSERT_EQ(flowcert({"compute", input, "--export", some}).status, 0);
  std::set<std::string> names = files_in(some);
  EXPECT_EQ(names.size(), 4U);
  expect_to_be_in(whole, some);
  names.insert({"stable_cells.vtu", "unstable_fans.vtp"});
  EXPECT_EQ(files_in(whole), names);
  // Each of the twelve edges has a facet of two triangles that flow to the centre, with a pyramid on each side. The
  // rest of the facet flows to infinity. Points: samples, midpoints, centres of squares, and the centre.
  const auto says = [&](const std::string& name, const std::string& what) {
    EXPECT_NE(content_of(whole + "/" + name).find(what), std::string::npos) << name << ": " << what;
  };
  says("stable_cells.vtu", "<Piece NumberOfPoints=\"27\" NumberOfCells=\"48\">");
  says("unstable_fans.vtp",
       "<Piece NumberOfPoints=\"19\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
       "NumberOfPolys=\"24\">");
  for (const auto& [only, name] : {std::pair("cells", "stable_cells.vtu"), std::pair("fans", "unstable_fans.vtp")}) {
    const std::string files = scratch.path(only);
    ASSERT_EQ(flowcert({"compute", input, "--manifolds", "all", "--export", files, "--only", only}).status, 0);
    EXPECT_EQ(files_in(files), std::set<std::string>{name});
    expect_to_be_in(whole, files);
    expect_refused({"compute", input, "--export", scratch.path("none"), "--only", only},
                   "--only: " + std::string(only) + " needs --manifolds all");
  }
  EXPECT_FALSE(fs::exists(scratch.path("none")));
}

TEST(ExportCommand, UnstableSetsAndInfinityAreWrittenIfTheyAreNamed) {
  CITES("FC-UNST-04", "FC-STAB-08");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube);
  const std::set<std::string> sheets = {"unstable_surfaces.ply", "unstable_surfaces.vtp"};
  const auto files_of = [&](const std::string& only, const std::string& clip) {
    const std::string files = scratch.path(only + clip);
    EXPECT_EQ(
        flowcert({"compute", input, "--manifolds", "all", "--export", files, "--only", only, "--clip", clip}).status,
        0);
    return files;
  };
  const auto says = [&](const std::string& file, const std::string& what) {
    EXPECT_NE(content_of(file).find(what), std::string::npos) << file << ": " << what;
  };
  // The facets of the twelve edges are quarters of planes. In the box each is a square with two traces. The box cuts
  // three of its corners, and the fourth one is the cube's centre.
  const std::string cut = files_of("sheets", "3"), whole = files_of("sheets", "none");
  EXPECT_EQ(files_in(cut), sheets);
  says(cut + "/unstable_surfaces.vtp",
       "<Piece NumberOfPoints=\"48\" NumberOfVerts=\"0\" NumberOfLines=\"24\" NumberOfStrips=\"0\" "
       "NumberOfPolys=\"12\">");
  says(cut + "/unstable_surfaces.ply", "element vertex 48\n");
  says(cut + "/unstable_surfaces.ply", "element face 24\n");
  says(whole + "/unstable_surfaces.vtp", "NumberOfPoints=\"0\"");
  // Around the cube: from each sample to the sides of the box.
  EXPECT_EQ(files_in(files_of("infinity", "2")), std::set<std::string>{"infinity_cells.vtu"});
  says(files_of("infinity", "1") + "/infinity_cells.vtu", "NumberOfCells=\"0\"");
  for (const std::string only : {"sheets", "infinity"}) {
    expect_refused({"compute", input, "--export", scratch.path("none"), "--only", only},
                   "--only: " + only + " needs --manifolds all");
  }
  expect_refused(
      {"compute", input, "--manifolds", "all", "--export", scratch.path("none"), "--only", "cells", "--clip", "2"},
      "--clip: needs lines, infinity or sheets");
  EXPECT_FALSE(fs::exists(scratch.path("none")));
}

TEST(ExportCommand, UnstableSetsAreTheSameForAnyNumberOfThreads) {
  const Scratch scratch;
  // Enough for bytes that wait on disk.
  const std::string input = scratch.file("points.xyz", random_points(8, 400));
  const auto files_of = [&](const char* threads) {
    const std::string files = scratch.path(threads);
    EXPECT_EQ(flowcert({"compute", input, "--manifolds", "all", "--export", files, "--only", "sheets,infinity",
                        "--threads", threads})
                  .status,
              0);
    return files;
  };
  const std::string one = files_of("1"), three = files_of("3");
  EXPECT_EQ(files_in(one).size(), 3U);
  expect_to_be_in(three, one);
}

TEST(ExportCommand, AreTheSameForAnyNumberOfThreadsAndRuns) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(6, 60));
  const std::string one = scratch.path("one"), three = scratch.path("three");
  ASSERT_EQ(flowcert({"compute", input, "--export", one, "--threads", "1"}).status, 0);
  ASSERT_EQ(flowcert({"compute", input, "--export", three, "--threads", "3", "--runs", "2"}).status, 0);
  EXPECT_EQ(files_in(one), files_in(three));
  expect_to_be_in(three, one);
}

TEST(ExportCommand, WhatIsWrittenBeforeAnErrorStays) {
  CITES("FC-NUM-02");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kFarVertex), files = scratch.path("files");
  const std::set<std::string> before = {"critical_points.vtp", "stable_surfaces.ply", "stable_surfaces.vtp"};
  expect_refused({"compute", input, "--export", files, "--clip", "none", "-o", scratch.path("records")},
                 "unstable_lines.vtp is not written; written before: critical_points.vtp, stable_surfaces.ply, "
                 "stable_surfaces.vtp");
  EXPECT_EQ(files_in(files), before);
  // In the box there is nothing that doubles cannot say.
  EXPECT_EQ(flowcert({"compute", input, "--export", files}).status, 0);
  EXPECT_EQ(files_in(files).size(), 4U);
  // The file of an earlier run stays as well, when the new one cannot be made.
  const std::string lines = content_of(files + "/unstable_lines.vtp");
  expect_refused({"compute", input, "--export", files, "--only", "lines", "--clip", "none"}, "is not written\n");
  EXPECT_EQ(content_of(files + "/unstable_lines.vtp"), lines);
}

TEST(ExportCommand, LinesEndAtTheBoxThatIsAskedFor) {
  CITES("FC-FLOW-07");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", random_points(7, 40));
  const auto lines_of_clip = [&](const Words& clip) {
    Words words = {"compute", input, "--export", scratch.path("files"), "--only", "lines"};
    words.insert(words.end(), clip.begin(), clip.end());
    EXPECT_EQ(flowcert(words).status, 0);
    return content_of(scratch.path("files") + "/unstable_lines.vtp");
  };
  const std::string usual = lines_of_clip({});
  EXPECT_EQ(lines_of_clip({"--clip", "3"}), usual);
  EXPECT_EQ(lines_of_clip({"--clip", "6/2"}), usual);
  EXPECT_NE(lines_of_clip({"--clip", "3.5"}), usual);
  EXPECT_NE(usual.find("\"IsClipped\""), std::string::npos);
  EXPECT_EQ(lines_of_clip({"--clip", "none"}).find("\"IsClipped\""), std::string::npos);
}

TEST(ExportCommand, RefusesWhatIsNoBoxAndWhatNobodyExports) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube), files = scratch.path("files");
  const auto refuses = [&](Words words, const std::string& what) {
    words.insert(words.begin(), {"compute", input, "--export", files});
    expect_refused(words, what);
  };
  for (const char* clip : {"0.999", "-3", "1/2"}) refuses({"--clip", clip}, "neither a number from 1 nor none");
  for (const char* clip : {"all", "nan", "1e400", "1/0"}) refuses({"--clip", clip}, "--clip: ");
  refuses({"--clip", "2", "--only", "critical,surfaces"}, "--clip: needs lines");
  refuses({"--only", "points"}, "points not in");
  expect_refused({"compute", input, "--only", "lines"}, "--only requires --export");
  expect_refused({"compute", input, "--clip", "2"}, "--clip requires --export");
  EXPECT_EQ(scratch.names(), std::set<std::string>{"points.xyz"});
}

TEST(ExportCommand, AFolderThatCannotBeWrittenIsRefused) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kCube);
  expect_refused({"compute", input, "--export", input}, "Not a directory");
  expect_refused({"compute", input, "--export", input + "/below"}, "cannot be made");
  // A directory is where a file should be. The other files are whole, and nothing temporary is left.
  const fs::path files = scratch.path("files");
  fs::create_directories(files / "unstable_lines.vtp");
  expect_refused({"compute", input, "--export", files.string()}, "unstable_lines.vtp: cannot be written");
  expect_refused({"compute", input, "--export", files.string()},
                 "; written before: critical_points.vtp, stable_surfaces.ply, stable_surfaces.vtp");
  for (const auto& entry : fs::directory_iterator(files)) {
    EXPECT_EQ(entry.path().filename().string().find(".vtp."), std::string::npos) << entry.path();
  }
}

}  // namespace
}  // namespace flowcert::conformance::export_command_test
