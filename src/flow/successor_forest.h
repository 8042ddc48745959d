// The forest of Voronoi vertices under the flow. It leads from each one to the next one that its orbit passes
// through, or to where the orbit ends.
//
// Guarantees: exact (FlowOperator). With sharing, what follows a Voronoi vertex is flowed once, whoever asks. A
// stretch keeps its segment types and where it leads, not its points. The points, with the history that the lazy
// kernel keeps of each, would take 1 GiB for 35,000 samples. A forest is not for two threads at once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flow/flow_operator.h"

namespace flowcert::flow {

using SegmentType = std::array<char, 3>;

// A stationary point at which an orbit ends.
struct ForestEnd {
  Place place;
  StationaryIndex index;
};

// The flow from one Voronoi vertex to the next one, or to its end.
struct Stretch {
  std::size_t first = 0, count = 0;  // of the segment types
  CellIndex next = kNoCell;          // the Voronoi vertex reached
  std::optional<ForestEnd> end;      // if there is none: the orbit's end, nothing for infinity
  std::size_t visits = 0;            // by orbits

  [[nodiscard]] bool is_last() const { return next == kNoCell; }
};

class SuccessorForest {
 public:
  // Without `share` each question flows anew, as the paper did. The diagram and the operator must outlive it.
  SuccessorForest(const Diagram& diagram, FlowOperator& flow, bool share)
      : diagram_(diagram), flow_(flow), share_(share) {}

  // What follows a Voronoi vertex on an orbit. It flows if need be, and counts the visit. The reference holds until
  // the next question.
  [[nodiscard]] const Stretch& visit(CellIndex cluster);
  // Where the orbit from a Voronoi vertex or from infinity ends; nothing for infinity. It is not counted.
  [[nodiscard]] std::optional<ForestEnd> end_from(const Place& start);

  // Adds the segments of all stretches to the statistics, as often as orbits visited them.
  void count(FlowStatistics& statistics) const;
  // Forgets all stretches, and all points that were constructed.
  void drop();

 private:
  [[nodiscard]] Stretch new_stretch(CellIndex cluster);
  [[nodiscard]] Stretch& stretch_from(CellIndex cluster);
  void count_sizes();

  const Diagram& diagram_;
  FlowOperator& flow_;
  bool share_;
  std::vector<SegmentType> types_;
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> stretch_of_;  // by cluster
  // What count() tells of all points that were constructed.
  Distribution exact_bytes_;
  std::size_t depth_ = 0;
};

}  // namespace flowcert::flow
