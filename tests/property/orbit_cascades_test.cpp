// Orbits that cross fifty facets and more, fast against oracle. Inputs of a dozen points have none.
//
// Guarantees: equality of all segments, as orbit_comparison.h says, for all kernels and both searches. The
// test fails too when the inputs no longer make long orbits, or none that crosses a facet of high degree.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "flowcert/unstable_manifolds.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/orbit_comparison.h"
#include "oracle/orbit.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::orbit_cascades_test {
namespace {

constexpr std::array<FlowOptions, 6> kAllWays = {{{ConstructionKernel::kCascade, FacetSearch::kBinary},
                                                  {ConstructionKernel::kCascade, FacetSearch::kLinear},
                                                  {ConstructionKernel::kLazy, FacetSearch::kBinary},
                                                  {ConstructionKernel::kLazy, FacetSearch::kLinear},
                                                  {ConstructionKernel::kExact, FacetSearch::kBinary},
                                                  {ConstructionKernel::kExact, FacetSearch::kLinear}}};

std::size_t facets_crossed(const OrbitRecord& orbit) {
  return static_cast<std::size_t>(std::count_if(orbit.segments.begin(), orbit.segments.end(),
                                                [](const SegmentRecord& s) { return s.type[2] == 'F'; }));
}

// Returns how many facets the longest of the orbits crosses.
std::size_t expect_orbits_agree(const Subject& subject, const std::vector<RationalPoint>& starts) {
  std::size_t longest = 0;
  std::vector<Flow> flows;
  flows.reserve(std::size(kAllWays));
  for (const FlowOptions& way : kAllWays) flows.emplace_back(subject.complex.diagram(), way);
  for (const RationalPoint& x : starts) {
    const OrbitRecord expected = record_of(subject.set, x, oracle::orbit(subject.set, x));
    longest = std::max(longest, facets_crossed(expected));
    for (std::size_t k = 0; k < flows.size(); ++k) {
      EXPECT_EQ(difference(record_of(flows[k].orbit(x)), expected), "") << "way " << k << ", " << to_text(x);
    }
  }
  return longest;
}

// Compares both orbits of every `step`-th saddle, by lazy constructions and by the cascade kernel. Returns how many
// facets the longest one crosses.
std::size_t expect_manifolds_agree(const Subject& subject, std::size_t step) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const auto manifolds_by = [&](ConstructionKernel kernel) {
    return UnstableManifolds(subject.complex.diagram(), stationary, {kernel, FacetSearch::kBinary});
  };
  UnstableManifolds manifolds = manifolds_by(ConstructionKernel::kLazy);
  UnstableManifolds cascade = manifolds_by(ConstructionKernel::kCascade);
  std::size_t longest = 0;
  for (std::size_t i = 0; i < manifolds.size(); i += step) {
    const auto contact = stationary.contact(manifolds.saddle(i));
    const ExactSphere sphere = exact_sphere(subject.complex.points(), contact);
    const oracle::StationaryPoint saddle{sphere.center, sphere.squared_radius, {contact.begin(), contact.end()}, 2, 2};
    for (int side = 0; side < 2; ++side) {
      const OrbitRecord expected =
          record_of(subject.set, saddle.center, oracle::unstable_orbit(subject.set, saddle, side));
      longest = std::max(longest, facets_crossed(expected));
      for (UnstableManifolds* each : {&manifolds, &cascade}) {
        EXPECT_EQ(difference(record_of(each->orbit(i, static_cast<std::size_t>(side))), expected), "")
            << "saddle " << i << ", side " << side << (each == &cascade ? ", by the cascade kernel" : ", lazy");
      }
    }
  }
  return longest;
}

TEST(OrbitCascades, AlongACascadeBuiltForIt) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const fuzz::Input input = fuzz::long_cascade(80, seed);
    const Subject subject(input);
    const RationalPoint m = exact_sphere(subject.complex.points(), std::vector<PointId>{0, 1}).center;
    EXPECT_GE(expect_orbits_agree(subject, {{m[0] + 1, m[1], m[2]}, {m[0] + Rational(1) / 7, m[1], m[2]}}), 50u);
    EXPECT_GE(expect_manifolds_agree(subject, 1), 50u);
  }
}

TEST(OrbitCascades, InsideAHalfShell) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07");
  const fuzz::Input input = fuzz::half_shell(1000, 1);
  const Subject subject(input);
  EXPECT_GE(expect_manifolds_agree(subject, 23), 20u);
}

// The starts are on rays from the origin, which is the edge's midpoint, through every third neighbour. On
// each ray one start is before the neighbour, and one is beyond it.
TEST(OrbitCascades, AcrossAFacetOfHighDegree) {
  CITES("FC-FLOW-02");
  for (const bool perturbed : {false, true}) {
    const fuzz::Input input = fuzz::high_degree_facet(120, perturbed, 5);
    const Subject subject(input);
    std::vector<RationalPoint> starts;
    for (std::size_t k = 2; k < input.rows.size() && starts.size() < 40; k += 3) {
      const RationalPoint q{Rational(input.rows[k][0]), Rational(input.rows[k][1]), Rational(input.rows[k][2])};
      starts.push_back({q[0] * 3 / 4, q[1] * 3 / 4, q[2] * 3 / 4});
      starts.push_back({q[0] * 7 / 5, q[1] * 7 / 5, q[2] * 7 / 5});
    }
    EXPECT_GE(expect_orbits_agree(subject, starts), 1u);
    EXPECT_GE(expect_manifolds_agree(subject, 5), 1u);
  }
}

}  // namespace
}  // namespace flowcert::property::orbit_cascades_test
