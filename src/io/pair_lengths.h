// Lengths of persistence pairs, and radii, in their order.
//
// Guarantees: exact (ValueOrder). A length is the distance at the death less that at the birth, not squared.
#pragma once

#include <cstddef>
#include <vector>

#include "flowcert/squared_distances.h"
#include "io/value_order.h"

namespace flowcert::io {

// Stationary points, by their places in the list.
struct PairEnds {
  std::size_t birth = 0, death = 0;
};

// The values must outlive the order.
[[nodiscard]] ValueOrder length_order(const SquaredDistances& values, std::vector<PairEnds> pairs);

// Of these records, by their places among them. The values must outlive the order.
[[nodiscard]] ValueOrder radius_order(const SquaredDistances& values, std::vector<std::size_t> records);

}  // namespace flowcert::io
