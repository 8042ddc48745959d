// Where claimed persistence pairs are not the right ones (FC-CLAIM-11).
//
// Guarantees: what is claimed exactly is compared exactly. Decimals are matched within the tolerance by a matching that
// leaves over as few pairs as possible, so that near values cannot take each other's place. Both lists are multisets.
// Pairs of length zero do not count.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "certify/pair_claim.h"

namespace flowcert {

class FlowComplex;

// The pairs of positive length and the class that lasts, as persistence() finds them. This computes them if need be.
[[nodiscard]] std::vector<ListedPair> listed_pairs(const FlowComplex& complex);

// A pair that only one of the lists has, or two such pairs, one of each list. Or a cycle that does not stand for its
// pair, or a pair without one (cycle_differences.h).
struct PairDifference {
  std::string claimed;  // in words
  std::string truth;
  std::string reason = "wrong-pair";  // or "rounding" (FC-CLAIM-05), or that of a cycle
  int dimension = 0;
  bool is_claimed = false, is_true = false;  // which of the lists have one
  std::size_t line = 0;                      // of the claimed pair, as there
  std::string sentence = {};                 // that of sentence_of, where it does not follow from the reason
};

// What is wrong, in a plain sentence or two, and whether it is a bug or a convention.
[[nodiscard]] std::string sentence_of(const PairDifference& difference);

// Whether a claimed birth or death is the true one (FC-CLAIM-11).
[[nodiscard]] bool is_right_value(const ClaimedNumber& claimed, const Rational& truth, const Rational& tolerance);

// How many pairs of positive length a list has, by dimension, with those that last.
[[nodiscard]] std::array<std::size_t, kPairDimensions> pair_counts(const std::vector<ClaimedPair>& pairs);
[[nodiscard]] std::array<std::size_t, kPairDimensions> pair_counts(const std::vector<ListedPair>& pairs);

// None iff the claim is right. tolerance: as in CheckOptions. Takes time O(n log n), and for each set of pairs that are
// near each other in decimals the cube of its size.
[[nodiscard]] std::vector<PairDifference> pair_differences(const std::vector<ClaimedPair>& claimed,
                                                           const std::vector<ListedPair>& truth, double tolerance);

}  // namespace flowcert
