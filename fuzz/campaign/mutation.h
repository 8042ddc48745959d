// Mutations are small changes of an input that make it degenerate in one more way. A campaign applies them to the
// inputs that it keeps.
//
// Guarantees: nothing is rounded. The relation that a mutation names holds exactly between the doubles of the result.
// If the new point has no doubles as coordinates, the whole input is multiplied until all coordinates are integers
// below 2^40. If that is impossible, the mutation does not apply. (Snapping and nudging change coordinates on
// purpose.) A result differs from its parent, has finite coordinates and a row at least. It has at most
// kMostMutantRows unless the parent has more. It is a function of parent and seed, the same on every machine: all
// randomness is rc::Random.
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
  // The first of these rows of `input` has moved or is new. The others determine its place, in the order in which the
  // mutation's description names them. Empty if the mutation names no points.
  std::vector<std::size_t> rows;
  std::string by = {};  // the mutation's name
};

struct Mutation {
  std::string name;         // kebab-case
  std::string description;  // x is the moved point, p, q, r, s are others in the order of Mutant::rows
  // Returns nothing if the mutation does not apply, or if some tries have not led to an exact result.
  std::function<std::optional<Mutant>(const Input& parent, rc::Random& random)> apply;
};
const std::vector<Mutation>& mutations();

// Applies one of the mutations that apply. There always is one.
[[nodiscard]] Mutant mutated(const Input& parent, std::uint64_t seed);

}  // namespace flowcert::fuzz
