// The forest of Voronoi vertices under the flow: from each one to the next that its orbit passes through, or to
// where the orbit ends.
//
// Guarantees: exact (FlowOperator). With sharing, what follows a Voronoi vertex is flowed once, whoever asks. A
// stretch keeps what it is made of and where it leads, not its points: they, with the history that the lazy
// kernel keeps of each, would take 1 GiB for 35,000 samples. Not for two threads at once.
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
  std::optional<ForestEnd> end;      // where there is none: what it ends at; nothing for infinity
  std::size_t visits = 0;            // by orbits

  [[nodiscard]] bool is_last() const { return next == kNoCell; }
};

class SuccessorForest {
 public:
  // share: otherwise each question flows anew, as the paper did. The others must outlive it.
  SuccessorForest(const Diagram& faces, FlowOperator& flow, bool share, FlowStatistics& statistics)
      : faces_(faces), flow_(flow), share_(share), statistics_(statistics) {}

  // What follows a Voronoi vertex on an orbit, which is counted; flows if need be. The reference holds until the next
  // question.
  [[nodiscard]] const Stretch& visit(CellIndex cluster);
  // Where the orbit from a Voronoi vertex or from infinity ends; nothing for infinity. It is not counted.
  [[nodiscard]] std::optional<ForestEnd> end_from(const Place& start);

  // Adds the segments of all stretches to the statistics, as often as orbits visited them. Once.
  void count() const;
  // Forgets all stretches, and all points that were constructed.
  void drop();

 private:
  [[nodiscard]] Stretch new_stretch(CellIndex cluster);
  [[nodiscard]] Stretch& stretch_from(CellIndex cluster);
  void count_sizes();

  const Diagram& faces_;
  FlowOperator& flow_;
  bool share_;
  FlowStatistics& statistics_;
  std::vector<SegmentType> types_;
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> stretch_of_;  // by cluster
  // What count() hands over; kept apart, because stretches are made after that, too.
  Distribution exact_bytes_;
  std::size_t depth_ = 0;
};

}  // namespace flowcert::flow
