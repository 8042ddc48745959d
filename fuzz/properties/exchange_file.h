// What `compute -o` writes of some rows, in memory.
//
// Guarantees: to the byte.
#pragma once

#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "flowcert/write_stationary_points.h"

namespace flowcert::property {

// Without `wanted`: with --manifolds u2,s2 --polylines --skeletons.
inline std::string exchange_file(const std::vector<Point>& rows,
                                 const RecordsToWrite& wanted = {
                                     .u2 = true, .polylines = true, .s2 = true, .skeletons = true}) {
  const FlowComplex complex{std::span(rows)};
  std::ostringstream out;
  write_stationary_points(out, complex, wanted);
  return out.str();
}

}  // namespace flowcert::property
