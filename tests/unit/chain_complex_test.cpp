// The chain complex of the critical points, cell by cell. A boundary is modulo 2 and of the index below. The
// boundary of a maximum is made of the index-2 points that have the maximum on exactly one side.
//
// (tests/property/persistence_test.cpp tests that its persistence is right.)
#include "flowcert/chain_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::chain_complex_test {
namespace {

struct Seen {
  std::size_t maxima = 0, equal_limits = 0;
};

void expect_boundaries(const StationaryPoints& stationary, const UnstableManifolds& unstable,
                       const ChainComplex& complex, Seen& seen) {
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    if (!index.is_critical()) break;
    const auto given = complex.boundary(static_cast<std::uint32_t>(record));
    std::vector<std::uint32_t> boundary(given.begin(), given.end());
    std::sort(boundary.begin(), boundary.end());
    EXPECT_EQ(std::adjacent_find(boundary.begin(), boundary.end()), boundary.end()) << "twice in a boundary";
    for (const std::uint32_t face : boundary) {
      EXPECT_EQ(stationary.index(face).face_dimension + 1, index.face_dimension);
    }
    if (index != StationaryIndex{3, 3}) continue;
    std::vector<std::uint32_t> expected;
    for (std::size_t i = 0; i < unstable.size(); ++i) {
      const auto& limits = complex.limits()[i];
      const auto sides = std::count(limits.begin(), limits.end(), static_cast<std::uint32_t>(record));
      if (sides == 1) expected.push_back(static_cast<std::uint32_t>(unstable.saddle(i)));
      seen.equal_limits += sides == 2 ? 1 : 0;
    }
    EXPECT_EQ(boundary, expected);
    ++seen.maxima;
  }
}

void expect_boundaries_of(const std::vector<Point>& rows, std::uint64_t seed, Seen& seen) {
  const FlowComplex complex(PointSet(rows), {.seed = seed});
  expect_boundaries(complex.stationary(), complex.unstable(), complex.chains(), seen);
}

TEST(ChainComplex, BoundariesOfDegenerateInputsAreModuloTwo) {
  CITES("FC-CHAIN-01", "FC-CHAIN-02", "FC-CHAIN-04");
  Seen seen;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const fuzz::Input input = fuzz::draw(family, seed, static_cast<int>(20 + 4 * seed));
      expect_boundaries_of(property::rows_of(input), seed, seen);
    }
  }
  EXPECT_GT(seen.maxima, 100u);
}

// A sample, or the contact set of an end, or a front by its place.
using Corner = std::pair<int, std::vector<std::uint32_t>>;
using Edges = std::set<std::pair<Corner, Corner>>;

void add_edge(Edges& edges, const Corner& one, const Corner& other) {
  const auto edge = std::minmax(one, other);
  if (!edges.erase(edge)) edges.insert(edge);
}

Corner corner_of(const RoundedSegments& set, std::uint32_t place) {
  const auto& end = set.positions[place].end;
  return end.empty() ? Corner{2, {place}} : Corner{1, end};
}

// The boundary of two triangles for each segment, mod 2.
Edges edges_of(const RoundedSegments& set) {
  Edges edges;
  for (const auto& [samples, front, back] : set.segments) {
    const Corner from = corner_of(set, front), to = corner_of(set, back);
    for (const PointId sample : samples) {
      add_edge(edges, {0, {sample}}, from);
      add_edge(edges, {0, {sample}}, to);
      add_edge(edges, from, to);
    }
  }
  return edges;
}

// Each edge of the boundary has its midpoint as a corner.
TEST(ChainComplex, TrianglesEndAtTheBoundaryHoweverTiesAreBroken) {
  CITES("FC-CHAIN-01", "FC-CHAIN-02");
  std::size_t tied = 0, larger = 0;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const fuzz::Input input = fuzz::draw(family, seed, static_cast<int>(100 + 20 * seed));
      const FlowComplex complex(property::point_set_of(input), {.seed = seed % 4});
      const StableManifolds& stable = complex.stable();
      for (std::size_t i = 0; i < complex.stationary().critical_counts()[2]; ++i) {
        Edges expected;
        for (const std::uint32_t edge : stable.boundary(i)) {
          const auto ends = complex.stationary().contact(edge);
          for (const PointId sample : ends) add_edge(expected, {0, {sample}}, {1, {ends.begin(), ends.end()}});
        }
        const RoundedSegments walked = stable.segments_to_boundary(i);
        EXPECT_EQ(edges_of(walked), expected) << family.name << ", seed " << seed << ", set " << i;
        const std::size_t whole = edges_of(stable.rounded_segments(i)).size();
        tied += stable.has_vertex(i) ? 1 : 0;
        larger += whole != expected.size() ? 1 : 0;
      }
    }
  }
  EXPECT_GT(tied, 50U);
  EXPECT_GT(larger, 20U) << "otherwise whole skeletons would do";
}

// Larger inputs have voids that go around something and come back to one surface from both sides.
TEST(ChainComplex, BoundariesOfLargerInputsAreModuloTwo) {
  CITES("FC-CHAIN-01");
  flowcert_tests::PortableRandom random(3);
  Seen seen;
  for (int input = 0; input < 16; ++input) {
    std::vector<Point> rows(250);
    for (Point& p : rows) p = {random.coordinate(), random.coordinate(), random.coordinate()};
    expect_boundaries_of(rows, 0, seen);
  }
  EXPECT_GT(seen.maxima, 100u);
  EXPECT_GT(seen.equal_limits, 1u) << "otherwise nothing of this was tested";
}

}  // namespace
}  // namespace flowcert::chain_complex_test
