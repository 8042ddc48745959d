// The radii of all critical points of index 2 in ascending order, and the spacing of the samples, by which radii can
// be told without units.
//
// Guarantees: exact. What is compared are squares of radii and of the spacing, which are rationals.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "flowcert/flow_complex.h"

namespace flowcert {

// ---- Histograms ----

// `count` lengths are at least `from` and less than `to`, both multiples of a unit (the samples' spacing).
struct HistogramBin {
  Rational from, to;
  std::size_t count = 0;
};

// The least bin between two heaps, where a threshold is put that nobody names, and how many lengths are below and
// beyond it.
struct HistogramValley {
  HistogramBin bin;
  std::size_t below = 0, beyond = 0;
};

// What `auto` found, and chose a threshold by. No valley: there is no threshold.
struct AutomaticThreshold {
  std::optional<HistogramValley> valley;
};

// ---- Radii ----

// The square of the median, over all samples, of the distance from a sample to its nearest other one. Of an even number
// of samples it is the lesser of the two in the middle. Nothing for fewer than two samples. (The midpoint of a sample
// and its nearest other one is a critical point of index 1. So the distances are read off these.)
[[nodiscard]] std::optional<Rational> squared_spacing(const FlowComplex& complex);

class SaddleRadii {
 public:
  // The complex must outlive it. O(n log n), and an exact value for each that doubles do not tell from another.
  explicit SaddleRadii(const FlowComplex& complex);
  explicit SaddleRadii(FlowComplex&&) = delete;
  ~SaddleRadii();
  SaddleRadii(SaddleRadii&&) noexcept;
  SaddleRadii& operator=(SaddleRadii&&) noexcept;

  [[nodiscard]] std::size_t size() const;
  // Places count from 0, in ascending order. If radii are equal, the later point in the list comes first.
  [[nodiscard]] Rational squared_radius(std::size_t place) const;
  // Its number in StableManifolds.
  [[nodiscard]] std::size_t number(std::size_t place) const;
  // How many radii are less than the root of this.
  [[nodiscard]] std::size_t count_below(const Rational& squared_bound) const;
  // Bins of the radii's logarithms, in multiples of the spacing (log_histogram.h says which).
  [[nodiscard]] std::vector<HistogramBin> histogram() const;
  // Where the circles between neighbours end: the valley behind the highest bin, and as many radii are below the widest
  // gap in it as it says. Nothing where the histogram has no second heap behind the first.
  [[nodiscard]] std::optional<HistogramValley> valley() const;
  // As above.
  [[nodiscard]] const std::optional<Rational>& squared_spacing() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
