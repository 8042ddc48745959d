// The parts that several of our JSON outputs share (spec/formats.md), so that they are spelled once.
#pragma once

#include <nlohmann/json.hpp>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "flowcert/stationary_points.h"
#include "io/layer.h"

namespace flowcert::io {

// Keys stay in the order in which the formats list them.
using Json = nlohmann::ordered_json;

// format, format_version, the reproducibility line and input_sha256.
[[nodiscard]] Json header_fields(const char* format, int format_version, const std::string& input_sha256);

// points, merged_duplicates, critical, regular_stationary, appended to an object.
void add_counts(Json& object, const PointSet& points, const StationaryPoints& stationary);

// 0 to 3, or the pair of a regular stationary point's kind.
[[nodiscard]] Json index_field(StationaryIndex index);

[[nodiscard]] Json center_field(const RationalPoint& point);
// null where the nearest double would overflow.
[[nodiscard]] Json double_field(const Rational& value);

}  // namespace flowcert::io
