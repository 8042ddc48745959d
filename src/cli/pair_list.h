// Persistence pairs as a list: what a conformance vector expects, and what a program claims in JSON or in the
// text format of GUDHI's tools (spec/formats.md, "Persistence").
//
// Guarantees: JSON is compared exactly, text by nearest doubles, both as multisets without the pairs of
// length zero. What is neither throws InvalidInput, with a line where there is one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flowcert/rational.h"
#include "io/json_fields.h"

namespace flowcert {

struct ListedPair {
  int dimension = 0;
  Rational birth;
  std::optional<Rational> death;  // none: the class lasts
};

struct PairList {
  std::vector<ListedPair> pairs;
  bool is_rounded = false;  // of text: each value is a double
};

// Of a vector: an array of objects with `dimension`, `birth` and `death`.
[[nodiscard]] std::vector<ListedPair> expected_pairs_of(const Json& array);

// What a program has written; name: of the file, for messages.
[[nodiscard]] PairList claimed_pairs_of(const std::string& bytes, const std::string& name);

// A pair that only one of them has, or one that each of them has in place of the other's.
struct PairDifference {
  std::string claimed;  // in words
  std::string truth;
};

// None iff they are the same. If the claim is rounded, so is the truth before they are compared.
[[nodiscard]] std::vector<PairDifference> pair_differences(const PairList& claimed,
                                                           const std::vector<ListedPair>& truth);

}  // namespace flowcert
