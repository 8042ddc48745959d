// A list of persistence pairs that a program claims, in JSON or in the text format of GUDHI's tools
// (spec/formats/persistence.md).
//
// Guarantees: numbers from JSON are exact, and numbers from text are the nearest doubles. A file in neither format
// throws InvalidInput. For text, the message names the line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flowcert/rational.h"

namespace flowcert {

// Classes of components, tunnels and voids.
inline constexpr int kPairDimensions = 3;

struct ListedPair {
  int dimension = 0;
  Rational birth;
  std::optional<Rational> death;  // none: the class lasts
};

// The order by dimension, birth and death. A class that lasts comes last.
[[nodiscard]] bool is_before(const ListedPair& a, const ListedPair& b);

struct PairList {
  std::vector<ListedPair> pairs;
  bool is_rounded = false;  // from text: each value is a double
};

// Reads what a program has written. name: of the file, for messages.
[[nodiscard]] PairList claimed_pairs_of(const std::string& bytes, const std::string& name);

}  // namespace flowcert
