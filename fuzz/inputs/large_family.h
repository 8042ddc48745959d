// The family of large inputs, for a property that takes inputs of any size (property.h).
//
// Guarantees: those of families.h, but a large input does not shrink as it is drawn. It is drawn where it is named
// alone: the cases of the other families stay what they are, and the oracle's scans are not asked about it.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::fuzz {

inline constexpr std::size_t kFewestRowsOfLarge = 1000;
inline constexpr std::size_t kMostRowsOfLarge = 10'000;

// Ties everywhere (large_configurations.h), of coordinates of few bits and of many.
const Family& large_family();
[[nodiscard]] bool is_large(std::string_view name);  // of a family

// All families that can be named: families_and_stable_ones(), and the large one.
std::vector<Family> named_families();

}  // namespace flowcert::fuzz
