// Truths by which claims are judged without the fast implementation: the oracle's, and a conformance vector's.
#pragma once

#include <memory>
#include <vector>

#include "certify/other_truth.h"
#include "certify/programs/vector_cases.h"
#include "certify/truth.h"
#include "fuzz/judge/layer.h"

namespace flowcert::judge {

// ---- The oracle's ----
// For `flowcert check --oracle`: every stationary point and every orbit from the definitions, by scans over all
// points. For small inputs.

// Its search takes time n^5.
inline constexpr std::size_t kMostPointsForOracle = 100;

// Throws InvalidInput for more than kMostPointsForOracle rows.
[[nodiscard]] std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows);

// ---- A vector's ----
// What a conformance vector says is right, as the truth by which a claim is judged.
//
// Guarantees: stationary points are the vector's; so are limits, and boundaries and summaries of stable sets, where
// the vector has them. The oracle computes everything else from these stationary points. The fast implementation has
// no part in it.
// The case must not be an invalid one, and must outlive the truth.
[[nodiscard]] std::unique_ptr<Truth> vector_truth(const VectorCase& one);

// Both, and persistence pairs, for code that does not know the oracle.
[[nodiscard]] OtherTruth truth_of_oracle();

}  // namespace flowcert::judge
