// Lengths of persistence pairs, and squared radii, in their order.
//
// Guarantees: exact (ValueOrder). A length is the squared distance of the death less that of the birth.
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
