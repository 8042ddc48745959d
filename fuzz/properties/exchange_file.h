// What `compute --manifolds u2,s2 --polylines --skeletons -o` writes of some rows, in memory.
//
// Guarantees: to the byte.
#pragma once

#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "flowcert/write_stationary_points.h"

namespace flowcert::property {

inline std::string exchange_file(const std::vector<Point>& rows) {
  const FlowComplex complex{std::span(rows)};
  std::ostringstream out;
  write_stationary_points(out, complex, {.u2 = true, .polylines = true, .s2 = true, .skeletons = true});
  return out.str();
}

}  // namespace flowcert::property
