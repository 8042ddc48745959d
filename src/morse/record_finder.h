// Finds a stationary point in the list by what it is.
//
// Guarantees: relies on the order of the list (spec clause FC-OUT-02), and so takes a binary search.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"

namespace flowcert::morse {

class RecordFinder {
 public:
  // The list must outlive this.
  explicit RecordFinder(const StationaryPoints& list) : list_(list) {}

  // The records of one index or kind: first, and one beyond the last.
  [[nodiscard]] std::pair<std::size_t, std::size_t> range(StationaryIndex index) const;
  // contact: names, ascending.
  [[nodiscard]] std::optional<std::size_t> find(StationaryIndex index,
                                                std::span<const PointId> contact) const;

 private:
  const StationaryPoints& list_;
};

}  // namespace flowcert::morse
