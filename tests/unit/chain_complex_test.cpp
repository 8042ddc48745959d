// The chain complex of the critical points, cell by cell. A boundary is modulo 2 and of the index below. The
// boundary of a maximum is made of the index-2 points that have the maximum on exactly one side.
//
// (tests/property/persistence_test.cpp tests that its persistence is right.)
#include "flowcert/chain_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
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
