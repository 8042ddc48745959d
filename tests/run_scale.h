// How much a run of the tests draws and enumerates: FLOWCERT_PROPERTY_SCALE, and 1 without it.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace flowcert_tests {

inline double scale_of_run() {
  const char* text = std::getenv("FLOWCERT_PROPERTY_SCALE");
  return text == nullptr ? 1.0 : std::max(0.0, std::strtod(text, nullptr));
}

// ./dev test --slow draws four times as many inputs as ./dev test does, and leaves out nothing of what is enumerated.
inline bool is_whole_run() { return scale_of_run() >= 4; }

}  // namespace flowcert_tests
