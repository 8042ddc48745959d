// The terms of the cascade's directions (src/flow/kernels/direction.h and direction_across.h).
//
// Guarantees: a module has what one function computes. A direction has the terms of its vector and of its error, and a
// tree that answers Positive where it is known.
#pragma once

#include <vector>

#include "tests/proofs/coq_module.h"

namespace flowcert::proofs {

// Points p0 and p1 are the ends of the facet's edge, and q, r and s are points 2, 3 and 4. Vector 6 is the direction,
// and variable 21 its error. A start has points 2 to 5.
[[nodiscard]] std::vector<CoqModule> direction_modules();

}  // namespace flowcert::proofs
