// Makes one skeleton at a time, against the flow: of a stationary point, or of infinity (spec clauses FC-STAB-03 to 05,
// 08).
//
// Guarantees: exact, on every input. A walk counts segments, and constructs only the points that its signs need. The
// geometry of a skeleton, exact or in doubles, is made when it is asked for. It is not for two threads at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_set>
#include <vector>

#include "flow/drivers.h"
#include "flow/flow_operator.h"
#include "flow/segment_record.h"
#include "flowcert/stable_manifolds.h"
#include "morse/backward_walk.h"
#include "morse/chain_boundary.h"
#include "morse/layer.h"
#include "morse/record_finder.h"
#include "morse/stable_sector.h"
#include "morse/unbounded_faces.h"

namespace flowcert::morse {

// What all walks over one diagram share. All that it refers to must outlive them.
struct SkeletonSource {
  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  const GabrielEdges& gabriel;
};

struct SkeletonSize {
  std::uint32_t segments = 0;
  bool has_vertex = false, has_interval = false;
};

class SkeletonWalk {
 public:
  SkeletonWalk(const SkeletonSource& source, const FlowOptions& options)
      : source_(source),
        faces_(source.diagram),
        flow_(make_flow_operator(faces_, options)),
        recorder_(source.diagram, *flow_),
        walk_(faces_, *flow_, source.gabriel) {}

  // Walks the segments of a record's skeleton that lie before its intervals.
  const SkeletonSize& walk(std::size_t record);
  [[nodiscard]] StableSet<> set(std::size_t record);
  [[nodiscard]] StableSet<> set_of_infinity();
  [[nodiscard]] RoundedSegments rounded_segments(std::size_t record);
  // The segments that the boundary is read from where ties are broken.
  [[nodiscard]] RoundedSegments tie_broken_segments(std::size_t record, TieBreaking& ties);

  // Of the latest walk: its critical backs and the lengths of the orbits to them, and how many backs are regular.
  [[nodiscard]] std::vector<std::uint32_t>& ends() { return ends_; }
  [[nodiscard]] const std::vector<std::uint32_t>& lengths() const { return lengths_; }
  [[nodiscard]] std::size_t regular_backs() const { return regular_backs_; }
  // The boundary of a record's set where ties are broken.
  [[nodiscard]] std::vector<std::uint32_t> tie_broken_ends(std::size_t record, TieBreaking& ties);

  [[nodiscard]] const KernelTally& tally() const { return flow_->tally(); }
  [[nodiscard]] std::size_t depth() const;

 private:
  using Task = BackwardWalk::Task;
  // A polygon that leads to the Voronoi vertex, or to infinity, at an end of its Voronoi edge.
  struct Source {
    CellIndex cluster;  // kNoCell: infinity
    EdgeEnd at;
  };

  void clear();
  FrontNumber start(std::size_t record);
  void begin(std::size_t record);
  [[nodiscard]] bool ends_at_sides(std::size_t record);
  void push_sources(FrontNumber front);
  void push_sides(FrontNumber front, PolygonRef polygon);
  void push_vertex(CellIndex cluster, FrontNumber front);
  void follow();
  [[nodiscard]] FrontNumber front_of(const Source& source);

  [[nodiscard]] std::vector<BackwardWalk::Step> tie_broken_steps(std::size_t record, TieBreaking& ties);
  [[nodiscard]] RoundedSegments rounded_trace();
  void sort_by_exact_fronts(RoundedSegments& rounded);
  void record_segment(const Task& task, const BackwardWalk::Back& back);
  void record_intervals();
  void record_unbounded_facet(const UnboundedFacet& facet);
  void record_sectors(const Arc& arc);
  // Adds the arcs through which the sector's rays enter its facet.
  void record_sector(FacetName facet, const SectorParts& parts, std::vector<Arc>& arcs);
  // What is left to record of the set, and then all of it, sorted.
  [[nodiscard]] StableSet<> recorded();
  [[nodiscard]] Corner<> corner(FrontNumber front) {
    if (walk_.is_at_infinity(front)) return {walk_.direction(front), true};
    return {flow_->exact(walk_.location(front))};
  }
  [[nodiscard]] std::array<PointId, 2> names(FacetName facet) const { return source_.diagram.names(facet); }

  SkeletonSource source_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  SegmentRecorder recorder_;
  BackwardWalk walk_;
  // Of one skeleton.
  SkeletonSize size_;
  std::vector<Task> tasks_;
  std::unordered_set<CellIndex> visited_;  // Voronoi vertices
  std::vector<std::uint32_t> ends_;
  std::vector<std::uint32_t> lengths_;
  std::size_t regular_backs_ = 0;
  std::vector<Source> sources_of_intervals_;
  bool is_recorded_ = false, is_traced_ = false;
  StableSet<> found_;                      // if it is recorded
  std::vector<BackwardWalk::Step> trace_;  // all segments, if it is traced
};

}  // namespace flowcert::morse
