#include "morse/length_threshold.h"

#include "morse/log_histogram.h"

namespace flowcert::morse {

LengthThreshold threshold_of(const LengthBound& bound, const ValueOrder& lengths,
                             const std::optional<Rational>& squared_spacing,
                             const std::optional<Rational>& same_within) {
  const auto& [unit, number] = bound;
  switch (unit) {
    case LengthBound::Unit::kInput:
    case LengthBound::Unit::kSpacing:
      if (number < 0) return {};
      return {number * number * (unit == LengthBound::Unit::kInput ? Rational(1) : squared_spacing.value_or(0)), {}};
    case LengthBound::Unit::kQuantile: {
      const std::size_t shorter = lengths.size() - part_of(lengths.size(), 1 - number);
      return {shorter > 0 ? std::optional(lengths.square_from_above(shorter - 1)) : std::nullopt, {}};
    }
    case LengthBound::Unit::kValley:
      break;
  }
  if (!squared_spacing) return {std::nullopt, AutomaticThreshold{}};
  const ValueOrder counted = same_within ? lengths.from_above_once(*same_within) : lengths;
  const auto found = placed_valley(counted, *squared_spacing);
  if (!found) return {std::nullopt, AutomaticThreshold{}};
  return {counted.square_from_above(found->last_below), AutomaticThreshold{found->valley}};
}

}  // namespace flowcert::morse
