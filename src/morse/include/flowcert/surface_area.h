// The area of the triangles which the backward segments of a stable set stand for (spec clauses FC-STAB-04, FC-POCK-04).
//
// Guarantees: a double with a relative error of at most 2^-40. Doubles with a bound give most areas; exact corners are
// made for the others. Each segment stands for two triangles of one area, one with each of its samples.
#pragma once

#include <cstddef>

#include "flowcert/point_set.h"
#include "flowcert/stable_manifolds.h"

namespace flowcert {

// Of the i-th set of `stable`, which is of these points. An infinity where it would overflow. O(segments).
[[nodiscard]] double surface_area(const PointSet& points, const StableManifolds& stable, std::size_t i);

}  // namespace flowcert
