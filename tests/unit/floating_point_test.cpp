// A thread in which the filters could be wrong is refused: by the check itself, and wherever a flow complex is made.
#include "geometry/floating_point.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/check.h"
#include "flowcert/flow_complex.h"
#include "tests/cites.h"

#ifdef __SSE2__
#include <pmmintrin.h>
#endif

namespace flowcert::floating_point_test {
namespace {

using geometry::require_ieee_doubles;

// What is said; empty if nothing is thrown.
std::string complaint_of(const std::function<void()>& act) {
  try {
    act();
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::vector<Point> triangle() { return {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}}; }

TEST(FloatingPoint, IsAsUsual) {
  CITES("FC-NUM-01");
  EXPECT_EQ(complaint_of(require_ieee_doubles), "");
}

// What is said of what flows, and of a check, where everything that they need was made before.
TEST(FloatingPoint, EveryOtherRoundingModeIsRefusedLater) {
  CITES("FC-NUM-01");
  const PointSet points(triangle());
  const FlowComplex made(points);
  const UnstableManifolds& unstable = made.unstable();
  const StableManifolds& stable = made.stable();
  ASSERT_EQ(unstable.size(), 1U);
  Flow flow(made.diagram());
  const RationalPoint start{1, 1, 1};
  const std::unique_ptr<Truth> truth = fast_truth(points);
  const std::vector<std::pair<const char*, std::function<void()>>> acts = {
      {"check", [&] { (void)check(points, Claim{}, *truth); }},
      {"Flow::step", [&] { (void)flow.step(start); }},
      {"Flow::orbit", [&] { (void)flow.orbit(start); }},
      {"UnstableManifolds::orbit", [&] { (void)unstable.orbit(0, 0); }},
      {"StableManifolds::set", [&] { (void)stable.set(0); }}};
  for (const auto& [name, act] : acts) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      const int usual = std::fegetround();
      std::fesetround(mode);
      const std::string said = complaint_of(act);
      std::fesetround(usual);
      EXPECT_EQ(said, "this thread does not round doubles to nearest") << name << ", " << mode;
    }
    EXPECT_EQ(complaint_of(act), "") << name;
  }
}

TEST(FloatingPoint, EveryOtherRoundingModeIsRefused) {
  CITES("FC-NUM-01");
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const int usual = std::fegetround();
    std::fesetround(mode);
    const std::string said = complaint_of(require_ieee_doubles);
    const std::string complex = complaint_of([] { (void)FlowComplex(triangle()).stationary(); });
    std::fesetround(usual);
    EXPECT_EQ(said, "this thread does not round doubles to nearest") << mode;
    EXPECT_EQ(complex, said);
  }
}

#ifdef __SSE2__
TEST(FloatingPoint, SubnormalsThatAreFlushedAreRefused) {
  CITES("FC-NUM-01", "FC-IN-02");
  for (const unsigned bits : {unsigned{_MM_FLUSH_ZERO_ON}, unsigned{_MM_DENORMALS_ZERO_ON}}) {
    const FlowComplex made_before(triangle());
    const unsigned usual = _mm_getcsr();
    _mm_setcsr(usual | bits);
    const std::string said = complaint_of(require_ieee_doubles);
    const std::string complex = complaint_of([] { (void)FlowComplex(triangle()); });
    const std::string part = complaint_of([&] { (void)made_before.stationary(); });
    _mm_setcsr(usual);
    EXPECT_NE(said.find("flushes subnormal doubles to zero"), std::string::npos) << said;
    EXPECT_EQ(complex, said);
    EXPECT_EQ(part, said);
    EXPECT_EQ(made_before.stationary().euler_sum(), 1);
  }
}
#endif

}  // namespace
}  // namespace flowcert::floating_point_test
