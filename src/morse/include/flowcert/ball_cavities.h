// The cavities between balls for one probe, from one triangulation of space, without critical points.
//
// Guarantees: exact. Cavities are the bounded components of the places of a probe's centre where it overlaps no ball;
// to touch is allowed. A ball lines a cavity iff it is as near as the probe's radius to some place of it, and no ball is
// nearer to that place. Source: spec clause FC-BALL-07.
#pragma once

#include <cstdint>
#include <vector>

#include "flowcert/ball_set.h"
#include "flowcert/rational.h"

namespace flowcert {

struct BallCavity {
  std::vector<std::uint32_t> atoms;  // the balls that line it, by id, ascending
};

// The cavities, in the order of their atoms. The probe is not negative. Expected O(n log n) for atoms.
[[nodiscard]] std::vector<BallCavity> ball_cavities(const BallSet& balls, const Rational& probe);

}  // namespace flowcert
