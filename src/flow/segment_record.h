// A flow step as the public interface has it: letters, names of samples, exact coordinates.
#pragma once

#include <vector>

#include "flow/flow_operator.h"
#include "flowcert/orbit.h"

namespace flowcert::flow {

// Turns the operator's own numbers into names and coordinates. Both arguments must outlive it.
class SegmentRecorder {
 public:
  SegmentRecorder(const VoronoiDiagram& diagram, FlowOperator& flow) : diagram_(diagram), flow_(flow) {}

  [[nodiscard]] FlowSegment segment(const Location& start, const FlowStep& step) const;
  // Adds all that follows a point to its orbit, whose last segment, if there is one, ends there. The operator forgets
  // the points that it constructed for that.
  void follow(Location at, Orbit& orbit) const;
  // The stationary point in a face.
  [[nodiscard]] StationaryLimit limit(const Place& place, StationaryIndex index) const;
  // Names, ascending.
  [[nodiscard]] std::vector<PointId> contact(const Place& place) const;

 private:
  [[nodiscard]] FlowSegment segment(const Location& start, RationalPoint position_of_start, const FlowStep& step) const;
  [[nodiscard]] RationalPoint position(const Driver& driver) const;

  const VoronoiDiagram& diagram_;
  FlowOperator& flow_;
};

}  // namespace flowcert::flow
