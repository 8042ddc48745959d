// The squared distances to the samples at all stationary points, and their order.
//
// Guarantees: ranks and exact values are exact, on every input. Doubles with proven bounds decide the order of most
// values; exact values are computed where the bounds overlap, and where someone asks for one. Source: spec clause
// FC-PERS-01.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

class SquaredDistances {
 public:
  // Both must outlive this. O(n log n), and an exact value for each that the doubles do not tell from another. The
  // same for any number of threads.
  SquaredDistances(const PointSet& points, const StationaryPoints& stationary, unsigned threads = 1);

  // By place in the list. Computed anew each time.
  [[nodiscard]] Rational exact(std::size_t record) const;

  // The number of different values that are less.
  [[nodiscard]] std::uint32_t rank(std::size_t record) const { return rank_[record]; }

  // All stationary points, by value, and then by place in the list.
  [[nodiscard]] std::span<const std::uint32_t> ascending() const { return ascending_; }

  // The value, compared with a number.
  [[nodiscard]] std::strong_ordering compare(std::size_t record, const Rational& number) const;

  // |value - exact| <= error. The error is 0 where the value is exact.
  struct Approximation {
    double value = 0, error = 0;
  };
  [[nodiscard]] const Approximation& approximation(std::size_t record) const { return approximate_[record]; }

  // Prefetches what is known of a record, for those who go through records in another order.
  [[gnu::always_inline]] void prefetch(std::size_t record) const {
    __builtin_prefetch(&approximate_[record]);
    __builtin_prefetch(&rank_[record]);
  }

  // The distance at the one less that at the other, which are not squared: the length of their persistence pair.
  [[nodiscard]] Approximation length(std::size_t birth, std::size_t death) const;

 private:
  const PointSet* points_;
  const StationaryPoints* stationary_;
  std::vector<Approximation> approximate_;
  std::vector<std::uint32_t> rank_, ascending_;
};

}  // namespace flowcert
