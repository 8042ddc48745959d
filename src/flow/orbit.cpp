#include "flowcert/orbit.h"

#include "flow/layer.h"
#include "flow/segment_record.h"
#include "flow/successor_forest.h"
#include "geometry/floating_point.h"

namespace flowcert {

using namespace flow;

std::string type_text(const std::array<char, 3>& type) {
  std::string text{type[0], '-', type[1], '-'};
  return type[2] == 0 ? text + "inf" : text + type[2];
}

struct Flow::Parts {
  Parts(const VoronoiDiagram& diagram, FlowOptions options)
      : faces(diagram), flow(make_flow_operator(faces, options)), recorder(diagram, *flow), forest(diagram, true) {}

  Location locate(const RationalPoint& x) {
    if (faces.diagram().points().empty()) throw InvalidInput("there are no points");
    Location at{faces.locate(x), kNoPoint};
    if (at.place.kind != Place::Kind::kVertex) at.point = flow->add(x);
    return at;
  }

  VoronoiFaces faces;
  std::unique_ptr<FlowOperator> flow;
  SegmentRecorder recorder;
  SuccessorForest forest;
};

Flow::Flow(const VoronoiDiagram& diagram, FlowOptions options)
    : parts_(geometry::in_ieee_doubles([&] { return std::make_unique<Parts>(diagram, options); })) {}
Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;
Flow& Flow::operator=(Flow&&) noexcept = default;

FlowSegment Flow::step(const RationalPoint& x) {
  const geometry::IeeeDoubles ieee;
  const Location start = parts_->locate(x);
  FlowSegment segment = parts_->recorder.segment(start, parts_->flow->step(start));
  parts_->flow->drop_from(0);
  return segment;
}

Orbit Flow::orbit(const RationalPoint& start) {
  const geometry::IeeeDoubles ieee;
  Orbit orbit{start, {}, std::nullopt};
  parts_->recorder.follow(parts_->locate(start), orbit);
  return orbit;
}

std::optional<StationaryLimit> Flow::limit(const RationalPoint& start) {
  const geometry::IeeeDoubles ieee;
  Location at = parts_->locate(start);
  std::optional<StationaryIndex> index;
  while (!index && at.place.kind != Place::Kind::kVertex && at.place.kind != Place::Kind::kInfinity) {
    const FlowStep step = parts_->flow->step(at);
    index = step.stationary;
    at = step.end;
  }
  parts_->flow->drop_from(0);
  if (index) return parts_->recorder.limit(at.place, *index);
  const std::optional<ForestEnd> end = parts_->forest.end_from(at.place, *parts_->flow);
  if (!end) return std::nullopt;
  return parts_->recorder.limit(end->place, end->index);
}

const KernelTally& Flow::tally() const { return parts_->flow->tally(); }

}  // namespace flowcert
