// The persistence at which maxima are merged into pockets, as people give it.
//
// Guarantees: exact. Quantiles and valleys are of the lengths of all persistence pairs of dimension 2 (FC-TREE-05).
#pragma once

#include <optional>
#include <string>

#include "flowcert/flow_complex.h"
#include "flowcert/histogram_valley.h"

namespace flowcert {

struct PocketPersistence {
  Rational value;                               // 0: nothing is merged
  std::optional<AutomaticThreshold> automatic;  // for "auto"
};

// The text is a bound (LengthBound), with the unit spacing^2. Throws InvalidInput for anything else, and for less than
// 0; the message begins with `option`. Makes the merge trees if the bound needs them.
[[nodiscard]] PocketPersistence pocket_persistence(const FlowComplex& complex, const std::string& text,
                                                   const std::string& option);

}  // namespace flowcert
