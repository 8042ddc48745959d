// The persistence at which maxima are merged into pockets, as people give it.
//
// Guarantees: exact. Quantiles and gaps are of the lengths of all persistence pairs of dimension 2 (FC-TREE-05).
#pragma once

#include <string>

#include "flowcert/flow_complex.h"

namespace flowcert {

// The text is a bound (LengthBound), with the unit spacing^2. Throws InvalidInput for anything else, and for less than
// 0; the message begins with `option`. Makes the merge trees if the bound needs them.
[[nodiscard]] Rational pocket_persistence(const FlowComplex& complex, const std::string& text,
                                          const std::string& option);

}  // namespace flowcert
