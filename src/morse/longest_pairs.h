// The longest persistence pairs of some.
//
// Guarantees: exact. A length is a difference of distances, which are not squared; of equal lengths the first pairs of
// the list come first.
#pragma once

#include <cstddef>
#include <vector>

#include "flowcert/persistence.h"
#include "morse/layer.h"

namespace flowcert::morse {

// At most so many of these pairs, which all have a death, from the longest one down. O(n), and sorting those.
[[nodiscard]] std::vector<PersistencePair> longest_pairs(const SquaredDistances& values,
                                                         const std::vector<PersistencePair>& pairs, std::size_t count);

}  // namespace flowcert::morse
