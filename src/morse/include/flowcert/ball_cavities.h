// The cavities between balls for one probe, from one triangulation of space, without critical points.
//
// Guarantees: exact. Cavities are the bounded components of the places of a probe's centre where it overlaps no ball;
// to touch is allowed. The balls that line a cavity are those that the probe touches at some place of it. Source: spec
// clause FC-BALL-07.
#pragma once

#include <cstdint>
#include <vector>

#include "flowcert/ball_set.h"
#include "flowcert/rational.h"

namespace flowcert {

struct BallCavity {
  std::vector<std::uint32_t> lining;  // the balls that line it, by id, ascending
};

// The cavities, in the order of their linings. The probe is not negative. Expected O(n log n) for atoms.
[[nodiscard]] std::vector<BallCavity> ball_cavities(const BallSet& balls, const Rational& probe);

}  // namespace flowcert
