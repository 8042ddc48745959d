// Numbers and positions as some program claims them.
//
// Guarantees: a number is kept as it was written, and nothing is rounded (FC-CLAIM-05).
#pragma once

#include <array>
#include <optional>

#include "flowcert/rational.h"

namespace flowcert {

// A number as claimed. A rational or a hexadecimal float is exact. A decimal is not exact: it stands for any real
// number near it. Its `value` is the decimal itself, not a double.
struct ClaimedNumber {
  Rational value;
  bool is_exact = false;
};
using ClaimedPosition = std::array<ClaimedNumber, 3>;

// A value that is claimed as a double. Without a number it says that no double is near.
struct ClaimedDouble {
  std::optional<ClaimedNumber> number;
};

}  // namespace flowcert
