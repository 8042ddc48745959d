// A dense sample of a smooth closed surface, with a long cascade. The surface is a capsule: a round cylinder that ends
// in two half spheres.
//
// Guarantees: every point lies on the capsule exactly; coordinates are integers below 2^48 in magnitude. The medial
// axis of the capsule is the segment from (0,0,-kCapsuleHalfLength) to (0,0,kCapsuleHalfLength), and every point of the
// surface has the distance kCapsuleRadius from it. Every point of the surface has a sample within kCapsuleEpsilon of
// that distance: this is an epsilon-sample. capsule_sample_test checks both. The same points on every machine.
//
// The adversary (paper, section 6): all but `teeth` of the points are there once and for all. The teeth stand on the
// cylinder along two lines that lean away from each other, and one more point closes the wide end of the strip between
// them. The last two teeth and that point make a critical point of index 2. From there the way back to the two first
// teeth, an orbit of its stable manifold, crosses a facet for each tooth. So orbits grow as the number of samples does,
// while the surface and epsilon stay.
#pragma once

#include <cstddef>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// 5² 13² 17² 29 37 41 53 61: circles of this radius have 121,500 integer points.
constexpr Integer kCapsuleRadius = Integer{25} * 169 * 289 * 29 * 37 * 41 * 53 * 61;
constexpr Integer kCapsuleHalfLength = kCapsuleRadius / 4;
constexpr double kCapsuleEpsilon = 0.06;
constexpr std::size_t kMostCapsuleTeeth = 1000;

// 20 to kMostCapsuleTeeth teeth, an even number of them. They come first, from the narrow end to the wide one. Then
// comes the point that closes the strip. Throws std::invalid_argument for another number.
Input capsule_sample(std::size_t teeth);

}  // namespace flowcert::fuzz
