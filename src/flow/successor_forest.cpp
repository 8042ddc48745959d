// A stretch ends at the first Voronoi vertex that its orbit reaches. From there on all orbits are the same.
#include "flow/successor_forest.h"

#include <algorithm>

#include "flow/segment_record.h"
#include "geometry/contract.h"

namespace flowcert::flow {

namespace {
constexpr std::uint32_t kNotVisited = 0xffffffffu;
}  // namespace

Stretch SuccessorForest::new_stretch(CellIndex cluster) {
  Stretch stretch;
  stretch.first = types_.size();
  Location at{Place::at_vertex(cluster), kNoPoint};
  do {
    const FlowStep step = flow_.step(at);
    if (step.stationary) {
      stretch.end = {at.place, *step.stationary};
      break;
    }
    types_.push_back(segment_type(at.place, step));
    at = step.end;
    if (at.place.kind == Place::Kind::kVertex) stretch.next = at.place.vertex;
  } while (at.place.kind == Place::Kind::kEdge);
  stretch.count = types_.size() - stretch.first;
  count_sizes();
  flow_.drop_from(0);
  return stretch;
}

Stretch& SuccessorForest::stretch_from(CellIndex cluster) {
  if (stretch_of_.empty()) stretch_of_.assign(diagram_.delaunay().finite_count, kNotVisited);
  if (!share_ || stretch_of_[cluster] == kNotVisited) {
    stretches_.push_back(new_stretch(cluster));
    stretch_of_[cluster] = static_cast<std::uint32_t>(stretches_.size() - 1);
  }
  return stretches_[stretch_of_[cluster]];
}

const Stretch& SuccessorForest::visit(CellIndex cluster) {
  Stretch& stretch = stretch_from(cluster);
  ++stretch.visits;
  return stretch;
}

std::optional<ForestEnd> SuccessorForest::end_from(const Place& start) {
  if (start.kind == Place::Kind::kInfinity) return std::nullopt;
  FLOWCERT_REQUIRES(start.kind == Place::Kind::kVertex);
  const Stretch* stretch = &stretch_from(start.vertex);
  while (!stretch->is_last()) stretch = &stretch_from(stretch->next);
  return stretch->end;
}

void SuccessorForest::count_sizes() {
  for (PointNumber point = 0; point < flow_.kept(); ++point) {
    depth_ = std::max(depth_, flow_.depth(point));
    if (const auto bytes = flow_.exact_bytes(point)) {
      for (const std::size_t size : *bytes) exact_bytes_.add(size);
    }
  }
}

void SuccessorForest::count(FlowStatistics& statistics) const {
  statistics.depth = std::max(statistics.depth, depth_);
  for (const auto& [size, times] : exact_bytes_.times()) statistics.exact_bytes.add(size, times);
  for (const Stretch& stretch : stretches_) {
    statistics.segments_computed += stretch.count;
    std::size_t constructed = 0;
    for (std::size_t k = stretch.first; k < stretch.first + stretch.count; ++k) {
      statistics.census[types_[k]] += stretch.visits;
      constructed += types_[k][2] == 'E' ? 1 : 0;
    }
    // After its first constructed point, a stretch makes only constructed points until it ends. So they are one run.
    if (constructed > 0) statistics.n_wcc.add(constructed, stretch.visits);
  }
}

void SuccessorForest::drop() {
  if (share_) stretch_of_.clear();  // otherwise nobody looks a stretch up
  stretches_.clear();
  types_.clear();
  exact_bytes_ = {};
  depth_ = 0;
  flow_.drop_all();
}

}  // namespace flowcert::flow
