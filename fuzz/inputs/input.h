// The rows of a point file in order, with repeated rows. Generators make them, and fuzzers take them.
//
// Guarantees: printing is exact. Each row is printed with the shortest decimals that read back to the same doubles,
// so a counterexample on the screen can be pasted into an XYZ file.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

namespace flowcert::fuzz {

using Row = std::array<double, 3>;

struct Input {
  std::vector<Row> rows;

  friend bool operator==(const Input&, const Input&) = default;
};

std::ostream& operator<<(std::ostream& out, const Input& input);

// The neighbouring double upwards (steps = 1) or downwards (-1), or the same one (0). No smaller change of a
// coordinate is possible. The result is finite for every value below the largest double in magnitude.
double nudged(double value, int steps);

// splitmix64's finalizer. It turns consecutive numbers into seeds that have nothing in common.
//
// Guarantees: a bijection, the same everywhere.
constexpr std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

}  // namespace flowcert::fuzz
