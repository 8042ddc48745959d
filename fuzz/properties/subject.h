// An input as both implementations see it.
//
// Guarantees: none beyond those of its parts.
#pragma once

#include "flowcert/point_set.h"
#include "flowcert/voronoi_diagram.h"
#include "fuzz/inputs/input.h"
#include "fuzz/properties/stationary_comparison.h"
#include "oracle/stationary_points.h"

namespace flowcert::property {

struct Subject {
  explicit Subject(const fuzz::Input& rows)
      : input(rows), points(point_set_of(rows)), diagram(Delaunay(points)), set(rows.rows) {}
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  const fuzz::Input& input;
  PointSet points;
  VoronoiDiagram diagram;
  oracle::PointSet set;
};

}  // namespace flowcert::property
