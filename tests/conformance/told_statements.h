// Statements of the spec's examples on orbits, contact sets, limits, boundaries and persistence pairs, as each
// implementation answers them (spec section 9).
//
// Guarantees: an answer is the whole statement as it should be, so that a right statement is equal to it. The oracle
// and the fast implementation read the points with their own readers.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace flowcert::conformance {

struct NotAnExample : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Whether a statement that begins with this word is one of these: nearest, orbit, limits, boundary, pair.
bool is_told(const std::string& keyword);

// The statement as it should be. points: the text of an XYZ file. Throws NotAnExample for one that asks nothing.
std::string told_by_fast(const std::string& points, const std::vector<std::string>& statement);
std::string told_by_oracle(const std::string& points, const std::vector<std::string>& statement);

}  // namespace flowcert::conformance
