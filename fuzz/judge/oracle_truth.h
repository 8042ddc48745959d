// Truths by which claims are judged without the fast implementation: the oracle's, and a conformance vector's.
#pragma once

#include <memory>
#include <vector>

#include "flowcert/check.h"
#include "fuzz/judge/layer.h"
#include "fuzz/judge/vector_cases.h"
#include "oracle/stationary_points.h"

namespace flowcert::judge {

// ---- The oracle's ----
// For `flowcert check --oracle`: every stationary point and every orbit from the definitions, by scans over all
// points. For small inputs.

// Its search takes time n^5.
inline constexpr std::size_t kMostPointsForOracle = 100;

// Throws InvalidInput for more than kMostPointsForOracle rows.
[[nodiscard]] std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows);

// Where all stationary points of the rows are known, in the order of FC-OUT-02: only what flows from them is
// left to do.
[[nodiscard]] std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows, oracle::Answer answer);

// ---- A vector's ----
// What a conformance vector says is right, as the truth by which a claim is judged.
//
// Guarantees: stationary points, and limits where the vector has them, are the vector's; what it does not
// have, limits and polylines of U2, the oracle computes from these stationary points. The fast implementation
// has no say in it.
// The case, which must not be an invalid one, must outlive it.
[[nodiscard]] std::unique_ptr<Truth> vector_truth(const VectorCase& one);

}  // namespace flowcert::judge
