// What a conformance vector says is right, as the truth by which a claim is judged.
//
// Guarantees: stationary points, and limits where the vector has them, are the vector's; what it does not
// have, limits and polylines of U2, the oracle computes from these stationary points. The fast implementation
// has no say in it.
#pragma once

#include <memory>

#include "flowcert/check.h"
#include "fuzz/judge/vector_cases.h"

namespace flowcert::judge {

// The case, which must not be an invalid one, must outlive it.
[[nodiscard]] std::unique_ptr<Truth> vector_truth(const VectorCase& one);

}  // namespace flowcert::judge
