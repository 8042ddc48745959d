// The truth by the oracle, for `flowcert check --oracle`: every stationary point and every orbit from the
// definitions, by scans over all points. For small inputs.
#pragma once

#include <memory>
#include <vector>

#include "flowcert/check.h"
#include "fuzz/judge/layer.h"
#include "oracle/stationary_points.h"

namespace flowcert::judge {

// Its search takes time n^5.
inline constexpr std::size_t kMostPointsForOracle = 100;

// Throws InvalidInput for more than kMostPointsForOracle rows.
[[nodiscard]] std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows);

// Where all stationary points of the rows are known, in the order of FC-OUT-02: only what flows from them is
// left to do.
[[nodiscard]] std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows, oracle::Answer answer);

}  // namespace flowcert::judge
