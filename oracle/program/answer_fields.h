// The oracle's answers in JSON, with the keys of spec/formats/: stationary_points.md and orbit.md.
//
// Guarantees: exact; keys in the order of the formats.
#pragma once

#include <nlohmann/json.hpp>

#include "oracle/orbit.h"
#include "oracle/stationary_points.h"

namespace oracle {

using Json = nlohmann::ordered_json;

Json position_field(const Point& x);
// index, kind, contact, center, squared_distance.
Json record_field(const StationaryPoint& x);
// start, segments, limit.
Json orbit_field(const PointSet& set, const Point& start, const Orbit& path);
// merged_duplicates, critical, regular_stationary.
Json counts_field(const Answer& answer);

}  // namespace oracle
