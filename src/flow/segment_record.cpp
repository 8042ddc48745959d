#include "flow/segment_record.h"

#include <algorithm>

#include "flowcert/sphere.h"

namespace flowcert::flow {

std::vector<PointId> SegmentRecorder::contact(const Place& place) const {
  std::vector<PointId> names;
  for (const VertexIndex v : diagram_.contact(place)) names.push_back(diagram_.name(v));
  std::sort(names.begin(), names.end());
  return names;
}

RationalPoint SegmentRecorder::position(const Driver& driver) const {
  std::vector<PointId> names;
  names.reserve(driver.count);
  for (std::size_t k = 0; k < driver.count; ++k) names.push_back(diagram_.name(driver.samples[k]));
  std::sort(names.begin(), names.end());
  return exact_sphere(diagram_.points(), names).center;
}

FlowSegment SegmentRecorder::segment(const Location& start, const FlowStep& step) const {
  return segment(start, flow_.exact(start), step);
}

FlowSegment SegmentRecorder::segment(const Location& start, RationalPoint position_of_start,
                                     const FlowStep& step) const {
  FlowSegment segment;
  segment.type = segment_type(start.place, step);
  segment.start = std::move(position_of_start);
  segment.driver = step.stationary ? segment.start : position(step.driver);
  segment.start_contact = contact(start.place);
  segment.crossed_contact = contact(step.crossed);
  if (step.end.place.kind != Place::Kind::kInfinity) {
    segment.end = flow_.exact(step.end);
    segment.end_contact = contact(step.end.place);
  }
  return segment;
}

void SegmentRecorder::follow(Location at, Orbit& orbit) const {
  while (at.place.kind != Place::Kind::kInfinity) {
    const FlowStep step = flow_.step(at);
    if (step.stationary) {
      orbit.limit = limit(at.place, *step.stationary);
      break;
    }
    RationalPoint start = orbit.segments.empty() ? flow_.exact(at) : *orbit.segments.back().end;
    orbit.segments.push_back(segment(at, std::move(start), step));
    at = step.end;
  }
  flow_.drop_from(0);
}

StationaryLimit SegmentRecorder::limit(const Place& place, StationaryIndex index) const {
  std::vector<PointId> names = contact(place);
  return {exact_sphere(diagram_.points(), names).center, index, std::move(names)};
}

}  // namespace flowcert::flow
