// What `cycles --export` makes of loops and voids: the boundary of a surface's triangles is the loop, mod 2, and a void's
// surface is closed and has its volume inside.
#include "io/cycle_exports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace flowcert::cycle_exports_test {
namespace {

using Edges = std::set<std::pair<std::int64_t, std::int64_t>>;
using Integers = std::vector<std::int64_t>;

const Integers& integers(const std::vector<VtpArray>& arrays, const char* name) {
  const auto found = std::ranges::find(arrays, name, &VtpArray::name);
  return std::get<Integers>(found->values);
}

void toggle(Edges& edges, std::int64_t one, std::int64_t other) {
  const auto edge = std::minmax(one, other);
  if (!edges.erase(edge)) edges.insert(edge);
}

// The edges of lines, by pair and sample.
std::map<std::int64_t, Edges> edges_of_lines(const PolyData& data) {
  const Integers &samples = integers(data.point_data, "sample"), &pairs = integers(data.cell_data, "pair");
  std::map<std::int64_t, Edges> edges;
  std::size_t first = 0;
  for (std::size_t cell = 0; cell < data.lines.offsets.size(); ++cell) {
    const auto last = static_cast<std::size_t>(data.lines.offsets[cell]);
    const auto sample = [&](std::size_t k) { return samples[static_cast<std::size_t>(data.lines.connectivity[k])]; };
    for (std::size_t k = first; k + 1 < last; ++k) toggle(edges[pairs[cell]], sample(k), sample(k + 1));
    first = last;
  }
  return edges;
}

// The boundaries of triangles mod 2. They have both halves of each edge, to its midpoint.
std::map<std::int64_t, Edges> edges_of_triangles(const PolyData& data) {
  const Integers &samples = integers(data.point_data, "sample"), &pairs = integers(data.cell_data, "pair");
  std::map<std::int64_t, Edges> halves, edges;
  for (std::size_t cell = 0; cell < pairs.size(); ++cell) {
    const auto corner = [&](std::size_t k) { return data.polygons.connectivity[3 * cell + k % 3]; };
    for (std::size_t k = 0; k < 3; ++k) toggle(halves[pairs[cell]], corner(k), corner(k + 1));
  }
  for (const auto& [pair, some] : halves) {
    std::map<std::int64_t, Integers> ends;  // by midpoint
    for (const auto& [one, other] : some) {
      const std::int64_t a = samples[static_cast<std::size_t>(one)], b = samples[static_cast<std::size_t>(other)];
      EXPECT_NE(a < 0, b < 0);
      ends[a < 0 ? one : other].push_back(a < 0 ? b : a);
    }
    for (const auto& [midpoint, both] : ends) {
      EXPECT_EQ(both.size(), 2U);
      toggle(edges[pair], both.front(), both.back());
    }
  }
  return edges;
}

struct Seen {
  std::size_t loops = 0, triangles = 0, voids = 0, inner = 0, beyond_doubles = 0;
};

void expect_loops(const FlowComplex& complex, const CycleLevel& level, Seen& seen) {
  CycleChoice choice;
  choice.level = level;
  choice.longer_than = LengthBound{};
  const std::vector<Cycle> found = cycles(complex, choice);
  const PolyData loops = loop_data(complex, found), surfaces = loop_surface_data(complex, found);
  std::map<std::int64_t, Edges> expected;
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const std::uint32_t edge : std::get<LoopCycle>(found[k].chain).edges) {
      const auto ends = complex.stationary().contact(edge);
      expected[static_cast<std::int64_t>(k)].emplace(ends[0], ends[1]);
    }
  }
  EXPECT_EQ(edges_of_lines(loops), expected);
  EXPECT_EQ(edges_of_triangles(surfaces), expected);
  seen.loops += found.size();
  seen.triangles += surfaces.polygons.offsets.size();
}

double enclosed(const CellSurface& surface) {
  double volume = 0;
  const Point& o = surface.vertices.front();
  for (const auto& [a, b, c] : surface.triangles) {
    const auto from = [&](std::uint32_t v) {
      return std::array{surface.vertices[v].x - o.x, surface.vertices[v].y - o.y, surface.vertices[v].z - o.z};
    };
    const auto p = from(a), q = from(b), r = from(c);
    volume +=
        p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return volume / 6;
}

void expect_voids(const FlowComplex& complex, Seen& seen) {
  CycleChoice choice;
  choice.dimension = 2;
  choice.longer_than = LengthBound{};
  choice.level = {CycleLevel::Kind::kShare, 0};
  const std::vector<Cycle> found = cycles(complex, choice);
  const std::vector<CellSurface> surfaces = void_surfaces(complex, found);
  const UnstructuredGrid grid = void_data(complex, found);
  std::set<std::int64_t> in_grid;
  for (const std::int64_t pair : integers(grid.cell_data, "pair")) in_grid.insert(pair);
  EXPECT_EQ(in_grid.size(), found.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
    for (const auto& triangle : surfaces[k].triangles) {
      for (std::size_t side = 0; side < 3; ++side) ++passed[{triangle[side], triangle[(side + 1) % 3]}];
    }
    for (const auto& [edge, times] : passed) EXPECT_EQ((passed[{edge.second, edge.first}]), times);
    const Void& space = std::get<Void>(found[k].chain);
    const double volume = complex.volumes().nearest_sum(space.cell);
    EXPECT_NEAR(enclosed(surfaces[k]), volume, 1e-6 * volume);
    // A pair's void is in those of other ones.
    for (const Cycle& other : found) {
      const Void& outer = std::get<Void>(other.chain);
      seen.inner += outer.cell.size() > space.cell.size() && std::ranges::includes(outer.cell, space.cell) ? 1 : 0;
    }
  }
  seen.voids += found.size();
}

TEST(CycleExports, SurfacesEndAtLoopsAndVoidsAreClosed) {
  CITES("FC-CYC-04", "FC-CYC-06", "FC-CHAIN-02", "FC-VOL-01");
  Seen seen;
  const auto expect_right = [&](const auto& rows) {
    const FlowComplex complex(PointSet(property::rows_of(fuzz::Input{.rows = rows})));
    using enum CycleLevel::Kind;
    for (const CycleLevel& level : {CycleLevel{kShare, 0}, CycleLevel{}, CycleLevel{kDeath, 0}}) {
      expect_loops(complex, level, seen);
    }
    expect_voids(complex, seen);
  };
  flowcert_tests::for_each_drawn_set({.seeds = 4, .made = 2, .most_rows = 40}, [&](const auto& rows, std::uint64_t) {
    try {
      expect_right(rows);
    } catch (const InvalidInput&) {
      ++seen.beyond_doubles;
    }
  });
  flowcert_tests::for_each_grid(expect_right);
  EXPECT_GT(seen.loops, 1000U);
  EXPECT_GT(seen.triangles, 10000U);
  EXPECT_GT(seen.voids, 200U);
  EXPECT_GT(seen.inner, 10U);
  EXPECT_LT(seen.beyond_doubles, 5U);
}

}  // namespace
}  // namespace flowcert::cycle_exports_test
