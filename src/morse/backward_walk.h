// Walks against the flow over Voronoi facets, from front to front. The skeleton of a stable set and its boundary in
// the chain complex are both made of such walks.
//
// Guarantees: exact (FlowOperator). A front's point is constructed when the first facet asks where its ray ends; most
// facets do not ask (FlowOperator::one_back).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flow/flow_operator.h"
#include "morse/record_finder.h"

namespace flowcert::morse {

using FrontNumber = std::uint32_t;

class BackwardWalk {
 public:
  // All three must outlive it.
  BackwardWalk(VoronoiFaces& faces, FlowOperator& flow, const GabrielEdges& gabriel)
      : faces_(faces), flow_(flow), gabriel_(gabriel) {}

  // Fronts, which stay until clear().
  [[nodiscard]] FrontNumber at_vertex(CellIndex cluster);
  // An end at infinity. The hint is a cell that may have the Delaunay edges of the facets that it is asked for.
  [[nodiscard]] FrontNumber at_infinity(const RationalPoint& direction, CellIndex hint);
  // The centre of the circle through three samples of a polygon, which lies inside its Voronoi edge.
  [[nodiscard]] FrontNumber at_center(const std::array<VertexIndex, 3>& samples, PolygonRef edge);
  void clear();

  // Steps back from a front that the facet leads to. A back that is no critical point becomes a front itself.
  struct Back {
    std::optional<std::uint32_t> critical;  // a record
    bool is_regular = false;                // it is the facet's midpoint, on the facet's boundary
    FrontNumber front = 0;                  // if it is not critical
  };
  [[nodiscard]] Back step(FrontNumber front, FacetName facet);
  // A step that is to be made, and one that was.
  struct Task {
    FrontNumber front;
    FacetName facet;
  };
  struct Step {
    Task task;
    Back back;
  };

  [[nodiscard]] const Place& place(FrontNumber front) const { return fronts_[front].place; }
  [[nodiscard]] bool is_at_infinity(FrontNumber front) const {
    return fronts_[front].place.kind == Place::Kind::kInfinity;
  }
  // Of a front at infinity.
  [[nodiscard]] const RationalPoint& direction(FrontNumber front) const {
    return directions_[fronts_[front].direction];
  }
  // How many segments lie between it and the front that the walk began with.
  [[nodiscard]] std::uint32_t depth(FrontNumber front) const { return fronts_[front].depth; }
  // Not of a front at infinity.
  [[nodiscard]] Location location(FrontNumber front);

 private:
  static constexpr FrontNumber kNone = 0xffffffffu;
  struct Front {
    Place place;
    PointNumber point = kNoPoint;
    std::uint32_t depth = 0;
    // The point is constructed from these. It is the centre of a circle, or the crossing behind another front.
    std::array<VertexIndex, 3> samples{};
    FrontNumber before = kNone;
    FacetName facet{0, 0};
    VertexIndex apex = kInfiniteVertex;
    std::size_t direction = 0;  // of a front at infinity
  };

  [[nodiscard]] bool is_constructed(const Front& front) const {
    return front.point != kNoPoint || front.place.kind == Place::Kind::kVertex;
  }
  FrontNumber add(const Front& front);
  // A point on the ray from the facet's midpoint to a front at infinity.
  FrontNumber on_ray(FrontNumber front, FacetName facet);

  VoronoiFaces& faces_;
  FlowOperator& flow_;
  const GabrielEdges& gabriel_;
  std::vector<Front> fronts_;
  std::vector<RationalPoint> directions_;
  std::vector<FrontNumber> pending_;
};

}  // namespace flowcert::morse
