// A histogram of numbers by their logarithms, the valley behind its highest bin, and the length that a bound means
// among given ones.
//
// Guarantees: exact. Bins lie between rational edges, and what is in them is counted. A valley is where people who look
// at a histogram put a threshold (J. M. S. Prewitt, M. L. Mendelsohn, The analysis of cell images, 1966: the least bin
// between two modes); whether there is one is decided by counts alone (src/cli/manual/surfaces.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "morse/length_bound.h"
#include "morse/value_order.h"

namespace flowcert::morse {

// Of the positive numbers, which are roots, as multiples of the root of `squared_unit`: at most 30 bins. They
// grow in ten steps from each power of ten to the next (1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8), or in three (1, 2,
// 5), or one; where that makes too many, each goes over several powers. Empty bins between others are there, too.
[[nodiscard]] std::vector<HistogramBin> log_histogram(const ValueOrder& roots, const Rational& squared_unit);

// The first bin behind the highest one that is the least so far and behind which a bin is at least twice as high, by
// more than three standard deviations of the difference of two counts. Of equally least bins it is the first.
[[nodiscard]] std::optional<std::size_t> valley_of(const std::vector<HistogramBin>& bins);

// The valley of that histogram, and the widest gap in it: the place of the last number below the gap.
struct PlacedValley {
  HistogramValley valley;
  std::size_t last_below = 0;
};
[[nodiscard]] std::optional<PlacedValley> placed_valley(const ValueOrder& roots, const Rational& squared_unit);

struct LengthThreshold {
  std::optional<Rational> squared_length;  // none: the bound is below all lengths
  std::optional<AutomaticThreshold> automatic;
};

// For a valley, lengths that are not more than `same_within` apart count once, where it is set.
[[nodiscard]] LengthThreshold threshold_of(const LengthBound& bound, const ValueOrder& lengths,
                                           const std::optional<Rational>& squared_spacing,
                                           const std::optional<Rational>& same_within = std::nullopt);

}  // namespace flowcert::morse
