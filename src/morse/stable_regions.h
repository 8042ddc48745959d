// The Voronoi facets, cut into regions by where they flow to: the sectors of all stable sets (spec clauses FC-STAB-05,
// FC-UNST-02).
//
// Guarantees: exact. The regions of a facet tile it. A region stands for the two pyramids over it with the facet's
// samples as apexes. The pyramids with one limit tile the part of its stable set that has dimension 3. Regions are
// convex. In a facet that contains its midpoint, each is a triangle with a corner there. In another one, sectors of
// FC-STAB-05 that lie side by side, and have one limit, are one region.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "flowcert/flow_limits.h"

namespace flowcert {

// A corner of a region: a place that StableRegions has a position for.
struct RegionCorner {
  enum class Kind : std::uint8_t {
    kVertex,    // a Voronoi vertex
    kDivision,  // a point that separates limits on a Voronoi edge, by its number
    kMidpoint,  // of the facet's samples
    kEnd,       // the end of an unbounded Voronoi edge
  };
  Kind kind;
  std::uint8_t end = 0;  // of a kEnd
  std::uint32_t number = 0;

  friend bool operator==(const RegionCorner&, const RegionCorner&) = default;
};

struct StableRegion {
  std::array<PointId, 2> samples;    // names, ascending
  std::optional<std::size_t> limit;  // a place in the list of stationary points; nothing for infinity
  // Counterclockwise seen from samples[1]. Corners at infinity are neighbours, one or two of them. A whole plane has no
  // corner.
  std::vector<RegionCorner> corners;
};

// Not for two threads at once.
class StableRegions {
 public:
  // Both must outlive this.
  StableRegions(const VoronoiDiagram& diagram, const FlowLimits& limits);
  ~StableRegions();
  StableRegions(StableRegions&&) noexcept;
  StableRegions& operator=(StableRegions&&) noexcept;

  // Visits all regions of all facets, facet by facet, in an order that depends on the input alone. O(1) memory beside
  // the facets.
  using Visit = std::function<void(const StableRegion& region)>;
  void visit(const Visit& visit);

  // Positions of a region's corners; of a corner at infinity, a vector that points there.
  [[nodiscard]] RationalPoint exact(const StableRegion& region, const RegionCorner& corner);
  // In the nearest doubles. Vectors are scaled so that their largest coordinate is 1 or -1.
  [[nodiscard]] Point rounded(const StableRegion& region, const RegionCorner& corner);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
