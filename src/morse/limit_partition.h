// How Voronoi edges, and the rays of Voronoi facets, divide by where they flow to (spec clauses FC-UNST-02 and
// FC-STAB-03).
//
// Guarantees: exact. Each Voronoi edge, and each fan of rays from the midpoint of a Delaunay edge, is a list of open
// arcs with a limit each, and of the points between them. A point between two arcs of its own limit is left out. A
// facet is divided once, after all faces that its rays come to, and hands its arcs back to the edges that it is
// entered through. So the time is in proportion to the faces and to the points that separate limits, and no orbit is
// followed.
//
// A way from one face to the next never returns. The ball around the driver, through its samples, becomes larger each
// time, because it is the smallest one around the contact set of the place that was left.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "flowcert/flow_limits.h"
#include "morse/backward_walk.h"
#include "morse/facet_sides.h"
#include "morse/record_finder.h"

namespace flowcert::morse {

// A record of the list of stationary points, or infinity.
using Limit = std::uint32_t;
inline constexpr Limit kInfinityLimit = 0xffffffffu;
using PointOfDivision = std::uint32_t;
inline constexpr PointOfDivision kNoDivision = 0xffffffffu;

// An arc, or a point between two of them.
struct Division {
  Limit limit;
  PointOfDivision point = kNoDivision;

  [[nodiscard]] bool is_arc() const { return point == kNoDivision; }
};

// How a point of a division was made, which gives its place exactly (division_positions.h).
struct DivisionPoint {
  enum class Kind : std::uint32_t {
    kVertex,    // the Voronoi vertex `from`
    kCenter,    // the centre of a polygon, on its Voronoi edge, whose packed name is `from`
    kCrossing,  // where the ray to the point `from` enters its facet
    kEnd,       // the end 0 or 1 of a Voronoi edge at infinity: `from` is the edge, `apex` the end
  };
  Kind kind;
  std::uint32_t from;
  // Of a crossing: the facet, an apex of the polygon through whose Voronoi edge the ray enters, and one of the polygon
  // on whose Voronoi edge the point `from` lies. If `from` is a Voronoi vertex, its other polygon in the facet has
  // the apex `other`.
  FacetName facet{0, 0};
  VertexIndex apex = 0, far_apex = 0, other = 0;

  // A crossing has three samples of the polygon through whose Voronoi edge the ray enters.
  [[nodiscard]] std::array<VertexIndex, 3> samples() const { return {facet.v0, facet.v1, apex}; }
};

class LimitPartition {
 public:
  // The diagram and the list must outlive it. It divides everything at once. The progress is now and then how many
  // Voronoi edges are divided, of the total given.
  LimitPartition(const VoronoiDiagram& diagram, const StationaryPoints& stationary, const FlowOptions& options,
                 const Progress& progress, std::size_t total);

  // What these limits were read off.
  [[nodiscard]] static const LimitPartition& of(const FlowLimits& limits);

  // Dimension 3 only.
  [[nodiscard]] Limit limit_of_vertex(CellIndex cluster) const { return of_vertex_[cluster]; }
  // From end 0 to end 1. Arcs and points take turns; both ends are arcs. Dimension 2 and 3.
  [[nodiscard]] std::span<const Division> edge(PolygonRef polygon) const {
    const std::size_t header = of_edge_[polygon.packed()];
    return std::span(divisions_).subspan(header + 1, divisions_[header].limit);
  }
  [[nodiscard]] const DivisionPoint& point(PointOfDivision number) const { return points_[number]; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }

  // The Voronoi vertex is on the near side of the facet of its driver. If a ray to a point of the facet's division goes
  // through it, this is that point; otherwise nothing.
  [[nodiscard]] std::optional<PointOfDivision> point_behind(CellIndex cluster) const {
    const auto found = behind_vertex_.find(cluster);
    return found == behind_vertex_.end() ? std::nullopt : std::optional(found->second);
  }

  // The directions of a record with a face of dimension 1 or 2 (FC-UNST-01), counterclockwise seen from the sample
  // with the greater VertexIndex. For a critical point of index 1 they go around: after the last one, which is an arc,
  // comes the first one again, which is a point unless the arc is the whole circle. Other lists begin and end with a
  // point. For face dimension 2 there are the one or two points alone, side 0 first.
  void directions(std::size_t record, std::vector<Division>& list);

 private:
  struct FanEntry {
    Limit limit;
    PointOfDivision point;  // kNoDivision for an arc
    std::uint32_t piece;    // of a point: its place in the ring, or that of the element
  };
  static constexpr PointOfDivision kAtElement = 0xfffffffeu;
  static constexpr Limit kUnset = 0xfffffffeu;
  static constexpr std::uint32_t kNotDivided = 0xffffffffu;
  struct Task {
    bool is_vertex;
    FacetName facet;
    CellIndex cell;  // the Voronoi vertex, or a hint for the facet
    bool is_second_try = false;
  };

  void note_records();
  void divide_all_edges(const Progress& progress, std::size_t total);
  void finish_tasks(const Progress& progress, std::size_t total);
  bool finish_vertex(const Task& task);
  bool finish_facet(FacetName facet, CellIndex hint);
  bool is_ready(const FacetSides& sides);
  bool request_edge(PolygonRef polygon);
  bool request_vertex(CellIndex cluster);
  bool divide_along(PolygonRef polygon);
  void divide_near_side(const FacetSides& sides);
  // The divisions of slice_.
  void store(PolygonRef polygon, bool is_reversed);

  void make_fan(const FacetSides& sides);
  void append_edge(const FacetSides& sides, std::uint32_t piece);
  void append_element(const FacetSides& sides, std::uint32_t piece);
  void append_arc(Limit limit);
  void close_fan(const FacetSides& sides);
  [[nodiscard]] PointOfDivision point_of(const FacetSides& sides, const FanEntry& entry);
  [[nodiscard]] FrontNumber front_of(const FacetSides& sides, const FanEntry& entry);
  [[nodiscard]] PointOfDivision point_at_vertex(CellIndex cluster);
  void directions_of_face_2(std::size_t record, std::vector<Division>& list);
  [[nodiscard]] Limit limit_at_end(PolygonRef polygon, std::size_t end) const;
  [[nodiscard]] Division direction_to_end(PolygonRef polygon, std::size_t end);
  PointOfDivision add(const DivisionPoint& point) {
    points_.push_back(point);
    return static_cast<PointOfDivision>(points_.size() - 1);
  }

  const StationaryPoints& stationary_;
  GabrielEdges gabriel_;
  const VoronoiDiagram& diagram_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  BackwardWalk walk_;

  std::vector<Limit> of_vertex_;        // by cluster
  std::vector<std::uint32_t> of_edge_;  // by packed polygon: where its header is in divisions_
  std::vector<Division> divisions_;     // a header, whose limit is their number, and then those of an edge
  std::vector<DivisionPoint> points_;
  std::vector<FrontNumber> fronts_;               // by point, until all edges are divided
  std::vector<std::uint32_t> record_of_edge_;     // of the stationary point inside, by packed polygon
  std::vector<PointOfDivision> point_of_vertex_;  // by cluster, where one was needed
  std::unordered_map<CellIndex, PointOfDivision> behind_vertex_;
  // Of the task at hand.
  std::vector<Task> tasks_;
  std::vector<FanEntry> fan_;
  std::vector<Division> slice_;
  std::size_t divided_ = 0, told_ = 0;  // edges
};

}  // namespace flowcert::morse
