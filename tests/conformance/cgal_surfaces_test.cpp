// The PLY and OFF files of `flowcert compute --export` and `flowcert surface`, opened by CGAL's readers.
//
// Guarantees: counts are those that the command prints; both formats hold the same doubles and triangles; a
// sphere that is reconstructed is closed.
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::cgal_surfaces_test {
namespace {

using nlohmann::json;
using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;

struct Soup {
  std::vector<CgalPoint> points;
  std::vector<std::vector<std::size_t>> polygons;
  friend bool operator==(const Soup&, const Soup&) = default;
};

Soup ply_of(const std::string& path) {
  Soup soup;
  EXPECT_TRUE(CGAL::IO::read_PLY(path, soup.points, soup.polygons));
  return soup;
}

Soup off_of(const std::string& path) {
  Soup soup;
  EXPECT_TRUE(CGAL::IO::read_OFF(path, soup.points, soup.polygons));
  return soup;
}

void expect_triangles_of(const Soup& soup, const json& counts, const std::string& name) {
  EXPECT_EQ(soup.points.size(), counts["vertices"]) << name;
  EXPECT_EQ(soup.polygons.size(), counts["triangles"]) << name;
  std::vector<bool> is_used(soup.points.size(), false);
  for (const auto& polygon : soup.polygons) {
    ASSERT_EQ(polygon.size(), 3U) << name;
    for (const std::size_t vertex : polygon) is_used.at(vertex) = true;
  }
  EXPECT_EQ(std::ranges::count(is_used, false), 0) << name;
  for (const CgalPoint& point : soup.points) {
    EXPECT_TRUE(std::isfinite(point.x()) && std::isfinite(point.y()) && std::isfinite(point.z())) << name;
  }
}

std::string lattice() {
  std::string text;
  for (int k = 0; k < 27; ++k) {
    text += std::to_string(k / 9) + " " + std::to_string(k / 3 % 3) + " " + std::to_string(k % 3) + "\n";
  }
  return text;
}

// Points on a spiral around the unit sphere, rounded to decimals.
std::string spiral() {
  std::string text;
  for (int k = 0; k < 150; ++k) {
    const double z = (k + 0.5) / 75 - 1, r = std::sqrt(1 - z * z), angle = 2.4 * k;
    text += std::to_string(r * std::cos(angle)) + " " + std::to_string(r * std::sin(angle)) + " " + std::to_string(z) +
            "\n";
  }
  return text;
}

TEST(CgalSurfaces, ReadsPlyAndOffAlike) {
  CITES("FC-STAB-04");
  const std::vector<std::pair<std::string, std::string>> inputs = {
      {"one point", "1 2 3\n"},
      {"collinear", "0 0 0\n1 1 1\n3 3 3\n"},
      {"coplanar", "0 0 0\n4 0 0\n1 3 0\n5 3.5 0\n"},
      {"lattice", lattice()},
      {"interval", "-2 0 0\n2 0 0\n0 -1 1\n0 -1 -1\n0 5 0\n"},
      {"spiral", spiral()}};
  for (const auto& [name, points] : inputs) {
    const Scratch scratch;
    const std::string input = scratch.file("points.xyz", points), ply = scratch.path("surface.ply"),
                      off = scratch.path("surface.off"), files = scratch.path("files");
    for (const std::string& output : {ply, off}) {
      const Finished finished = flowcert({"surface", input, "-o", output, "--json"});
      ASSERT_EQ(finished.status, 0) << finished.err;
      expect_triangles_of(output == ply ? ply_of(ply) : off_of(off), json::parse(finished.out), name);
    }
    ASSERT_EQ(flowcert({"compute", input, "--export", files}).status, 0);
    EXPECT_EQ(ply_of(ply), off_of(off)) << name;
    EXPECT_EQ(ply_of(ply), ply_of(files + "/stable_surfaces.ply")) << name;
  }
}

// The paper's use: the S2 of small circles among samples of a sphere are the sphere again.
TEST(CgalSurfaces, SmallRadiiReconstructASphere) {
  CITES("FC-STAB-06", "FC-STAB-07");
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", spiral()), output = scratch.path("surface.ply");
  ASSERT_EQ(flowcert({"surface", input, "--select", "index2-radius<0.5", "-o", output}).status, 0);
  const Soup soup = ply_of(output);
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const auto& triangle : soup.polygons) {
    for (std::size_t k = 0; k < 3; ++k) ++sides[std::minmax(triangle[k], triangle[(k + 1) % 3])];
  }
  EXPECT_GT(soup.polygons.size(), 500U);
  EXPECT_TRUE(std::ranges::all_of(sides, [](const auto& side) { return side.second == 2; }));
  EXPECT_EQ(soup.points.size() - sides.size() + soup.polygons.size(), 2U);
}

}  // namespace
}  // namespace flowcert::conformance::cgal_surfaces_test
