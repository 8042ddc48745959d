// The cavities between balls for one probe, from one triangulation of space, without critical points.
//
// Guarantees: exact. Cavities are the bounded components of the places of a probe's centre where it overlaps no ball;
// to touch is allowed. Source: spec clause FC-BALL-07.
#pragma once

#include <cstdint>
#include <vector>

#include "flowcert/ball_set.h"
#include "flowcert/rational.h"

namespace flowcert {

struct BallCavity {
  std::vector<std::uint32_t> atoms;  // whose balls bound it, by id, ascending; no hidden ones
};

// The cavities, by their atoms. The probe is not negative. Expected O(n log n) for atoms.
[[nodiscard]] std::vector<BallCavity> ball_cavities(const BallSet& balls, const Rational& probe);

}  // namespace flowcert
