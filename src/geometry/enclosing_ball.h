// The smallest ball that encloses a few points: its centre is the driver of any point that has them as
// contact set (FC-DIST-02).
//
// Guarantees: exact (CGAL's Min_sphere_d over rationals); any finite, non-empty set, affinely dependent ones
// too.
#pragma once

#include <span>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::geometry {

[[nodiscard]] RationalPoint enclosing_ball_center(std::span<const Point> points);

}  // namespace flowcert::geometry
