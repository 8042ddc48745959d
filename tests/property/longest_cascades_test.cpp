// Cascades that take minutes: CGAL's lazy kernel on 3,000 crossings, where it has to cut its chains, and the kernel of
// plain rationals on 1,000. A slow test (./dev test --slow).
#include <gtest/gtest.h>

#include "tests/cites.h"
#include "tests/property/cascade_of_length.h"

namespace flowcert::property::longest_cascades_test {
namespace {

TEST(LongestCascades, TheLazyKernelCutsItsChains) {
  CITES("FC-NUM-01", "FC-FLOW-05");
  const CascadeOfLength lazy(3000, ConstructionKernel::kLazy);
  EXPECT_GE(lazy.u2().n_wcc.max(), 3000u);
  EXPECT_EQ(lazy.u2().depth, 1000u);
  expect_the_same(CascadeOfLength(3000, ConstructionKernel::kCascade), lazy);
}

TEST(LongestCascades, PlainRationals) {
  CITES("FC-NUM-01", "FC-FLOW-05");
  expect_the_same(CascadeOfLength(1000, ConstructionKernel::kCascade),
                  CascadeOfLength(1000, ConstructionKernel::kExact));
}

}  // namespace
}  // namespace flowcert::property::longest_cascades_test
