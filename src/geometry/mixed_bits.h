// SplitMix64's finalizer. It turns consecutive numbers into seeds that have nothing in common.
//
// Guarantees: a bijection, the same everywhere.
#pragma once

#include <cstdint>

namespace flowcert::geometry {

inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15u;

constexpr std::uint64_t mixed_bits(std::uint64_t value) {
  value += kSplitMixStep;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

}  // namespace flowcert::geometry
