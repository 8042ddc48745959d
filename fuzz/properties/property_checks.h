// The checks that the table of properties calls. Each compares two ways to one answer.
//
// Guarantees: as property.h. The empty input passes those that need a start or a stationary point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/properties/property.h"
#include "oracle/persistence.h"

namespace flowcert::property {

[[nodiscard]] std::optional<Disagreement> check_critical_points(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_orbit(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_unstable_manifolds(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_stable_sets(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_persistence(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_orbit_kernels(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_unstable_kernels(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_stable_kernels(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_threads(const Trial& trial);

// Persistence pairs by the fast implementation, in the oracle's structure.
//
// Guarantees: exact, in the order of the oracle's.
struct FastPersistence {
  std::vector<oracle::PersistencePair> pairs;
  bool has_ties = false;  // whether ties were broken on the way
};
[[nodiscard]] FastPersistence fast_persistence(const FlowComplex& complex);

// A line for each: dimension, birth, death or "inf".
[[nodiscard]] std::string to_text(const std::vector<oracle::PersistencePair>& pairs);

}  // namespace flowcert::property
