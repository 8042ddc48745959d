// Which balls can be nearest to one place, for sets of balls that are too large for a search over all subsets.
//
// Only near ones can: space is cut into cubes, and each has a list of balls. Distances are rounded here, with more room
// to spare than rounding takes, so that a list can have too many balls, and never too few. The answer is that of the
// search over all subsets; tests/unit/oracle_fast_test.cpp compares the two.
#pragma once

#include <set>
#include <vector>

#include "oracle/balls.h"

namespace oracle::fast {

// All subsets of at most four balls that can be contacts of one place x with d(x) >= 0 in the hull of the centres.
std::set<Places> near_subsets(const std::vector<Ball>& balls);

// The list of points (FC-BALL-03), for some hundreds of balls.
std::vector<BallPoint> critical_points(const std::vector<Ball>& balls);

}  // namespace oracle::fast
