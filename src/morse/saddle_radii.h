// The radii of all critical points of index 2 in ascending order, and the spacing of the samples, in which radii can
// be given without units.
//
// Guarantees: exact. What is compared are squares of radii and of the spacing, which are rationals.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "flowcert/flow_complex.h"
#include "morse/length_bound.h"
#include "morse/value_order.h"

namespace flowcert::morse {

// The square of the median, over all samples, of the distance from a sample to its nearest other one. Of an even number
// of samples it is the lesser of the two in the middle. Nothing for fewer than two samples. (The midpoint of a sample
// and its nearest other one is a critical point of index 1. So the distances are read off these.)
// The values are the complex's; without them they are computed.
[[nodiscard]] std::optional<Rational> squared_spacing(const FlowComplex& complex, const SquaredDistances& values);
[[nodiscard]] std::optional<Rational> squared_spacing(const FlowComplex& complex);

class SaddleRadii {
 public:
  // The complex must outlive it. O(n log n), and an exact value for each that doubles do not tell from another.
  explicit SaddleRadii(const FlowComplex& complex);
  SaddleRadii(const SaddleRadii&) = delete;
  SaddleRadii& operator=(const SaddleRadii&) = delete;

  [[nodiscard]] std::size_t size() const { return order_.size(); }
  // Places count from 0, in ascending order. If radii are equal, the later point in the list comes first.
  [[nodiscard]] Rational squared_radius(std::size_t place) const { return order_.exact(place).square; }
  // Its number in StableManifolds.
  [[nodiscard]] std::size_t number(std::size_t place) const { return order_.at(place); }
  // How many radii are less than the root of this.
  [[nodiscard]] std::size_t count_below(const Rational& squared_bound) const {
    return order_.count_below(squared_bound);
  }
  // Bins of the radii's logarithms, in multiples of the spacing (log_histogram.h says which).
  [[nodiscard]] std::vector<HistogramBin> histogram() const;
  // Where the circles between neighbours end: the valley behind the highest bin, and as many radii are below the widest
  // gap in it as it says. Nothing where the histogram has no second heap behind the first.
  [[nodiscard]] std::optional<HistogramValley> valley() const;
  // As above.
  [[nodiscard]] const std::optional<Rational>& squared_spacing() const { return spacing_; }

 private:
  SquaredDistances values_;
  std::optional<Rational> spacing_;
  ValueOrder order_;
};

}  // namespace flowcert::morse
