// What the generators make and a fuzzer eats: the rows of a point file, in order, repeated rows and all.
//
// Guarantees: printing is exact. Each row is printed with the shortest decimals that read back to the same
// doubles, so a counterexample on the screen can be pasted into an XYZ file.
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

}  // namespace flowcert::fuzz
