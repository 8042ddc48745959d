// Exactly degenerate configurations of integer points, which the families then turn, shift, round, nudge or
// scale.
//
// Guarantees: what each name says holds exactly, and survives `placed`. Points may repeat where they are
// drawn one by one; `distinct` removes that. Every configuration fits in |coordinate| <= 1000.
#pragma once

#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// Points of {0..width-1}^3.
rc::Gen<IntegerPoints> lattice_points(Integer width, std::size_t least, std::size_t most);

// Signed permutations of one vector: cospherical, often all on few circles as well.
rc::Gen<IntegerPoints> signed_permutations(std::size_t least, std::size_t most);
// Points with x² + y² + z² = N.
rc::Gen<IntegerPoints> points_of_a_sphere(std::size_t least, std::size_t most);
// Corners of an axis-parallel box: cospherical, every angle right.
rc::Gen<IntegerPoints> box_corners(std::size_t least, std::size_t most);
// Points of one circle about the origin in the plane z = 0.
rc::Gen<IntegerPoints> points_of_a_circle(std::size_t least, std::size_t most);
// Points of two circles about one axis, so many of each: a sphere with two cocircular faces or more.
rc::Gen<IntegerPoints> points_of_two_circles(std::size_t least, std::size_t most);

// The three below have the origin as a regular stationary point, of the kind in their names. The points on the
// boundary of a ball come first, then up to four points outside that ball.
//
// Kind (1,2): two opposite points of a circle, and other points of that circle on one side only.
rc::Gen<IntegerPoints> right_angles_12();
// Kind (2,3): points of a great circle around the centre, and other points of the sphere on one side only.
rc::Gen<IntegerPoints> right_angles_23();
// Kind (1,3): two opposite points of a sphere, and other points of it within less than half a turn about their axis.
rc::Gen<IntegerPoints> right_angles_13();

// Any of the above, distinct and placed.
rc::Gen<IntegerPoints> any_configuration();

// The others are made for orbits; they have up to 12 points.
//
// A ring is points of a circle about the z axis, two of them opposite. Rings lie at integer heights; higher rings are
// wider. For each two rings that follow each other the axis has a Voronoi vertex above both, with all their points as
// its contact set. Going up the axis, the flow passes through all these vertices.
//
// Each ring has two opposite points and a third one. The axis is made of Voronoi edges of right triangles.
rc::Gen<IntegerPoints> rings_of_right_triangles();
// The lowest ring is a polygon around its centre, which is critical of index 2. Each other ring is two opposite
// points. Above the first Voronoi vertex, the axis runs across Voronoi facets only.
rc::Gen<IntegerPoints> rings_of_pairs();
// Points that are symmetric to the planes x = 0 and y = 0.
rc::Gen<IntegerPoints> mirrored_points();

// The first two points are (0,0,-h) and (0,0,h). The others lie on a circle of the plane z = 0, or close to it. The
// circle goes around the origin, but is not centred there. Each point on it gives a side of the first two points'
// Voronoi facet. The third point is obtuse, so the origin is not in that facet.
rc::Gen<IntegerPoints> neighbours_on_a_circle();
rc::Gen<IntegerPoints> neighbours_near_a_circle();

// Six or more teeth lie close to the lines (t, s t, 0) and (t, -s t, 0), in turn, with t growing from one to the
// next. Up to two further points close the strip between the lines at its ends. The flow from the midpoint of the
// first two teeth along the x axis crosses their Voronoi facet, and then one facet for each further tooth.
rc::Gen<IntegerPoints> opening_combs();

// Samples of a half sphere, a half cylinder or a paraboloid, open at the top, rounded, some of them off by
// one.
rc::Gen<IntegerPoints> open_shell();

}  // namespace flowcert::fuzz
