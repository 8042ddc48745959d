// `flowcert surface` without units: what its thresholds come to, what it counts, and the histogram from which one
// chooses (src/cli/manual/surfaces.md). Thresholds in units are in export_command_test.cpp.
//
// Guarantees: numbers are worked out by hand on small inputs; those of JSON and of the table are the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::surface_command_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

// The squares of a lattice of unit cubes have radius sqrt(1/2), and its spacing is 1.
constexpr char kTwoCubes[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n0 0 2\n1 0 2\n0 1 2\n1 1 2\n";
// With sides of length 6, 8 and 10.
constexpr char kTriangle[] = "0 0 0\n6 0 0\n0 8 0\n";

// 25 squares of side 1, and far from them 16 squares of side 10.
std::string fine_and_coarse_lattice() {
  std::string points;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) points += fmt::format("{} {} 0\n", x, y);
  }
  for (int x = -20; x <= 20; x += 10) {
    for (int y = -20; y <= 20; y += 10) points += fmt::format("{} {} 400\n", x, y);
  }
  return points;
}

json surface_json(const Scratch& scratch, const std::string& input, const Words& selections) {
  Words words = {"surface", input, "-o", scratch.path("surface.ply"), "--json"};
  for (const std::string& selection : selections) words.insert(words.end(), {"--select", selection});
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  json object = json::parse(finished.out, nullptr, false);
  EXPECT_TRUE(object.is_object()) << finished.out;
  return object.is_object() ? object : json::object();
}

TEST(SurfaceCommand, ThresholdsWithoutUnitsAreExact) {
  CITES("FC-NUM-01", "FC-NUM-02");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kTwoCubes);
  const json all = surface_json(scratch, input, {});
  ASSERT_EQ(all["sets"], 11);
  EXPECT_EQ(all["squared_spacing"], "1");
  EXPECT_TRUE(all["squared_radius_below"].is_null());
  EXPECT_TRUE(all["squared_persistence_above"].is_null());
  // The root of 1/2 is between these.
  EXPECT_EQ(surface_json(scratch, input, {"index2-radius<0.70710678118654752spacing"})["selected"], 0);
  const json above = surface_json(scratch, input, {"index2-radius<0.70710678118654753spacing"});
  EXPECT_EQ(above["selected"], 11);
  EXPECT_DOUBLE_EQ(above["squared_radius_below_double"], 0.5);
  EXPECT_EQ(surface_json(scratch, input, {"persistence>0.20710678118654753spacing"})["selected"], 0);
  EXPECT_EQ(surface_json(scratch, input, {"persistence>0.20710678118654752spacing"})["selected"], 9);
  EXPECT_EQ(surface_json(scratch, input, {"persistence>0.15891862259789113spacing"})["selected"], 9);
  EXPECT_EQ(surface_json(scratch, input, {"persistence>0.15891862259789112spacing"})["selected"], 11);
  // Nine tunnels and two voids are between these, by the roots of 1/4, 1/2 and 3/4. Equal ones are chosen together.
  EXPECT_EQ(surface_json(scratch, input, {"index2-radius<q0.99"})["selected"], 0);
  EXPECT_EQ(surface_json(scratch, input, {"index2-radius<q0.99"})["squared_radius_below"], "1/2");
  EXPECT_EQ(surface_json(scratch, input, {"index2-radius<q1"})["selected"], 11);
  EXPECT_EQ(surface_json(scratch, input, {"persistence>q0"})["selected"], 11);
  EXPECT_EQ(surface_json(scratch, input, {"persistence>q0.01"})["selected"], 9);
  // Without a gap there is no threshold.
  EXPECT_EQ(surface_json(scratch, input, {"index2-radius<auto", "persistence>auto"})["selected"], 11);
  EXPECT_TRUE(surface_json(scratch, input, {"index2-radius<auto"})["squared_radius_below"].is_null());
}

TEST(SurfaceCommand, TheSpacingIsTheMedianOfNeighbours) {
  const Scratch scratch;
  // The nearest neighbours are at 6, 6 and 8.
  EXPECT_EQ(surface_json(scratch, scratch.file("three.xyz", kTriangle), {})["squared_spacing"], "36");
  // At 1, 1, 2, 4: the lesser of the two in the middle. Repeated points are one.
  const std::string four = scratch.file("four.xyz", "0 0 0\n1 0 0\n3 0 0\n7 0 0\n7 0 0\n7 0 0\n");
  EXPECT_EQ(surface_json(scratch, four, {})["squared_spacing"], "1");
  const json one = surface_json(scratch, scratch.file("one.xyz", "1 2 3\n"), {"index2-radius<3spacing"});
  EXPECT_TRUE(one["squared_spacing"].is_null());
  EXPECT_EQ(one["radii"], json::array());
}

