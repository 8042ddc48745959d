// Persistence pairs by the fast implementation, in the oracle's structure.
//
// Guarantees: exact, in the order of the oracle's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flowcert/point_set.h"
#include "oracle/persistence.h"

namespace flowcert::property {

struct FastPersistence {
  std::vector<oracle::PersistencePair> pairs;
  bool has_ties = false;  // that were broken on the way
};
// seed: of the ties (FC-CHAIN-02).
[[nodiscard]] FastPersistence fast_persistence(const PointSet& points, std::uint64_t seed = 0);

// A line for each: dimension, birth, death or "inf".
[[nodiscard]] std::string to_text(const std::vector<oracle::PersistencePair>& pairs);

}  // namespace flowcert::property
