// The medial axis as unstable sets of some critical points (FC-MED-01 to 03).
//
// Angles are compared by their cosines, which are rational. Exact, for any finite point set of any dimension.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/persistence.h"
#include "oracle/stationary_points.h"

namespace oracle {

// The cosine of the largest angle between two contacts, seen from the stationary point, which is no sample.
Rational contact_cosine(const PointSet& set, const StationaryPoint& z);

// The critical points of index 1 and 2 whose angle has a cosine less than this, by place in `all`, ascending.
std::vector<std::size_t> above_angle(const PointSet& set, const std::vector<StationaryPoint>& all,
                                     const Rational& cosine);

// How many critical points of this index and value are in a pair that is longer than X. Which ones may vary
// (FC-PERS-04). `pairs` are those of persistence_pairs(), and the index is 1 or 2.
std::size_t count_above_persistence(const std::vector<PersistencePair>& pairs, int index, const Rational& value,
                                    const Rational& squared_persistence);

// Whether x is in the union of the unstable sets U1 and U2 of these critical points of index 1 and 2.
bool in_medial_axis(const PointSet& set, const std::vector<StationaryPoint>& chosen, const Point& x);

}  // namespace oracle
