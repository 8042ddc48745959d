// Sums mod 2 that depend on each other.
//
// Guarantees: exact. A sum is reduced by earlier ones with the same last item, as columns of a matrix are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace flowcert::morse {

// Which of these sums mod 2, in their order, are sums of earlier ones. Each ascends.
[[nodiscard]] std::vector<bool> dependent_sums(std::span<const std::vector<std::uint32_t>> sums);

}  // namespace flowcert::morse
