// An orbit as JSON says it (spec/formats.md, section 4), and whether it is the right one.
//
// Guarantees: compared exactly. What is no orbit throws InvalidInput; further keys are ignored, and the
// contact sets of segments may be left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/json_fields.h"

namespace flowcert {

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

// "-3/4", "5": an integer is exact, however large, not the double near it that a command line would take it
// for.
[[nodiscard]] Rational exact_rational(const std::string& text);

// From an object with `segments` and `limit`.
[[nodiscard]] OrbitPath orbit_path_of(const Json& object);

// The first place where a claimed orbit differs.
struct PathDifference {
  bool is_permitted = false;
  std::string claimed;  // in words
  std::string truth;
};

// Nothing iff it is the right one. One that comes to the regular stationary point where the right one ends
// may go on from there, or come to it in another way: that is a permitted difference.
[[nodiscard]] std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth);

}  // namespace flowcert
