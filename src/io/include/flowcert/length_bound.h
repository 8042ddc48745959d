// A bound on lengths of persistence pairs as people give it, with or without units.
//
// Guarantees: numbers are read exactly, and what a bound comes to is exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "flowcert/histogram_valley.h"
#include "flowcert/rational.h"

namespace flowcert {

namespace io {
class ValueOrder;
}  // namespace io

struct LengthThreshold {
  std::optional<Rational> length;
  std::optional<AutomaticThreshold> automatic;  // for "auto"
};

// Also a bound on radii (surface_selection.h), which says its own unit of the spacing.
struct LengthBound {
  enum class Unit : std::uint8_t { kInput, kSpacing, kQuantile, kValley };
  Unit unit = Unit::kInput;
  Rational number = 0;

  // "X", a difference of squared distances; "3spacing^2", a multiple of the samples' squared spacing; "q0.9", a
  // quantile of all lengths; "auto", the length below the valley of their histogram. Throws InvalidInput for
  // anything else: the message begins with the option, and which one of these it is, from 1. `spacing` is the name of
  // the second unit.
  [[nodiscard]] static LengthBound of(std::string_view text, std::string_view spacing, const std::string& option,
                                      std::size_t ordinal);

  // The length that is meant. Nothing where the bound is below all lengths.
  [[nodiscard]] LengthThreshold threshold(const io::ValueOrder& lengths,
                                          const std::optional<Rational>& squared_spacing) const;
};

}  // namespace flowcert
