// The intervals of cavities (FC-BALL-07), from the nerve of the open balls: by mod-2 homology, without any way between
// the balls.
//
// All sets of at most four balls are listed, each with the least s at which the balls, grown by s, have a common point.
// A cavity is a class of dimension 2. Exact. The list takes time n^4, and the reduction in the worst case the cube of
// that. So this is meant for a dozen balls.
#pragma once

#include <optional>
#include <vector>

#include "oracle/balls.h"

namespace oracle {

// A cavity that there is at s for gate < s <= peak. No gate: there is one down to 0.
struct Cavity {
  std::optional<Quadratic> gate;
  Quadratic peak;

  friend bool operator==(const Cavity&, const Cavity&) = default;
};
// The order by falling peaks, and by falling gates, one that does not exist last.
bool operator<(const Cavity& one, const Cavity& other);

// Those with a peak of 0 or more, ascending, each as often as it occurs.
std::vector<Cavity> cavities_by_homology(const std::vector<Ball>& balls);

}  // namespace oracle
