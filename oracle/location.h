// Where a point of space flows to, and the samples that are nearest to it (FC-LOC-01).
//
// It follows the orbit of the point to its end. Exact, for any finite point set of any dimension.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

struct Location {
  std::optional<StationaryPoint> limit;  // nothing: infinity
  std::vector<std::size_t> nearest;      // C(x), by class names, ascending

  friend bool operator==(const Location&, const Location&) = default;
};

// Throws std::invalid_argument for the empty set (FC-LOC-02).
Location locate(const PointSet& set, const Point& x);

}  // namespace oracle
