// Starts of orbits for a point set: in Voronoi faces of every dimension, on stationary points, outside.
//
// Guarantees: a function of its arguments, the same on every machine. Nothing is assumed of the points. The
// choice is greedy: each start has an orbit that shows as much as possible that the earlier ones do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle::vectors {

// There are none iff there are no points.
std::vector<Point> chosen_starts(const PointSet& set, const Answer& answer, std::size_t count, std::uint64_t seed);

}  // namespace oracle::vectors
