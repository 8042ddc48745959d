// The operands are volatile, so that the processor computes and not the compiler.
#include "geometry/floating_point.h"

#include <stdexcept>

namespace flowcert::geometry {

void require_ieee_doubles() {
  const volatile double one = 1, half_unit = 0x1p-53, beyond_half = 0x1.8p-53;
  const bool is_to_nearest = one + half_unit == 1 && one + beyond_half == 1 + 0x1p-52 && -one - half_unit == -1 &&
                             -one - beyond_half == -1 - 0x1p-52;
  if (!is_to_nearest) throw std::runtime_error("this thread does not round doubles to nearest");
  const volatile double smallest_normal = 0x1p-1022, half = 0.5, subnormal = 0x1p-1074, two = 2;
  // The first product is zero where results are flushed to zero, the second one where operands are.
  if (smallest_normal * half == 0 || subnormal * two == 0) {
    throw std::runtime_error("this thread flushes subnormal doubles to zero (another library may have asked it to)");
  }
  const volatile double a = 1 + 0x1p-27, b = 1 - 0x1p-27, c = -1;
  // The product is 1 - 2^-54, which rounds to 1.
  if (a * b + c != 0) throw std::runtime_error("multiplications and additions of doubles are fused in this build");
}

}  // namespace flowcert::geometry
