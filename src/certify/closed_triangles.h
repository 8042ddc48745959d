// Which positions a closed set of triangles encloses an odd number of times.
//
// Guarantees: exact. A ray from the position is tried in one direction after the other, until it meets no edge.
#pragma once

#include <array>
#include <vector>

#include "certify/layer.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::certify {

class ClosedTriangles {
 public:
  // Each edge has to belong to an even number of triangles.
  explicit ClosedTriangles(std::vector<std::array<Point, 3>> triangles);

  // The position must be on none of the triangles. O(triangles).
  [[nodiscard]] bool encloses(const RationalPoint& x) const;

 private:
  struct Box {
    std::array<double, 3> low, high;
  };
  std::vector<std::array<Point, 3>> triangles_;
  std::vector<Box> boxes_;
};

}  // namespace flowcert::certify
