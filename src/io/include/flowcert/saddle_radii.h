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
  // The place of the last radius below the widest gap: the next one is the largest multiple of it. Only gaps are looked
  // at that begin between the median (the lesser of two in the middle) and kWidestGapRange times the median, both
  // included: there the circles between neighbours end, if samples are dense. Of equal gaps it is the first. Nothing
  // where no two radii differ there.
  static constexpr int kWidestGapRange = 4;
  [[nodiscard]] std::optional<std::size_t> widest_gap() const;
  // As above.
  [[nodiscard]] const std::optional<Rational>& squared_spacing() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// `count` radii are at least `from` and less than `to`, both multiples of the spacing.
struct RadiusBin {
  Rational from, to;
  std::size_t count = 0;
};

// Bins for all radii, at most 30. They grow in ten steps from each power of ten to the next (1, 1.25, 1.6, 2, 2.5,
// 3.15, 4, 5, 6.3, 8), or in three (1, 2, 5), or one; where that makes too many, each goes over several powers. Empty
// bins between others are there, too.
[[nodiscard]] std::vector<RadiusBin> radius_histogram(const SaddleRadii& radii);

}  // namespace flowcert
