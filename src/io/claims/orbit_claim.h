// An orbit as JSON says it (spec/formats.md, section 4).
//
// Guarantees: all numbers are exact. What is no orbit throws InvalidInput; further keys are ignored, and the
// contact sets of segments may be left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/json_fields.h"

namespace flowcert::io {

struct PathSegment {
  std::string type;
  RationalPoint driver;
  std::optional<RationalPoint> end;  // none: infinity
  // Ascending; of the start, on the way, of the end. None where not claimed, or at infinity.
  std::optional<std::vector<PointId>> start_contact;
  std::optional<std::vector<PointId>> crossed_contact;
  std::optional<std::vector<PointId>> end_contact;
};

struct PathLimit {
  std::string kind;  // "critical", "regular"
  Json index;
  RationalPoint position;
  std::vector<PointId> contact;
  Rational squared_distance;
};

struct OrbitPath {
  std::vector<PathSegment> segments;
  std::optional<PathLimit> limit;  // none: infinity
};

// From an object with `segments` and `limit`.
[[nodiscard]] OrbitPath orbit_path_of(const Json& object);

}  // namespace flowcert::io
