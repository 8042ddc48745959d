// Orbits in our JSON outputs (spec/formats.md, section 4 and 2), exact.
#pragma once

#include <optional>

#include "flowcert/orbit.h"
#include "io/json_fields.h"

namespace flowcert::io {

// type, driver, end.
[[nodiscard]] Json segment_field(const FlowSegment& segment);

// The same, with the three contact sets.
[[nodiscard]] Json segment_with_contacts_field(const FlowSegment& segment);

// kind, index, position, contact, squared_distance of where an orbit ends; none: infinity.
[[nodiscard]] Json limit_field(const PointSet& points, const std::optional<StationaryLimit>& limit);

}  // namespace flowcert::io
