// An input's rows as the fast implementation takes them, and back.
//
// Guarantees: the same coordinates, in the same order.
#pragma once

#include <vector>

#include "flowcert/point_set.h"
#include "fuzz/inputs/input.h"

namespace flowcert::property {

inline std::vector<Point> rows_of(const fuzz::Input& input) {
  std::vector<Point> rows;
  rows.reserve(input.rows.size());
  for (const auto& [x, y, z] : input.rows) rows.push_back({x, y, z});
  return rows;
}

inline fuzz::Input input_of(const std::vector<Point>& rows) {
  fuzz::Input input;
  input.rows.reserve(rows.size());
  for (const Point& p : rows) input.rows.push_back({p.x, p.y, p.z});
  return input;
}

inline PointSet point_set_of(const fuzz::Input& input) { return PointSet(rows_of(input)); }

}  // namespace flowcert::property
