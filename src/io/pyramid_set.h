// Pyramids over polygons, as cells for VTK.
//
// Guarantees: a pyramid over a quadrangle is one cell. Over any other polygon it is cut into tetrahedra, from the first
// corner. Cells have VTK's orientation if the corners are given as they are asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "io/layer.h"
#include "io/vtk_exports.h"

namespace flowcert::io {

class PyramidSet {
 public:
  // Numbers of points. The corners are counterclockwise, seen from the apex. Returns how many cells that made.
  std::size_t append(std::vector<std::int64_t> corners, std::int64_t apex) {
    if (corners.size() == 4) {
      corners.push_back(apex);
      append_cell(corners, UnstructuredGrid::Shape::kPyramid);
      return 1;
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      append_cell({corners[0], corners[i], corners[i + 1], apex}, UnstructuredGrid::Shape::kTetrahedron);
    }
    return corners.size() < 3 ? 0 : corners.size() - 2;
  }

  [[nodiscard]] UnstructuredGrid take() { return std::move(grid_); }

 private:
  void append_cell(const std::vector<std::int64_t>& points, UnstructuredGrid::Shape shape) {
    auto& connectivity = grid_.cells.connectivity;
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    grid_.cells.offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    grid_.shapes.push_back(shape);
  }

  UnstructuredGrid grid_;
};

}  // namespace flowcert::io
