// See nudge.h for what it guarantees.
#include "fuzz/inputs/nudge.h"

#include <cmath>
#include <limits>

namespace flowcert::fuzz {

double nudged(double value, int steps) {
  if (steps == 0) {
    return value;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(value, steps > 0 ? infinity : -infinity);
}

}  // namespace flowcert::fuzz
