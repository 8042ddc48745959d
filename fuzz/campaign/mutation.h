// Small changes of an input that make it degenerate in one more way: what a campaign makes of the inputs that
// it keeps.
//
// Guarantees: no rounding. A relation that a mutation speaks of holds exactly between the doubles of the
// result; where the point that makes it hold is not one of doubles, the whole input is multiplied until all
// its coordinates are integers, below 2^40, and where that cannot be the mutation does not apply. (Snapping
// and nudging change coordinates on purpose.) A result has finite coordinates, a row at least, no more than
// kMostMutantRows unless the parent has more, and differs from its parent. It is a function of parent and
// seed, the same on every machine: all randomness is rc::Random.
#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

inline constexpr std::size_t kMostMutantRows = 12;

struct Mutant {
  Input input;
  std::string by;  // the mutation's name
  // Rows of `input`: the one that has moved or come, and then those that the mutation has placed it by, in
  // the order in which its description names them. Empty where it speaks of none.
  std::vector<std::size_t> rows;
};

struct Mutation {
  std::string name;         // kebab-case
  std::string description;  // x is the moved point, p, q, r, s are others in the order of Mutant::rows
  // Nothing where it does not apply, or where some tries have not led to an exact result.
  std::function<std::optional<Mutant>(const Input& parent, rc::Random& random)> apply;
};
const std::vector<Mutation>& mutations();

// By one of those that apply, which is never none.
[[nodiscard]] Mutant mutated(const Input& parent, std::uint64_t seed);

}  // namespace flowcert::fuzz
