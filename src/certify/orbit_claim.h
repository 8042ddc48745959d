// An orbit read from JSON (spec/formats/orbit.md).
//
// Guarantees: all numbers are exact. Anything but an orbit throws InvalidInput. Other keys are ignored. The contact
// sets of segments may be left out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert {

struct PathSegment {
  std::string type;
  RationalPoint driver;
  std::optional<RationalPoint> end;  // none: infinity
  // Contact sets of the start, on the way, and of the end, ascending. None if it is not claimed, or at infinity.
  std::optional<std::vector<PointId>> start_contact;
  std::optional<std::vector<PointId>> crossed_contact;
  std::optional<std::vector<PointId>> end_contact;
};

struct PathLimit {
  std::string kind;   // "critical", "regular"
  std::string index;  // as JSON writes it: "2", "[1,2]"
  RationalPoint position;
  std::vector<PointId> contact;
  Rational squared_distance;
};

struct OrbitPath {
  std::vector<PathSegment> segments;
  std::optional<PathLimit> limit;  // none: infinity
};

// From the text of an object with `segments` and `limit`, without a byte order mark. name: of the file, for messages.
[[nodiscard]] OrbitPath claimed_orbit_of(std::string_view bytes, const std::string& name);

}  // namespace flowcert
