// An input as both implementations see it, and the properties' way to fail on it.
//
// Guarantees: none beyond those of its parts.
#pragma once

#include <rapidcheck.h>

#include <sstream>
#include <string>

#include "flowcert/delaunay.h"
#include "flowcert/point_set.h"
#include "fuzz/input.h"
#include "oracle/stationary_points.h"
#include "tests/property/orbit_comparison.h"
#include "tests/property/stationary_comparison.h"

namespace flowcert::property {

struct Subject {
  explicit Subject(const fuzz::Input& rows)
      : input(rows), points(point_set_of(rows)), delaunay(points), set(rows.rows) {}
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  const fuzz::Input& input;
  PointSet points;
  Delaunay delaunay;
  oracle::PointSet set;
};

// Fails the property unless the complaint is empty; `details` (an orbit, two of them) are printed too.
inline void require_none(const fuzz::Input& input, const std::string& complaint, const std::string& details) {
  if (!complaint.empty()) {
    std::ostringstream text;
    text << complaint << "\ninput:\n" << input << details;
    RC_FAIL(text.str());
  }
}

inline void require_same(const fuzz::Input& input, const std::string& what, const OrbitRecord& a,
                         const OrbitRecord& b) {
  const std::string found = difference(a, b);
  if (!found.empty()) {
    require_none(input, what + ": " + found, "the first:\n" + to_text(a) + "the second:\n" + to_text(b));
  }
}

}  // namespace flowcert::property
