// A bound on lengths of persistence pairs, or on radii, as people give it, with or without units.
//
// A length is a difference of distances, which are not squared. Guarantees: numbers are read exactly, and what a bound
// comes to is exact; a quantile or a valley comes to a length from above (src/cli/manual/surfaces.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "flowcert/saddle_radii.h"

namespace flowcert {

namespace morse {
class ValueOrder;
}  // namespace morse

struct LengthThreshold {
  std::optional<Rational> squared_length;
  std::optional<AutomaticThreshold> automatic;  // for "auto"
};

struct LengthBound {
  enum class Unit : std::uint8_t { kInput, kSpacing, kQuantile, kValley };
  Unit unit = Unit::kInput;
  Rational number = 0;

  // "X", in units of the input; "3spacing", a multiple of the samples' spacing; "q0.9", a quantile of all lengths;
  // "auto", the length below the valley of their histogram. Throws InvalidInput for anything else: the message begins
  // with the option, and which one of these it is, from 1.
  [[nodiscard]] static LengthBound of(std::string_view text, const std::string& option, std::size_t ordinal);

  // The length that is meant. Nothing where the bound is below all lengths. For a valley, lengths that are not more
  // than `same_within` apart count once, where it is set.
  [[nodiscard]] LengthThreshold threshold(const morse::ValueOrder& lengths,
                                          const std::optional<Rational>& squared_spacing,
                                          const std::optional<Rational>& same_within = std::nullopt) const;
};

}  // namespace flowcert
