// Numbers and signs. In go samples, which are doubles. Out come signs of polynomials in them (predicates.h), all signs
// of a Delaunay cell at once (tetrahedron_signs.h), spheres within proven bounds or exact, and roots compared exactly.
//
// The hard part is to be exact and to take the time of doubles. A double filter with a proven bound answers first;
// integers of a fixed size, and then GMP's, answer what it leaves open. No rung guesses, and none divides.
//
// To be read in this order: vector3.h has the polynomials, filter_bounds.h the bounds and their proofs, predicates.h
// the rungs. Then tetrahedron_signs.h and tetrahedron_lanes.h, where most of the time of stationary points goes, and
// double_double.h with bounded_number.h, which decide nearest doubles. The other files serve single users.
#pragma once

namespace flowcert::geometry {}
