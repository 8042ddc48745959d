// Distances, and differences of two, in ascending order, and questions of their order.
//
// Guarantees: exact. Doubles that bound each number decide most of the order, and exact numbers are made where the
// bounds overlap. The order depends on the numbers alone; equal numbers come in descending order of what they belong
// to, so that the greatest ones at the end are the first of a list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/squared_distances.h"
#include "geometry/difference_of_roots.h"
#include "geometry/value_range.h"
#include "morse/layer.h"

namespace flowcert::morse {

class ValueOrder {
 public:
  using Exact = std::function<geometry::RootDifference(std::size_t)>;

  // keys: numbers with one key are equal, and are made once. exact(i) makes the i-th number. O(n log n), apart from the
  // numbers that have to be made.
  ValueOrder(std::vector<ValueRange> ranges, std::vector<std::uint64_t> keys, Exact exact);

  [[nodiscard]] std::size_t size() const { return order_.size(); }
  // What the number at a place, from 0 in ascending order, belongs to.
  [[nodiscard]] std::size_t at(std::size_t place) const { return order_[place]; }
  [[nodiscard]] geometry::RootDifference exact(std::size_t place) const { return exact_(order_[place]); }
  // The same, or a little more (square_from_above).
  [[nodiscard]] Rational square_from_above(std::size_t place) const {
    return geometry::square_from_above(exact(place));
  }

  // How many numbers are less than the root of this, or not greater.
  [[nodiscard]] std::size_t count_below(const Rational& squared_bound) const;
  [[nodiscard]] std::size_t count_up_to(const Rational& squared_bound) const;

  // The first place k, `from` <= k < `to`, at which the number at k + 1 is the largest multiple of that at k; nothing
  // where all of them are equal. They are compared by their squares from above. All numbers from `from` on must be
  // positive, and `to` less than size().
  [[nodiscard]] std::optional<std::size_t> widest_gap(std::size_t from, std::size_t to) const;

  // The numbers from above, but one only of all that are not more than `width` greater than it, from the least one up.
  [[nodiscard]] ValueOrder from_above_once(const Rational& width) const;

 private:
  [[nodiscard]] ValueOrder from_above() const;
  void sort_exactly(std::span<std::size_t> run);
  // What v(k + 1) / v(k) lies between.
  [[nodiscard]] ValueRange ratio_behind(std::size_t place) const;

  std::vector<ValueRange> ranges_;
  std::vector<std::uint64_t> keys_;
  Exact exact_;
  std::vector<std::size_t> order_;
};

// The greatest whole number that is not greater than this share of the count, from 0 to 1.
[[nodiscard]] std::size_t part_of(std::size_t count, const Rational& share);

// Stationary points, by their places in the list.
struct PairEnds {
  std::size_t birth = 0, death = 0;
};

// The lengths of persistence pairs: the distance at the death less that at the birth, not squared. The values must
// outlive the order.
[[nodiscard]] ValueOrder length_order(const SquaredDistances& values, std::vector<PairEnds> pairs);
// At least the `count` longest pairs, and mostly no others, in their order: all that the bounds do not rule out. O(n).
[[nodiscard]] std::vector<PairEnds> perhaps_longest(const SquaredDistances& values, std::vector<PairEnds> pairs,
                                                    std::size_t count);
// The radii of these records, by their places among them. The values must outlive the order.
[[nodiscard]] ValueOrder radius_order(const SquaredDistances& values, std::vector<std::size_t> records);

}  // namespace flowcert::morse
