// The findings of landscape.h, locations and the set of infinity in JSON, with the keys of spec/formats/vectors.md.
//
// Guarantees: exact; keys in the order of the formats. A pocket's number is its place, and -1 is the outside.
#pragma once

#include "oracle/orbit.h"
#include "oracle/program/answer_fields.h"
#include "oracle/stable_set.h"
#include "tests/vectors/landscape.h"

namespace oracle::vectors {

// position, kind, index, contact, nearest.
Json location_field(const Point& x, const Location& location);
// pockets and components, each with leaves and nodes.
Json trees_field(const std::vector<StationaryPoint>& all, const Trees& trees);
Json pockets_field(const std::vector<StationaryPoint>& all, const std::vector<PocketAnswer>& answers);
// angles and persistences.
Json medial_field(const std::vector<StationaryPoint>& all, const MedialAnswer& answer);
// segments, intervals, sectors, and those with an end at infinity.
Json infinity_field(const PointSet& set, const StableSet& infinity);
// n_u2, n_s2, n_wcc.
Json statistics_field(const StatisticsAnswer& answer);

}  // namespace oracle::vectors
