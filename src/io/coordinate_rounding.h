// How coarsely the coordinates of points are rounded, as far as their digits say, and what that does to lengths.
//
// Guarantees: exact, and the same for every order of the points. The unit is that of the last decimal place that a
// coordinate needs, in its shortest decimal that reads back: as a float if all coordinates are floats. Integers are not
// taken to be rounded.
#pragma once

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"

namespace flowcert::io {

// A power of ten, or 0 where all coordinates are integers. O(n).
[[nodiscard]] Rational coordinate_unit(const PointSet& points);

// How far lengths of persistence pairs may be apart that were equal before coordinates were rounded: 7/2 of the unit.
// (A point moves by at most sqrt(3)/2 of it, and so does every critical value; a length is a difference of two. Two
// lengths come apart by at most 2 sqrt(3) < 7/2 units.)
[[nodiscard]] Rational length_rounding(const PointSet& points);

}  // namespace flowcert::io
