// The persistence at which maxima are merged into pockets, as people give it.
//
// Guarantees: exact. Quantiles and valleys are of the lengths of all persistence pairs of dimension 2 (FC-TREE-05).
#pragma once

#include <optional>
#include <string>

#include "flowcert/flow_complex.h"
#include "morse/length_bound.h"

namespace flowcert {

// Where `auto` finds no valley, pockets are merged that are not deeper than so many times the samples' spacing.
inline const Rational kShallowInSpacings = {1, 2};

struct PocketPersistence {
  Rational square;                              // 0: nothing is merged
  std::optional<AutomaticThreshold> automatic;  // for "auto"
};

// The text is a bound (LengthBound). Throws InvalidInput for anything else, and for less than
// 0; the message begins with `option`. Makes the merge trees if the bound needs them.
[[nodiscard]] PocketPersistence pocket_persistence(const FlowComplex& complex, const std::string& text,
                                                   const std::string& option);

}  // namespace flowcert
