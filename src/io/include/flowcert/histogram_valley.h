// A bin of a histogram of lengths, and a valley between two heaps of them, where a threshold is put that nobody names.
#pragma once

#include <cstddef>
#include <optional>

#include "flowcert/rational.h"

namespace flowcert {

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

// What `auto` found, and chose a threshold by. No valley: there is no threshold.
struct AutomaticThreshold {
  std::optional<HistogramValley> valley;
};

}  // namespace flowcert