TEST(SurfaceCommand, AutoPartsASurfaceFromTheWholeShape) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", fine_and_coarse_lattice());
  const json chosen = surface_json(scratch, input, {"index2-radius<auto"});
  // The squares of the fine lattice.
  EXPECT_EQ(chosen["selected"], 25);
  EXPECT_GT(chosen["sets"], 25);
  EXPECT_EQ(chosen["edges"]["without_orientation"], 0);
  EXPECT_EQ(chosen["edges"]["components"], 1);
  EXPECT_EQ(chosen["edges"]["not_manifold"], 0);
  EXPECT_EQ(chosen["edges"]["boundary"], 40);
  EXPECT_EQ(chosen["edges"]["manifold"], (3 * chosen["triangles"].get<int>() - 40) / 2);
}

TEST(SurfaceCommand, EdgesBetweenSeveralSurfacesAreNotManifold) {
  CITES("FC-STAB-04");
  const Scratch scratch;
  const json cubes = surface_json(scratch, scratch.file("points.xyz", kTwoCubes), {});
  // Each square has four corners, four midpoints and a centre; the halves of four edges are on three squares.
  EXPECT_EQ(cubes["triangles"], 88);
  EXPECT_EQ(cubes["edges"]["not_manifold"], 8);
  EXPECT_EQ(cubes["edges"]["boundary"], 0);
  EXPECT_EQ(cubes["edges"]["manifold"], (3 * 88 - 3 * 8) / 2);
  EXPECT_EQ(cubes["edges"]["without_orientation"], 0);
  // Two boxes without a lid, and the lid between them.
  EXPECT_EQ(cubes["edges"]["components"], 3);
}

// "< 0.5" behind the bar that has the threshold.
TEST(SurfaceCommand, TheTableShowsTheHistogramAndMarksTheThreshold) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", fine_and_coarse_lattice());
  const json answer = surface_json(scratch, input, {"index2-radius<auto"});
  const Finished finished =
      flowcert({"surface", input, "-o", scratch.path("surface.ply"), "--select", "index2-radius<auto"});
  ASSERT_EQ(finished.status, 0) << finished.err;
  const std::regex row("^ +([0-9.e+-]+) +([0-9.e+-]+) +([0-9,]+)( +#+)?( +< ([0-9.e+-]+))?$");
  std::size_t bin = 0, sum = 0, marks = 0;
  for (const std::string& line : lines_of(finished.out)) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    const json& expected = answer["radii"].at(bin++);
    EXPECT_DOUBLE_EQ(std::stod(found[1]), expected["from"]);
    EXPECT_DOUBLE_EQ(std::stod(found[2]), expected["to"]);
    EXPECT_EQ(std::stoul(found[3]), expected["count"]);
    EXPECT_EQ(found[4].matched, expected["count"] > 0) << line;
    sum += expected["count"].get<std::size_t>();
    if (!found[5].matched) continue;
    ++marks;
    const double threshold = std::sqrt(answer["squared_radius_below_double"].get<double>());
    EXPECT_NEAR(std::stod(found[6]), threshold, 1e-4 * threshold);
    EXPECT_LE(expected["from"], threshold);
    EXPECT_GT(expected["to"], threshold);
  }
  EXPECT_EQ(bin, answer["radii"].size());
  EXPECT_EQ(sum, answer["sets"]);
  EXPECT_EQ(marks, 1U);
  for (const char* name : {"edges of two triangles", "edges of one", "edges of more than two", "components",
                           "components without orientation", "spacing", "radii below"}) {
    EXPECT_NE(finished.out.find(std::string("\n") + name + " "), std::string::npos) << name;
  }
}

TEST(SurfaceCommand, RadiiOfAllSizesHaveAFewBins) {
  const Scratch scratch;
  // Triangles far from each other.
  std::string points;
  for (int k = -290; k <= 140; k += 10) {
    const std::string e = "e" + std::to_string(k);
    points += "10" + e + " 0 0\n11" + e + " 0 0\n10.5" + e + " 0.9" + e + " 0\n";
  }
  const json answer = surface_json(scratch, scratch.file("points.xyz", points), {});
  EXPECT_LE(answer["radii"].size(), 30U);
  EXPECT_GE(answer["radii"].size(), 5U);
  std::size_t sum = 0;
  for (const json& bin : answer["radii"]) sum += bin["count"].get<std::size_t>();
  EXPECT_EQ(sum, answer["sets"]);
  EXPECT_GE(sum, 44U);
}

}  // namespace
}  // namespace flowcert::conformance::surface_command_test
