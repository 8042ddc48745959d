// What `compute --manifolds u2,s2 --polylines --skeletons -o` writes of some rows, in memory.
//
// Guarantees: to the byte.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "flowcert/reproducibility.h"
#include "io/write_manifolds.h"

namespace flowcert::property {

inline std::string exchange_file(const std::vector<Point>& rows) {
  const PointSet points(rows);
  const VoronoiDiagram diagram{Delaunay(points)};
  const StationaryPoints stationary = stationary_points(diagram);
  UnstableManifolds u2(diagram, stationary);
  StableManifolds s2(diagram, stationary);
  std::ostringstream out;
  io::write_manifolds(out, points, stationary, {.u2 = &u2, .polylines = true, .s2 = &s2, .skeletons = true},
                      coordinates_sha256(rows));
  return out.str();
}

}  // namespace flowcert::property
