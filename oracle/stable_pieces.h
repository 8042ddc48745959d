// What the skeleton of a stable set stands for (FC-STAB-02): cones over its pieces, with samples as apexes.
//
// Whether a point is in the stable set is decided from these cones alone; nothing flows. Exact.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "oracle/stable_set.h"

namespace oracle {

// {p, front, back} of a backward segment, p one of its two samples (FC-STAB-04).
using Triangle = std::array<Point, 3>;

// The triangles whose union, up to their boundaries, is a stable set of dimension 2, in the order of its
// segments, for each first that of the lesser sample. Throws std::invalid_argument for a set with an
// interval, which has dimension 3 (FC-STAB-06).
std::vector<Triangle> triangles(const PointSet& set, const StableSet& stable);

// FC-STAB-07, by class names, the first not repeated at the end: from the least sample of C(z) on, towards
// the lesser of its neighbours in the polygon. For z critical of index 2 or regular stationary of kind (1,2);
// of the latter, the side whose midpoint z is stays as it is. Throws std::invalid_argument for another z, and
// for a set with a Voronoi vertex.
std::vector<std::size_t> boundary_walk(const PointSet& set, const StationaryPoint& z,
                                       const StableSet& stable);

// The sides of those triangles that lie on an odd number of them, p0 m and m p1 taken together as p0 p1:
// pairs of class names, each ascending, in ascending order. Throws std::invalid_argument for a set with a
// Voronoi vertex.
std::vector<std::array<std::size_t, 2>> boundary_edges(const StableSet& stable);

// Those that no interval adds: reached from z along segments alone.
std::size_t segments_without_intervals(const StationaryPoint& z, const StableSet& stable);

// Whether there is a Voronoi vertex or a regular back: then FC-STAB-07 leaves the boundary open.
bool has_tie(const StableSet& stable);

// Whether x is in the stable set.
bool contains(const PointSet& set, const StableSet& stable, const Point& x);

}  // namespace oracle
