// In require_ieee_doubles() the operands are volatile, so that the processor computes and not the compiler.
#include "geometry/floating_point.h"

#include <stdexcept>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace flowcert::geometry {

namespace {

// Whether all modes are those of a fresh thread. Where there is no fast way to look, the answer is no.
bool has_usual_modes() {
#if defined(__SSE2__) && defined(__x86_64__)
  // The six lowest bits of the register say what has happened, and are no mode.
  constexpr unsigned kUsualSse = 0x1f80, kHappened = 0x3f;
  constexpr unsigned short kUsualX87 = 0x37f;
  unsigned short x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  return (_mm_getcsr() & ~kHappened) == kUsualSse && x87 == kUsualX87;
#else
  return false;
#endif
}

void require_unfused_multiply_add() {
  constexpr double kPart = 0x1p-27;
  const volatile double a = 1 + kPart, b = 1 - kPart, c = -1;
  // The product is 1 - 2^-54, which rounds to 1.
  if (a * b + c != 0) throw std::runtime_error("multiplications and additions of doubles are fused in this build");
}

}  // namespace

IeeeDoubles::IeeeDoubles() {
  if (has_usual_modes()) {
    // The build decides this, so it is asked once.
    static const bool is_unfused = (require_unfused_multiply_add(), true);
    (void)is_unfused;
    return;
  }
  std::fegetenv(&before_.emplace());
  std::fesetenv(FE_DFL_ENV);
  try {
    require_ieee_doubles();
  } catch (...) {
    std::fesetenv(&*before_);
    throw;
  }
}

IeeeDoubles::~IeeeDoubles() {
  if (before_) std::fesetenv(&*before_);
}

void require_ieee_doubles() {
  constexpr double kUnit = 0x1p-52, kHalf = 0x1p-53, kBeyondHalf = 0x1.8p-53;
  const volatile double one = 1, half_unit = kHalf, beyond_half = kBeyondHalf;
  const bool is_to_nearest = one + half_unit == 1 && one + beyond_half == 1 + kUnit && -one - half_unit == -1 &&
                             -one - beyond_half == -1 - kUnit;
  if (!is_to_nearest) throw std::runtime_error("this thread does not round doubles to nearest");
  constexpr double kSmallestNormal = 0x1p-1022, kSmallest = 0x1p-1074;
  const volatile double smallest_normal = kSmallestNormal, half = 0.5, subnormal = kSmallest, two = 2;
  // The first product is zero where results are flushed to zero, the second one where operands are.
  if (smallest_normal * half == 0 || subnormal * two == 0) {
    throw std::runtime_error("this thread flushes subnormal doubles to zero (another library may have asked it to)");
  }
  require_unfused_multiply_add();
}

}  // namespace flowcert::geometry
