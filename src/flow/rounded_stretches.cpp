#include "flow/rounded_stretches.h"

namespace flowcert::flow {

namespace {
constexpr std::uint32_t kNotFlowed = 0xffffffffu;
}  // namespace

RoundedStretches::Stretch RoundedStretches::flowed_from(CellIndex cluster) {
  Stretch stretch{.first = points_.size()};
  Location at{Place::at_vertex(cluster), kNoPoint};
  points_.push_back(flow_.rounded(at));
  while (true) {
    const FlowStep step = flow_.step(at);
    if (step.stationary || step.end.place.kind == Place::Kind::kInfinity) break;
    if (step.end.place.kind == Place::Kind::kVertex) {
      stretch.next = step.end.place.vertex;
      break;
    }
    points_.push_back(flow_.rounded(step.end));
    at = step.end;
  }
  flow_.drop_from(0);
  stretch.count = points_.size() - stretch.first;
  return stretch;
}

void RoundedStretches::append_orbit(CellIndex cluster, std::vector<RoundedSphere>& points) {
  if (stretch_of_.empty()) stretch_of_.assign(cells_, kNotFlowed);
  for (CellIndex at = cluster; at != kNoCell;) {
    if (stretch_of_[at] == kNotFlowed) {
      stretches_.push_back(flowed_from(at));
      stretch_of_[at] = static_cast<std::uint32_t>(stretches_.size() - 1);
    }
    const Stretch& stretch = stretches_[stretch_of_[at]];
    const auto first = points_.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    points.insert(points.end(), first, first + static_cast<std::ptrdiff_t>(stretch.count));
    at = stretch.next;
  }
}

}  // namespace flowcert::flow
