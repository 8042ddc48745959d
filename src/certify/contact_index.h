// Finds stationary points by samples of their contact sets.
//
// Guarantees: exact. A question takes time in proportion to the stationary points of one sample, that of the
// fewest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/layer.h"
#include "flowcert/check.h"

namespace flowcert::certify {

class ContactIndex {
 public:
  // Both must outlive this. O(all contact sets).
  ContactIndex(const PointSet& points, const Truth& truth);

  // names: ascending, not empty.
  [[nodiscard]] std::optional<std::size_t> find(std::span<const PointId> names) const;
  // Those whose contact set has all of these and more.
  [[nodiscard]] std::vector<std::size_t> larger(std::span<const PointId> names) const;
  // All stationary points of a sample, in the order of the list.
  [[nodiscard]] std::span<const std::uint32_t> of(PointId name) const {
    const std::size_t at = points_.position_of_row(name);
    return std::span(records_).subspan(first_[at], first_[at + 1] - first_[at]);
  }

 private:
  [[nodiscard]] std::span<const std::uint32_t> fewest(std::span<const PointId> names) const;

  const PointSet& points_;
  const Truth& truth_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> records_;
};

}  // namespace flowcert::certify
