// The corners of regions of Voronoi facets as numbered points of a file.
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

}  // namespace flowcert::io
