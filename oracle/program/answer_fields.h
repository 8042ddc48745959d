// The oracle's answers in JSON, with the keys of spec/formats/: stationary_points.md, orbit.md, and
// vectors.md.
//
// Guarantees: exact; keys in the order of the formats.
#pragma once

#include <nlohmann/json.hpp>

#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_set.h"
#include "oracle/stationary_points.h"

namespace oracle {

using Json = nlohmann::ordered_json;

Json position_field(const Point& x);
// index, kind, contact, center, squared_distance.
Json record_field(const StationaryPoint& x);
// start, segments, limit.
Json orbit_field(const PointSet& set, const Point& start, const Orbit& path);
// segments, has_vertex, has_interval, boundary, walk. z must be critical of index 2 or regular stationary.
Json stable_field(const PointSet& set, const StationaryPoint& z, const StableSet& stable);
// segments, intervals, sectors.
Json skeleton_field(const PointSet& set, const StableSet& stable);
// An array of dimension, birth, death.
Json persistence_field(const std::vector<PersistencePair>& pairs);
// merged_duplicates, critical, regular_stationary.
Json counts_field(const Answer& answer);

}  // namespace oracle
