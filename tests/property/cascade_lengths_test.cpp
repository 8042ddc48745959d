// Cascades of 10 to 10,000 crossings: they have the length that they are made for, all kernels follow them to the same
// end, and none exhausts the stack. The short ones are those of the oracle, segment by segment.
//
// Guarantees: the kernel of plain rationals goes to 100 crossings here, and CGAL's lazy one to 1,000;
// longest_cascades_test goes further.
#include <gtest/gtest.h>

#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/orbit_comparison.h"
#include "oracle/orbit.h"
#include "tests/cites.h"
#include "tests/property/cascade_of_length.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::cascade_lengths_test {
namespace {

TEST(CascadeLengths, AllKernelsFollowThem) {
  CITES("FC-NUM-01", "FC-FLOW-05", "FC-STAB-06");
  for (const std::size_t length : {10U, 100U, 1000U, 10000U}) {
    SCOPED_TRACE(length);
    const CascadeOfLength expected(length, ConstructionKernel::kCascade);
    EXPECT_GE(expected.u2().n_wcc.max(), length);
    // From the wide end of the strip to the narrow one.
    EXPECT_EQ(expected.complex.stable().statistics().n_s2.max(), expected.complex.points().size() - 3);
    if (length <= 1000) expect_the_same(expected, CascadeOfLength(length, ConstructionKernel::kLazy));
    if (length <= 100) expect_the_same(expected, CascadeOfLength(length, ConstructionKernel::kExact));
  }
}

TEST(CascadeLengths, TheOracleFollowsTheShortOnes) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07");
  for (const std::size_t length : {10U, 30U}) {
    const fuzz::Input input = fuzz::long_cascade(points_of_cascade(length), 1);
    const Subject subject(input);
    const StationaryPoints& stationary = subject.complex.stationary();
    for (const ConstructionKernel kernel :
         {ConstructionKernel::kCascade, ConstructionKernel::kLazy, ConstructionKernel::kExact}) {
      const UnstableManifolds manifolds(subject.complex.diagram(), stationary, {kernel, FacetSearch::kBinary});
      ASSERT_GE(manifolds.statistics().n_wcc.max(), length);
      for (std::size_t i = 0; i < manifolds.size(); ++i) {
        const auto contact = stationary.contact(manifolds.saddle(i));
        const ExactSphere sphere = exact_sphere(subject.complex.points(), contact);
        const oracle::StationaryPoint saddle{
            sphere.center, sphere.squared_radius, {contact.begin(), contact.end()}, 2, 2};
        for (int side = 0; side < 2; ++side) {
          const OrbitRecord orbit =
              record_of(subject.set, saddle.center, oracle::unstable_orbit(subject.set, saddle, side));
          EXPECT_EQ(difference(record_of(manifolds.orbit(i, static_cast<std::size_t>(side))), orbit), "");
        }
      }
    }
  }
}

}  // namespace
}  // namespace flowcert::property::cascade_lengths_test
