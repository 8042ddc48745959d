// The corners of regions of Voronoi facets as numbered points of a file, and pyramids over them as cells for VTK.
//
// Guarantees: two corners have one number iff their exact positions are equal. Their names say which of them
// are equal, with one exception: the midpoint of a facet may lie on the facet's boundary. It is a regular stationary
// point then, and a corner of other facets by another name.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "flowcert/flow_complex.h"
#include "io/layer.h"
#include "io/vtk_exports.h"
#include "morse/stable_regions.h"

namespace flowcert::io {

class CornerNumbers {
 public:
  // Both must outlive it.
  CornerNumbers(const FlowComplex& complex, StableRegions& regions);

  // The regions of a facet must come one after the other.
  [[nodiscard]] std::int64_t of(const StableRegion& region, const RegionCorner& corner);
  [[nodiscard]] std::int64_t of_sample(PointId name);
  // Where a box cuts. One for equal doubles, apart from the corners.
  [[nodiscard]] std::int64_t of_cut(const Point& position);
  // A coordinate that would overflow is an infinity.
  [[nodiscard]] const Point& position(std::int64_t number) const { return points_[static_cast<std::size_t>(number)]; }
  // Throws BeyondDoubles for a coordinate that would overflow.
  [[nodiscard]] std::vector<Point> take_points();

 private:
  using Coordinates = std::array<double, 3>;
  static constexpr std::int64_t kNone = -1;
  struct Regular {
    std::size_t record;
    std::int64_t number;
  };

  [[nodiscard]] std::int64_t& known(const StableRegion& region, const RegionCorner& corner);
  [[nodiscard]] std::int64_t number_of_new(const StableRegion& region, const RegionCorner& corner);
  [[nodiscard]] std::int64_t append(const Point& position);

  const FlowComplex& complex_;
  StableRegions& regions_;
  std::vector<Point> points_;
  std::unordered_map<PointId, std::int64_t> samples_;
  std::unordered_map<std::uint32_t, std::int64_t> vertices_, divisions_;
  std::array<PointId, 2> samples_of_midpoint_{};
  std::int64_t midpoint_ = kNone;
  std::multimap<Coordinates, Regular> regular_;
  std::map<Coordinates, std::int64_t> cuts_;
};

// A pyramid over a quadrangle is one cell. Over any other polygon it is cut into tetrahedra, from the first corner.
// Cells have VTK's orientation if the corners are given as they are asked for.
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
