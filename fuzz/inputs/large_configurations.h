// Point sets of any size, made for long orbits and for Voronoi facets of high degree. Benchmarks run on them, and so
// do tests that need more points than a family may have.
//
// Guarantees: a function of the arguments alone, the same on every machine; no RapidCheck. All coordinates
// are integers below 2^51 in magnitude, all rows are distinct unless it is said that they repeat. What is said of
// facets and cascades holds exactly; families_test checks it in exact arithmetic, on some hundreds of points. A size
// that a function cannot serve throws std::invalid_argument.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

// Rows 0 and 1 are p0 = (0,0,-h) and p1 = (0,0,h). The other rows are their neighbours, `degree` of them, 10 to
// 100,000. The Voronoi facet of p0p1 is a bounded polygon with `degree` sides, one for each neighbour. The midpoint
// of p0p1, the origin, lies outside of the facet. So rays from there enter the facet through sides of obtuse
// neighbours, and leave it through sides of acute ones.
//
// Unperturbed, the neighbours lie on one circle of the plane z = 0, in cyclic order, and the facet's sides touch an
// ellipse. Perturbed, they lie near such a circle; their random distances from it and its plane are as large as the
// degree allows.
Input high_degree_facet(std::size_t degree, bool perturbed, std::uint64_t seed);

// A paraboloid with an elliptical section, open at the top, sampled once in each cell of a square grid and
// rounded to integers: few maxima, and orbits that run along the sheet inside of it.
Input half_shell(std::size_t points, std::uint64_t seed);

// Two combs are points close to two lines that lean away from each other along the x axis. At either end a point
// closes the strip between them. There are 8 to 100,000 points. Rows 0 and 1 are the foremost teeth, rows 2 and 3
// close the narrow end and the wide end. Each later tooth stands further along the x axis than the one before, on
// either line in turn.
//
// Rows 0 and 1 make a critical point of index 1. The flow from there along the x axis crosses their facet, and one
// for each tooth that follows: points - 3 facets in all. Rows 0, 1, 2 make a critical point of index 2 from which the
// flow enters the strip. The last two rows and row 3 make another, from which the way back leads through the whole
// strip.
Input long_cascade(std::size_t points, std::uint64_t seed);

// ---- Ties everywhere ----
// Nearly every Voronoi vertex of these is that of more than four points. There are 1 to 100,000 points.

// Points of a box of a lattice with edges of 1 to 3, and holes: an eighth of its points is missing, or more.
Input lattice_piece(std::size_t points, std::uint64_t seed);
// Planes of a square lattice, shifted against each other by whole or half edges, at distances of 1 to 6. They have
// holes.
Input lattice_layers(std::size_t points, std::uint64_t seed);
// Points of x²+y²+z² = N, of x²+y²+z² = N + 1, and so on: concentric spheres close to each other.
Input integer_spheres(std::size_t points, std::uint64_t seed);
// A cylinder that ends in two half spheres, rounded to a grid of 16 to 200 cells in its radius. Rows may repeat.
Input rounded_capsule(std::size_t points, std::uint64_t seed);

}  // namespace flowcert::fuzz
