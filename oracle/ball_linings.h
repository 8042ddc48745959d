// The cavities at a probe s, by the balls that line them (FC-BALL-07): those that have a contact of a place of the
// cavity where d is s.
//
// Places with d = s are sought on all spheres of balls that have grown by s, and ways lead from them to index-3 points.
// Exact. This is meant for a dozen balls.
#pragma once

#include "oracle/pores.h"

namespace oracle {

// Ascending lists of ids, in ascending order. `found` are the pores of these balls. The probe is not negative.
std::vector<Places> cavity_linings(const std::vector<Ball>& balls, const Pores& found, const Rational& probe);

}  // namespace oracle
