// The forest of Voronoi vertices under the flow. It leads from each one to the next one that its orbit passes
// through, or to where the orbit ends.
//
// Guarantees: exact (FlowOperator). With sharing, what follows a Voronoi vertex is flowed once, whoever asks, and
// whatever the number of threads. A stretch keeps how many segments it has and where it leads, not its points. The
// points, with the history that the lazy kernel keeps of each, would take 1 GiB for 35,000 samples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flow/flow_operator.h"
#include "flowcert/progress.h"
#include "geometry/relaxed_atomics.h"

namespace flowcert::flow {

// A stationary point at which an orbit ends.
struct ForestEnd {
  Place place;
  StationaryIndex index;
};

// What is kept of a course.
struct Stretch {
  static constexpr std::uint32_t kInfinity = 0xffffffffu;
  static constexpr std::uint32_t kUnknown = 0xffffffffu;

  std::uint32_t count = 0;         // segments
  CellIndex next = kNoCell;        // the Voronoi vertex reached
  std::uint32_t end = kInfinity;   // the number of the orbit's end, or kInfinity
  std::uint32_t visits = 0;        // by orbits that begin here
  std::uint32_t total = kUnknown;  // segments from here to the orbit's end
  SegmentType first{}, last{};     // of its segments, if there are any

  [[nodiscard]] bool is_last() const { return next == kNoCell; }
};

class SuccessorForest {
 public:
  // Without `share` each question flows anew, as the paper did. The diagram must outlive it.
  SuccessorForest(const VoronoiDiagram& diagram, bool share) : diagram_(diagram), share_(share) {}

  // Flows from many Voronoi vertices, with a thread for each operator. Only with sharing. kNoCell among the starts is
  // passed over. The progress counts starts that are begun.
  void flow_from(std::span<const CellIndex> starts, std::span<FlowOperator* const> flows,
                 const Progress& progress = {});

  // The orbit from a Voronoi vertex on: its first stretch, which knows the total and the end. It flows if need be,
  // and counts the visit. The reference holds until the next question.
  [[nodiscard]] const Stretch& visit(CellIndex cluster, FlowOperator& flow);
  // Prefetches what visit_known() needs.
  void prefetch_known(CellIndex cluster) const { __builtin_prefetch(&stretches_[stretch_of_[cluster]], 1); }
  // Visits a Voronoi vertex that flow_from() has reached. Threads may do this at once.
  const Stretch& visit_known(CellIndex cluster) {
    Stretch& stretch = stretches_[stretch_of_[cluster]];
    geometry::relaxed_increment(stretch.visits);
    return stretch;
  }
  // All ends that orbits have come to. Stretches name them by their places.
  [[nodiscard]] std::span<const ForestEnd> ends() const { return ends_; }
  // The end of an orbit, by its first stretch; nothing for infinity.
  [[nodiscard]] std::optional<ForestEnd> end_of(const Stretch& first) const {
    return first.end == Stretch::kInfinity ? std::nullopt : std::optional(ends_[first.end]);
  }
  // Where the orbit from a Voronoi vertex or from infinity ends; nothing for infinity. It is not counted.
  [[nodiscard]] std::optional<ForestEnd> end_from(const Place& start, FlowOperator& flow);

  // Adds the segments of all stretches to the statistics, as often as orbits passed them.
  void count(FlowStatistics& statistics) const;
  // Forgets all stretches.
  void drop();

 private:
  class Branch;

  [[nodiscard]] Stretch& stretch_from(CellIndex cluster, FlowOperator& flow);
  void append(Branch& branch);
  void sum_up(std::size_t first);
  [[nodiscard]] std::uint32_t stretch_behind(std::size_t stretch) const;
  // How many orbits pass each stretch.
  [[nodiscard]] std::vector<std::size_t> passes() const;

  const VoronoiDiagram& diagram_;
  bool share_;
  std::vector<Stretch> stretches_;
  std::vector<ForestEnd> ends_;
  std::vector<std::uint32_t> stretch_of_;  // by cluster
  std::vector<std::uint32_t> pending_;     // stretches whose total is not known yet
  // What count() reports of all points that were constructed.
  Distribution exact_bytes_;
  std::size_t depth_ = 0;
};

}  // namespace flowcert::flow
