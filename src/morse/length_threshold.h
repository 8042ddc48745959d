// The length that a bound means among given ones.
#pragma once

#include <optional>

#include "morse/length_bound.h"
#include "morse/value_order.h"

namespace flowcert::morse {

struct LengthThreshold {
  std::optional<Rational> squared_length;  // none: the bound is below all lengths
  std::optional<AutomaticThreshold> automatic;
};

// For a valley, lengths that are not more than `same_within` apart count once, where it is set.
[[nodiscard]] LengthThreshold threshold_of(const LengthBound& bound, const ValueOrder& lengths,
                                           const std::optional<Rational>& squared_spacing,
                                           const std::optional<Rational>& same_within = std::nullopt);

}  // namespace flowcert::morse
