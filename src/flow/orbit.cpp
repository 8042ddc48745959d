// See flowcert/orbit.h.
#include "flowcert/orbit.h"

#include <utility>

#include "flow/layer.h"
#include "flow/segment_record.h"

namespace flowcert {

using namespace flow;

std::string type_text(const std::array<char, 3>& type) {
  std::string text{type[0], '-', type[1], '-'};
  return type[2] == 0 ? text + "inf" : text + type[2];
}

struct Flow::Machine {
  Machine(const VoronoiDiagram& diagram, FlowOptions options)
      : points(diagram.points()),
        faces(diagram),
        machine(make_flow_machine(faces, options)),
        recorder(points, faces, *machine) {}

  Position locate(const RationalPoint& x) {
    if (points.empty()) throw InvalidInput("there are no points");
    Position position{faces.locate(x), kNoPoint};
    if (position.place.kind != Place::Kind::kVertex) position.point = machine->add(x);
    return position;
  }

  const PointSet& points;
  VoronoiFaces faces;
  std::unique_ptr<FlowMachine> machine;
  SegmentRecorder recorder;
};

Flow::Flow(const VoronoiDiagram& diagram, FlowOptions options)
    : machine_(std::make_unique<Machine>(diagram, options)) {}
Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;
Flow& Flow::operator=(Flow&&) noexcept = default;

FlowSegment Flow::step(const RationalPoint& x) {
  const Position start = machine_->locate(x);
  FlowSegment segment = machine_->recorder.segment(start, machine_->machine->step(start));
  machine_->machine->drop_from(0);
  return segment;
}

Orbit Flow::orbit(const RationalPoint& start) {
  Orbit orbit{start, {}, std::nullopt};
  Position at = machine_->locate(start);
  while (at.place.kind != Place::Kind::kInfinity) {
    const FlowStep step = machine_->machine->step(at);
    if (step.stationary) {
      orbit.limit = machine_->recorder.limit(at, *step.stationary);
      break;
    }
    orbit.segments.push_back(machine_->recorder.segment(at, step));
    at = step.end;
  }
  machine_->machine->drop_from(0);
  return orbit;
}

const KernelTally& Flow::tally() const { return machine_->machine->tally(); }

}  // namespace flowcert
