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

class SquaredLevel;

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
  [[nodiscard]] std::strong_ordering compare(std::size_t record, const SquaredLevel& level) const;

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

// A squared distance that values are compared with: a number, or a share of the way from one value to another. That is
// made exactly only where bounds do not decide. The values must outlive it.
class SquaredLevel {
 public:
  SquaredLevel(const Rational& number);  // NOLINT(google-explicit-constructor): a number is one
  // The share is from 0 to 1.
  SquaredLevel(const SquaredDistances& values, std::size_t from, std::size_t to, const Rational& share);

  // Computed anew each time, but for a number.
  [[nodiscard]] Rational exact() const;

 private:
  friend class SquaredDistances;
  const SquaredDistances* values_ = nullptr;
  std::size_t from_ = 0, to_ = 0;
  Rational number_;  // or the share
  SquaredDistances::Approximation approximate_;
};

}  // namespace flowcert
