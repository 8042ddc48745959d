// A flow step as the public interface tells it: letters, names of samples, exact coordinates.
#pragma once

#include <vector>

#include "flow/flow_machine.h"
#include "flowcert/orbit.h"

namespace flowcert::flow {

// What turns the machine's own numbers into names and coordinates. All three must outlive it.
class SegmentRecorder {
 public:
  SegmentRecorder(const PointSet& points, const VoronoiFaces& faces, FlowMachine& machine)
      : points_(points), faces_(faces), machine_(machine) {}

  [[nodiscard]] FlowSegment segment(const Position& start, const FlowStep& step) const;
  [[nodiscard]] StationaryLimit limit(const Position& at, StationaryIndex index) const;
  // Names, ascending.
  [[nodiscard]] std::vector<PointId> contact(const Place& place) const;

 private:
  [[nodiscard]] RationalPoint position(const Driver& driver) const;
  [[nodiscard]] PointId name(VertexIndex v) const { return points_.name(faces_.delaunay().positions[v]); }

  const PointSet& points_;
  const VoronoiFaces& faces_;
  FlowMachine& machine_;
};

// The letters of Table 1.
[[nodiscard]] char letter(Place::Kind kind);
[[nodiscard]] inline std::array<char, 3> segment_type(const Place& start, const FlowStep& step) {
  return {letter(start.kind), letter(step.crossed.kind), letter(step.end.place.kind)};
}

}  // namespace flowcert::flow
