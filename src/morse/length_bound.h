// A bound on lengths of persistence pairs, or on radii, as people give it, with or without units; and the valley of a
// histogram, by which one is chosen that nobody names.
//
// A length is a difference of distances, which are not squared. Guarantees: exact; a quantile or a valley comes to a
// length from above (src/cli/manual/surfaces.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "flowcert/rational.h"

namespace flowcert {

struct LengthBound {
  // Units of the input; the samples' spacing; a quantile of all lengths, for a number from 0 to 1; the length below the
  // valley of their histogram, without a number.
  enum class Unit : std::uint8_t { kInput, kSpacing, kQuantile, kValley };
  Unit unit = Unit::kInput;
  Rational number = 0;
};

// `count` lengths are at least `from` and less than `to`, both multiples of a unit (the samples' spacing).
struct HistogramBin {
  Rational from, to;
  std::size_t count = 0;
};

// The least bin between two heaps, and how many lengths are below and beyond the threshold in it.
struct HistogramValley {
  HistogramBin bin;
  std::size_t below = 0, beyond = 0;
};

// What a bound by the valley found, and chose a threshold by. No valley: there is no threshold.
struct AutomaticThreshold {
  std::optional<HistogramValley> valley;
};

}  // namespace flowcert
