// What the skeleton of a stable set stands for (FC-STAB-02): cones over its pieces, with samples as apexes.
//
// These cones alone decide whether a point is in the stable set. No flow is computed. Exact.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "oracle/stable_set.h"

namespace oracle {

// {p, front, back} of a backward segment, where p is one of its two samples (FC-STAB-04).
using Triangle = std::array<Point, 3>;

// The triangles whose union, up to their boundaries, is a stable set of dimension 2. They are in the order of its
// segments, and the lesser sample's triangle comes first. Throws std::invalid_argument for a set with an interval,
// because that has dimension 3 (FC-STAB-06).
std::vector<Triangle> triangles(const PointSet& set, const StableSet& stable);

// The boundary walk of FC-STAB-07, by class names. It begins at the least sample of C(z), towards the lesser of its
// neighbours in the polygon. The first name is not repeated at the end. z must be critical of index 2 or regular
// stationary of kind (1,2). In the second case, the side with midpoint z stays as it is. Throws std::invalid_argument
// for another z, and for a set with a Voronoi vertex.
std::vector<std::size_t> boundary_walk(const PointSet& set, const StationaryPoint& z, const StableSet& stable);

// The sides that an odd number of the triangles have, where p0 m and m p1 together count as p0 p1. A side is a pair
// of class names, ascending, and the list is ascending. Throws std::invalid_argument for a set with a Voronoi vertex.
std::vector<std::array<std::size_t, 2>> boundary_edges(const StableSet& stable);

// The number of segments that are reached from z along segments alone. No interval adds these.
std::size_t segments_without_intervals(const StationaryPoint& z, const StableSet& stable);

// The squares of the areas of the triangles that the segments stand for, two for each segment. They may be of any
// stable set, and sectors do not count (FC-POCK-04).
std::vector<Rational> squared_areas(const PointSet& set, const StableSet& stable);

// Whether there is a Voronoi vertex or a regular back. If so, FC-STAB-07 leaves the boundary open.
bool has_tie(const StableSet& stable);

// FC-VOL-01.
Rational volume(const PointSet& set, const StableSet& stable);

// FC-VOL-02: how much of that is in the Voronoi cell of each sample, in the order of set.points. For infinity,
// unbounded sectors do not count. The facets of a bounded cell have none, so that the share of its sample is right.
std::vector<Rational> shares(const PointSet& set, const StableSet& stable);

// Whether x is in the stable set of a stationary point, or in a cone over the skeleton of infinity.
bool contains(const PointSet& set, const StableSet& stable, const Point& x);

// Whether the orbit of x goes to infinity, from the skeleton of infinity alone (FC-STAB-08).
bool flows_to_infinity(const PointSet& set, const StableSet& infinity, const Point& x);

}  // namespace oracle
