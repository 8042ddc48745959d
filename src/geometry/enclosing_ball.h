// The smallest ball that encloses a few points. Its centre is the driver of every point that has them as contact set
// (FC-DIST-02).
//
// Guarantees: exact (CGAL's Min_sphere_d over rationals), for every finite, non-empty set, even an affinely dependent
// one.
#pragma once

#include <span>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::geometry {

[[nodiscard]] RationalPoint enclosing_ball_center(std::span<const Point> points);

}  // namespace flowcert::geometry
