// Exactly degenerate configurations of integer points, which the families then turn, shift, round, nudge or
// scale.
//
// Guarantees: what each name says holds exactly, and survives `placed`. Points may repeat where they are
// drawn one by one; `distinct` removes that. Every configuration fits in |coordinate| <= 1000.
#pragma once

#include "fuzz/inputs/integer_points.h"

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

// The others are made for orbits; they have up to 12 points.
//
// Rings are points of circles about the z axis at integer heights, wider and wider, and each has two opposite
// points. Between them the axis has its Voronoi vertices, each above the two rings that meet there, with all
// points of these two as its contact set: going up the axis the flow passes through all of them.
//
// Each ring two opposite points and a third one: the axis is made of Voronoi edges of right triangles.
rc::Gen<IntegerPoints> rings_of_right_triangles();
// The lowest ring a polygon around its centre, which is critical of index 2, the others two opposite points:
// above the first Voronoi vertex the axis runs across facets only.
rc::Gen<IntegerPoints> rings_of_pairs();
// Symmetric to the planes x = 0 and y = 0.
rc::Gen<IntegerPoints> mirrored_points();

// The first two points are (0,0,-h) and (0,0,h), the others lie on a circle of the plane z = 0 around the
// origin, but not centred there, or close to it: each of those on it is good for a side of the first two
// points' Voronoi facet. The third point is obtuse, so the origin is not in that facet.
rc::Gen<IntegerPoints> neighbours_on_a_circle();
rc::Gen<IntegerPoints> neighbours_near_a_circle();

// Teeth close to the lines (t, s t, 0) and (t, -s t, 0), six or more, with t growing from one to the next, on
// either line in turn. Then up to two points that close the strip between the lines at its ends. The flow
// from the middle of the first two teeth along the x axis crosses their facet, and one for each tooth that
// follows.
rc::Gen<IntegerPoints> opening_combs();

// Samples of a half sphere, a half cylinder or a paraboloid, open at the top, rounded, some of them off by
// one.
rc::Gen<IntegerPoints> open_shell();

}  // namespace flowcert::fuzz
