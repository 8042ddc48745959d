#include "flow/rounded_stretches.h"

namespace flowcert::flow {

namespace {
constexpr std::uint32_t kNotFlowed = 0xffffffffu;
}  // namespace

RoundedStretches::PointRange RoundedStretches::flowed_from(CellIndex cluster) {
  PointRange stretch{.first = points_.size()};
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

const RoundedStretches::PointRange& RoundedStretches::stretch_from(CellIndex cluster) {
  if (stretch_of_.empty()) stretch_of_.assign(cells_, kNotFlowed);
  if (stretch_of_[cluster] == kNotFlowed) {
    stretches_.push_back(flowed_from(cluster));
    stretch_of_[cluster] = static_cast<std::uint32_t>(stretches_.size() - 1);
  }
  return stretches_[stretch_of_[cluster]];
}

void RoundedStretches::append_orbit(CellIndex cluster, std::vector<RoundedSphere>& points) {
  for (CellIndex at = cluster; at != kNoCell;) {
    const PointRange& stretch = stretch_from(at);
    const auto first = points_.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    points.insert(points.end(), first, first + static_cast<std::ptrdiff_t>(stretch.count));
    at = stretch.next;
  }
}

CellIndex RoundedStretches::last_vertex(CellIndex cluster) {
  CellIndex last = cluster;
  for (CellIndex at = cluster; at != kNoCell; at = stretch_from(at).next) last = at;
  return last;
}

}  // namespace flowcert::flow
