// The rows of a point file in order, with repeated rows. Generators make them, and fuzzers take them.
//
// Guarantees: printing is exact. Each row is printed with the shortest decimals that read back to the same doubles,
// so a counterexample on the screen can be pasted into an XYZ file.
#pragma once

#include <array>
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

}  // namespace flowcert::fuzz
