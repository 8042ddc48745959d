// Exactly degenerate configurations of integer points whose stable sets have parts that the stable sets of other
// configurations hardly ever have: branches of S2 that end at Voronoi vertices, and sectors cut off by what stands
// around them; and the families that draw them.
//
// Guarantees: as configurations.h: what is said here holds exactly, and survives `placed`. Up to 12 points,
// |coordinate| <= 40; points may repeat.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// (-a,0,0), (a,0,0) and, far up, (0,c,0): a triangle whose centre is on the axis of y, above (0,t,0), t > 0.
// That is the centre of a sphere through the first two, which the third is outside of; further points, if
// there are any, lie on that sphere below y = 0, three at most, or well below it. Going down from the
// triangle's centre the branch of its side on the axis of x meets a Voronoi vertex in (0,t,0), where no other
// point cuts it off before.
rc::Gen<IntegerPoints> aimed_points();

// The same triangle and the same Voronoi vertex, with just two points p, q of its sphere below: all four
// triangles of these and (-a,0,0), (a,0,0) are obtuse, those at q at q. So no interval leads to the Voronoi
// vertex, but the three edges at q do, and p is an end of only one of them.
rc::Gen<IntegerPoints> aimed_at_a_star();

// The first four points lie on the sphere of radius 20 around the origin, which is a regular stationary
// point, so that intervals lead to it; the others just outside of it, where they cut the facets into which
// sectors reach.
rc::Gen<IntegerPoints> crowded_points();

// ---- Families ----
// An input of most other families has no stable set with the parts that these nearly always have. The guarantees are
// those of families.h. They are a list of their own, not members of families(): the numbered cases of
// case_stream.h take turns over that list, and an id names its input for good.
const std::vector<Family>& stable_families();

// families(), and then these.
std::vector<Family> families_and_stable_ones();

}  // namespace flowcert::fuzz
