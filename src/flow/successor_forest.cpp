// A stretch ends at the first Voronoi vertex that its orbit reaches. From there on all orbits are the same.
#include "flow/successor_forest.h"

#include <algorithm>
#include <map>

#include "flow/segment_record.h"
#include "geometry/contract.h"

namespace flowcert::flow {

namespace {
constexpr std::uint32_t kNotVisited = 0xffffffffu;
}  // namespace

Stretch SuccessorForest::new_stretch(CellIndex cluster) {
  const Course course = flow_.follow(cluster);
  Stretch stretch{.count = course.count, .end = Stretch::kInfinity, .first = course.first, .last = course.last};
  if (course.stationary) {
    stretch.end = static_cast<std::uint32_t>(ends_.size());
    ends_.push_back({course.end, *course.stationary});
  } else if (course.end.kind == Place::Kind::kVertex) {
    stretch.next = course.end.vertex;
  }
  flow_.count_sizes(exact_bytes_, depth_);
  flow_.drop_from(0);
  return stretch;
}

// Flows down to a stretch that is known, or to the orbit's end, and then sums up the totals on the way back.
Stretch& SuccessorForest::stretch_from(CellIndex cluster) {
  if (stretch_of_.empty()) stretch_of_.assign(diagram_.delaunay().finite_count, kNotVisited);
  if (share_ && stretch_of_[cluster] != kNotVisited) return stretches_[stretch_of_[cluster]];
  pending_.clear();
  const Stretch* known = nullptr;
  for (CellIndex at = cluster; known == nullptr && at != kNoCell; at = stretches_.back().next) {
    if (share_ && stretch_of_[at] != kNotVisited) {
      known = &stretches_[stretch_of_[at]];
      break;
    }
    pending_.push_back(static_cast<std::uint32_t>(stretches_.size()));
    stretches_.push_back(new_stretch(at));
    stretch_of_[at] = pending_.back();
  }
  for (; !pending_.empty(); pending_.pop_back()) {
    Stretch& stretch = stretches_[pending_.back()];
    stretch.total = stretch.count + (known != nullptr ? known->total : 0);
    if (known != nullptr) stretch.end = known->end;
    known = &stretch;
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
  return end_of(stretch_from(start.vertex));
}

// A stretch is passed by the orbits that begin with it and by those that pass the stretches before it. So it is
// counted after all of these.
std::vector<std::size_t> SuccessorForest::passes() const {
  std::vector<std::size_t> passes(stretches_.size());
  std::vector<std::uint32_t> before(stretches_.size(), 0), next(stretches_.size(), kNotVisited);
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    passes[k] = stretches_[k].visits;
    if (stretches_[k].is_last()) continue;
    // Without sharing, the stretch behind is the one that was made next.
    next[k] = share_ ? stretch_of_[stretches_[k].next] : static_cast<std::uint32_t>(k + 1);
    ++before[next[k]];
  }
  for (std::uint32_t k = 0; k < stretches_.size(); ++k) {
    for (std::uint32_t at = k; at != kNotVisited && before[at] == 0; at = next[at]) {
      before[at] = kNotVisited;  // it is counted
      if (next[at] == kNotVisited) break;
      passes[next[at]] += passes[at];
      --before[next[at]];
    }
  }
  return passes;
}

void SuccessorForest::count(FlowStatistics& statistics) const {
  statistics.depth = std::max(statistics.depth, depth_);
  for (const auto& [size, times] : exact_bytes_.times()) statistics.exact_bytes.add(size, times);
  std::map<SegmentType, std::size_t> types;
  std::vector<std::size_t> runs;
  const std::vector<std::size_t> passed = passes();
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    const Stretch& stretch = stretches_[k];
    statistics.segments_computed += stretch.count;
    if (stretch.count == 0) continue;
    // The last segment ends at a constructed point if the orbit ends inside a Voronoi edge.
    const bool is_constructed = stretch.last[2] == 'E';
    const std::size_t constructed = stretch.count - (is_constructed ? 0 : 1);
    types[stretch.first] += passed[k];
    if (stretch.count > 1) types[stretch.last] += passed[k];
    if (stretch.count > 2) types[{'E', 'F', 'E'}] += std::size_t{stretch.count - 2} * passed[k];
    // After its first constructed point, a stretch makes only constructed points until it ends. So they are one run.
    if (constructed == 0) continue;
    if (runs.size() <= constructed) runs.resize(constructed + 1);
    runs[constructed] += passed[k];
  }
  for (const auto& [type, times] : types) statistics.census[type] += times;
  for (std::size_t length = 0; length < runs.size(); ++length) {
    if (runs[length] > 0) statistics.n_wcc.add(length, runs[length]);
  }
}

void SuccessorForest::drop() {
  if (share_) stretch_of_.clear();  // otherwise nobody looks a stretch up
  stretches_.clear();
  ends_.clear();
  exact_bytes_ = {};
  depth_ = 0;
  flow_.drop_all();
}

}  // namespace flowcert::flow
