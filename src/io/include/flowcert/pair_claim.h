// Persistence pairs as a list: what a program claims in JSON or in the text format of GUDHI's tools
// (spec/formats/persistence.md).
//
// Guarantees: numbers of JSON are exact, those of text are the nearest doubles. What is neither throws
// InvalidInput, with a line where there is one.
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

// By dimension, birth and death, a class that lasts last.
[[nodiscard]] bool is_before(const ListedPair& a, const ListedPair& b);

struct PairList {
  std::vector<ListedPair> pairs;
  bool is_rounded = false;  // of text: each value is a double
};

// What a program has written; name: of the file, for messages.
[[nodiscard]] PairList claimed_pairs_of(const std::string& bytes, const std::string& name);

}  // namespace flowcert
