// A thread in which the filters could be wrong is noticed, and has the usual modes as long as an IeeeDoubles stands.
// every_mode_test.cpp has that for all public functions.
#include "geometry/floating_point.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <stdexcept>
#include <string>

#include "geometry/parallel_for.h"
#include "tests/cites.h"

#ifdef __SSE2__
#include <pmmintrin.h>
#endif

namespace flowcert::floating_point_test {
namespace {

using geometry::IeeeDoubles;
using geometry::parallel_for;
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

TEST(FloatingPoint, IsAsUsual) {
  CITES("FC-NUM-01");
  EXPECT_EQ(complaint_of(require_ieee_doubles), "");
}

TEST(FloatingPoint, EveryOtherRoundingModeIsNoticed) {
  CITES("FC-NUM-01");
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const int usual = std::fegetround();
    std::fesetround(mode);
    const std::string said = complaint_of(require_ieee_doubles);
    std::fesetround(usual);
    EXPECT_EQ(said, "this thread does not round doubles to nearest") << mode;
  }
}

TEST(FloatingPoint, AModeIsSetAside) {
  CITES("FC-NUM-01");
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const int usual = std::fegetround();
    std::fesetround(mode);
    const std::string said = complaint_of([] {
      const IeeeDoubles ieee;
      require_ieee_doubles();
    });
    const int afterwards = std::fegetround();
    const std::string thrown = complaint_of([] {
      const IeeeDoubles ieee;
      throw std::runtime_error("thrown");
    });
    const int after_throwing = std::fegetround();
    std::fesetround(usual);
    EXPECT_EQ(said, "");
    EXPECT_EQ(afterwards, mode);
    EXPECT_EQ(thrown, "thrown");
    EXPECT_EQ(after_throwing, mode);
  }
}

#ifdef __SSE2__
TEST(FloatingPoint, SubnormalsThatAreFlushedAreNoticedAndKept) {
  CITES("FC-NUM-01", "FC-IN-02");
  for (const unsigned bits : {unsigned{_MM_FLUSH_ZERO_ON}, unsigned{_MM_DENORMALS_ZERO_ON}}) {
    const unsigned usual = _mm_getcsr();
    _mm_setcsr(usual | bits);
    const std::string said = complaint_of(require_ieee_doubles);
    const std::string inside = complaint_of([] {
      const IeeeDoubles ieee;
      require_ieee_doubles();
    });
    const unsigned afterwards = _mm_getcsr();
    _mm_setcsr(usual);
    EXPECT_NE(said.find("flushes subnormal doubles to zero"), std::string::npos) << said;
    EXPECT_EQ(inside, "");
    EXPECT_EQ(afterwards & bits, bits);
  }
}
#endif

// Each part of a loop has the usual modes, on every thread, whatever the caller's are.
TEST(FloatingPoint, PartsOfALoopHaveTheUsualModes) {
  CITES("FC-NUM-01");
  for (const unsigned threads : {1U, 4U}) {
    const int usual = std::fegetround();
    std::fesetround(FE_UPWARD);
    const std::string said =
        complaint_of([&] { parallel_for(64, threads, [](std::size_t) { require_ieee_doubles(); }); });
    std::fesetround(usual);
    EXPECT_EQ(said, "") << threads;
  }
}

}  // namespace
}  // namespace flowcert::floating_point_test
