// The properties' way to fail on an input.
//
// Guarantees: none beyond those of its parts.
#pragma once

#include <rapidcheck.h>

#include <sstream>
#include <string>

#include "fuzz/inputs/input.h"
#include "fuzz/properties/orbit_comparison.h"
#include "fuzz/properties/subject.h"

namespace flowcert::property {

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
