// Exactly degenerate configurations of integer points, and the families that draw them. Their stable sets have parts
// that are rare elsewhere: branches of S2 that end at Voronoi vertices, and sectors that are cut off by other points.
//
// Guarantees: as in configurations.h, what is said here holds exactly, and survives `placed`. There are up to 12
// points, and |coordinate| <= 40; points may repeat.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// The first three points are (-a,0,0), (a,0,0) and, far up, (0,c,0). The centre of their triangle is on the y axis,
// above (0,t,0), t > 0. A sphere around (0,t,0) goes through the first two, and the third is outside of it. Up to
// three further points lie on that sphere below y = 0, and others lie well below it. Going down from the triangle's
// centre, the branch of the side on the x axis meets a Voronoi vertex in (0,t,0), unless another point cuts it off
// before.
rc::Gen<IntegerPoints> aimed_points();

// The same triangle and Voronoi vertex, with just two points p, q of the sphere below. All four triangles of p, q,
// (-a,0,0) and (a,0,0) are obtuse; those that contain q are obtuse at q. So no interval leads to the Voronoi vertex.
// The three edges at q do lead there, and p is an end of only one of them.
rc::Gen<IntegerPoints> aimed_at_a_star();

// The first four points lie on the sphere of radius 20 around the origin, which is a regular stationary point. So
// intervals lead to it. The others lie just outside of the sphere, where they cut the Voronoi facets into which
// sectors reach.
rc::Gen<IntegerPoints> crowded_points();

// ---- Families ----
// Nearly all inputs of these families have stable sets with those rare parts. The guarantees are those of families.h.
// They are a list of their own, because the numbered cases of case_stream.h take turns over families(), and an id
// names its input for good.
const std::vector<Family>& stable_families();

// families(), and then these.
std::vector<Family> families_and_stable_ones();

}  // namespace flowcert::fuzz
