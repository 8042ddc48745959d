// A precondition that does not hold ends the program in builds with contracts, and costs nothing in others.
#include "geometry/contract.h"

#include <gtest/gtest.h>

#include "geometry/nearest_samples.h"

namespace flowcert::contract_test {
namespace {

TEST(Contract, IsEvaluatedOnlyWhereItIsChecked) {
  int evaluated = 0;
  FLOWCERT_REQUIRES(++evaluated > 0);
  EXPECT_EQ(evaluated, geometry::kContracts ? 1 : 0);
}

#ifdef FLOWCERT_CONTRACTS
TEST(ContractDeathTest, NamesWhatDoesNotHold) {
  EXPECT_DEATH(FLOWCERT_REQUIRES(1 + 1 == 3), "contract_test.cpp:[0-9]+: a precondition does not hold: 1 \\+ 1 == 3");
  EXPECT_DEATH((void)geometry::nearest_samples(PointSet(), RationalPoint{}), "!points.empty\\(\\)");
}
#endif

}  // namespace
}  // namespace flowcert::contract_test
