// Exactly degenerate configurations of integer points, which the families then turn, shift, round, nudge or
// scale.
//
// Guarantees: what each name says holds exactly, and survives `placed`. Points may repeat where they are
// drawn one by one; `distinct` removes that. Every configuration fits in |coordinate| <= 100.
#pragma once

#include "fuzz/integer_points.h"

namespace flowcert::fuzz {

// Of {0..width-1}^3.
rc::Gen<IntegerPoints> lattice_points(Integer width, std::size_t least, std::size_t most);

// Signed permutations of one vector: cospherical, often all on few circles as well.
rc::Gen<IntegerPoints> signed_permutations(std::size_t least, std::size_t most);
// x² + y² + z² = N.
rc::Gen<IntegerPoints> points_of_a_sphere(std::size_t least, std::size_t most);
// Corners of an axis-parallel box: cospherical, every angle right.
rc::Gen<IntegerPoints> box_corners(std::size_t least, std::size_t most);
// On one circle about the origin in the plane z = 0.
rc::Gen<IntegerPoints> points_of_a_circle(std::size_t least, std::size_t most);
// On two circles about one axis, so many on each: two cocircular faces of one sphere or more.
rc::Gen<IntegerPoints> points_of_two_circles(std::size_t least, std::size_t most);

// The three below have the origin as a regular stationary point, of the kind that they are named after: the
// points of a ball's boundary come first, then up to four further points outside that ball.
//
// Kind (1,2): two opposite points of a circle, and others of it on one side only.
rc::Gen<IntegerPoints> right_angles_12();
// Kind (2,3): points of a great circle around the centre, and others of the sphere on one side only.
rc::Gen<IntegerPoints> right_angles_23();
// Kind (1,3): two opposite points of a sphere, and others of it within less than half a turn about them.
rc::Gen<IntegerPoints> right_angles_13();

// Any of the above, distinct and placed.
rc::Gen<IntegerPoints> any_configuration();

}  // namespace flowcert::fuzz
