// The stretches of the flow, as points in doubles.
//
// Guarantees: each coordinate and each squared distance is the double nearest to the exact one (FlowOperator). What
// follows a Voronoi vertex is flowed once, whoever asks. Not for two threads at once.
#pragma once

#include <cstdint>
#include <vector>

#include "flow/flow_operator.h"

namespace flowcert::flow {

class RoundedStretches {
 public:
  // The operator must outlive it. cells: how many finite cells the triangulation has.
  RoundedStretches(FlowOperator& flow, std::size_t cells) : flow_(flow), cells_(cells) {}

  // Adds the orbit from a Voronoi vertex on: that vertex, and the end of each segment, but not infinity. The operator
  // forgets the points that it constructed.
  void append_orbit(CellIndex cluster, std::vector<RoundedSphere>& points);
  // The last Voronoi vertex that the orbit from a Voronoi vertex passes through or ends at.
  [[nodiscard]] CellIndex last_vertex(CellIndex cluster);

 private:
  struct PointRange {
    std::size_t first = 0, count = 0;  // of points_; the Voronoi vertex that it leads to is not among them
    CellIndex next = kNoCell;
  };
  [[nodiscard]] PointRange flowed_from(CellIndex cluster);
  // The reference holds until the next call.
  [[nodiscard]] const PointRange& stretch_from(CellIndex cluster);

  FlowOperator& flow_;
  std::size_t cells_;
  std::vector<RoundedSphere> points_;
  std::vector<PointRange> stretches_;
  std::vector<std::uint32_t> stretch_of_;  // by cluster
};

}  // namespace flowcert::flow
