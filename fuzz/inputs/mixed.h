// splitmix64's finalizer: turns numbers that count into seeds that have nothing in common.
//
// Guarantees: a bijection, the same everywhere.
#pragma once

#include <cstdint>

namespace flowcert::fuzz {

constexpr std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

}  // namespace flowcert::fuzz
