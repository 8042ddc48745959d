// The persistence of the alpha complex, exact: GUDHI's complex and GUDHI's pairs, with the filtration value
// of each simplex computed here, in rationals.
//
// Guarantees: the values follow the definition, and nothing of the fast implementation is used. A simplex has
// the squared radius of the smallest sphere through its vertices if no vertex of a coface lies strictly
// inside, else the least value of a coface.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flowcert/persistence.h"

namespace flowcert::property {

struct ExactPair {
  int dimension = 0;
  Rational birth;
  std::optional<Rational> death;  // none: the class lasts

  friend bool operator==(const ExactPair&, const ExactPair&) = default;
};
// Orders by dimension, birth, death. Classes that never end come last.
bool operator<(const ExactPair& a, const ExactPair& b);
std::string to_text(const ExactPair& pair);

struct AlphaTimes {
  double gudhi = 0;   // seconds for complex and pairs
  double values = 0;  // for exact values and ranks
};

// The pairs, sorted, without those of length zero. Throws std::runtime_error if GUDHI's own values differ.
std::vector<ExactPair> alpha_persistence(std::span<const Point> points, AlphaTimes* times = nullptr);
// All pairs, sorted.
std::vector<ExactPair> exact_pairs(const Persistence& persistence);

// The first pair that only one of the two lists has, and which list has it. Empty if none. Both are sorted.
std::string difference(const std::vector<ExactPair>& own, const std::vector<ExactPair>& gudhi);
// How many pairs only one of the two lists has.
std::size_t count_differences(const std::vector<ExactPair>& own, const std::vector<ExactPair>& gudhi);

}  // namespace flowcert::property
