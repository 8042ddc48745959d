// Walks with the flow over Voronoi edges and facets: what belongs to an unstable set of dimension 2, part by part (spec
// clauses FC-UNST-04, 05).
//
// Guarantees: exact. The rays of a part leave a facet between those of its two ends, whose exits the flow operator
// finds with its filtered signs. What has come to a face is put together before it is listed, so that no part counts
// twice. No exact position is computed but to compare points with equal nearest doubles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "morse/facet_sides.h"
#include "morse/trace_set.h"

namespace flowcert::morse {

// A corner of a sheet, or an end of a segment.
struct SurfaceEnd {
  enum class Kind : std::uint8_t {
    kPoint,    // `at`
    kAlong,    // at infinity, at the end `along` of a Voronoi edge
    kThrough,  // at infinity, on the ray from the midpoint of `facet` through `at`
  };
  Kind kind = Kind::kPoint;
  Location at;
  FacetName facet{0, 0};
  EdgeEnd along{{kNoCell, 0}, 0};
};

// Corners in cyclic order; two neighbours may be at one place. There are none if P does not span space.
struct SheetParts {
  FacetName facet;
  std::vector<SurfaceEnd> corners;
};
struct SegmentParts {
  FacetName facet;
  Location start;
  SurfaceEnd end;
};
struct EdgeParts {
  PolygonRef polygon;
  std::vector<TracePart> traces, runs;
};
struct SurfaceParts {
  std::vector<CellIndex> vertices;
  std::vector<EdgeParts> edges;
  std::vector<SheetParts> sheets;
  std::vector<SegmentParts> segments;
};

class ForwardWalk {
 public:
  // Both must outlive it.
  ForwardWalk(VoronoiFaces& faces, FlowOperator& flow)
      : faces_(faces), diagram_(faces.diagram()), flow_(flow), order_(diagram_, flow) {}

  // All that flows from the closed facet, whose midpoint is stationary. Its points stay until the next walk.
  [[nodiscard]] SurfaceParts walk(FacetName root, CellIndex hint);

 private:
  struct Edge {
    PolygonRef polygon;
    TraceSet arrived;
    std::array<bool, 2> runs_to{}, runs_whole_to{};  // by end: from a trace, from the other end
  };
  struct Facet {
    std::vector<RingPiece> pieces;  // of its sides' ring
    FacetSides sides;
  };
  // Where a ray leaves a facet: at element k of the ring, which is place 2 k, or inside piece k, at place 2 k + 1.
  struct Exit {
    std::size_t place;
    SurfaceEnd end;
  };
  struct Task {
    CellIndex vertex;  // kNoCell for a part
    PolygonRef polygon;
    TracePart part;
  };
  // On the near side of a facet, against the ring's order, so that the exits follow it.
  struct NearPart {
    std::size_t first_piece, last_piece;  // of the chain
    TraceEnd first, last;
  };

  void clear();
  void add_vertex(CellIndex cluster);
  void add_part(PolygonRef polygon, const TracePart& part);
  void add_root(const FacetSides& root);
  void follow_vertex(CellIndex cluster);
  void follow_part(PolygonRef polygon, const TracePart& part);
  void run(PolygonRef polygon, const TracePart& part);
  void sweep(const FacetSides& facet, const Exit& first, const Exit& last);

  [[nodiscard]] const FacetSides& facet(FacetName name, CellIndex hint);
  [[nodiscard]] Edge& edge(PolygonRef polygon);
  [[nodiscard]] const FlowStep& step_of(CellIndex cluster);
  [[nodiscard]] const FlowStep& step_of(const Location& point);
  [[nodiscard]] std::optional<int> centre_beyond(PolygonRef polygon) const;
  [[nodiscard]] int side_of(PolygonRef polygon, const TraceEnd& end);
  [[nodiscard]] Exit exit_of(const FacetSides& facet, const Location& from, const FlowStep& step);
  [[nodiscard]] Exit exit_of_end(const FacetSides& facet, std::size_t piece, const TraceEnd& end);
  [[nodiscard]] bool enters(const FacetSides& facet, CellIndex cluster);

  [[nodiscard]] EdgeParts parts_of(const Edge& edge);
  void add_runs(const Edge& edge, std::size_t end, std::vector<TracePart>& runs);
  void list_facet(const FacetSides& facet, SurfaceParts& parts);
  [[nodiscard]] std::vector<NearPart> near_parts(const FacetSides& facet, SurfaceParts& parts);
  void list_near_part(const FacetSides& facet, const NearPart& part, SurfaceParts& parts);
  [[nodiscard]] static SurfaceEnd element(const FacetSides& facet, std::size_t k);
  [[nodiscard]] static SurfaceEnd near_corner(const FacetSides& facet, std::size_t piece, const TraceEnd& end);

  VoronoiFaces& faces_;
  const VoronoiDiagram& diagram_;
  FlowOperator& flow_;
  TraceOrder order_;
  std::vector<Task> tasks_;
  std::unordered_map<CellIndex, std::optional<FlowStep>> vertices_;  // a step once it was asked for
  std::unordered_map<std::uint32_t, Edge> edges_;                    // by packed polygon
  std::unordered_map<RingNumber, Facet> facets_;
  std::unordered_map<PointNumber, FlowStep> steps_;
};

}  // namespace flowcert::morse
