// What the entries of the table of properties call: each compares two ways to one answer.
//
// Guarantees: as property.h. The empty input passes those that need a start or a stationary point.
#pragma once

#include <optional>

#include "fuzz/properties/property.h"

namespace flowcert::property {

[[nodiscard]] std::optional<Disagreement> check_critical_points(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_orbit(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_unstable_manifolds(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_stable_sets(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_persistence(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_orbit_kernels(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_unstable_kernels(const Trial& trial);
[[nodiscard]] std::optional<Disagreement> check_stable_kernels(const Trial& trial);

}  // namespace flowcert::property
