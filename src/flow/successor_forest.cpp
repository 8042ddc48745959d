// A stretch ends at the first Voronoi vertex that its orbit reaches. From there on all orbits are the same.
#include "flow/successor_forest.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "flow/segment_record.h"
#include "geometry/contract.h"
#include "geometry/parallel_for.h"
#include "geometry/portions.h"
#include "geometry/relaxed_atomics.h"

namespace flowcert::flow {

namespace {

constexpr std::uint32_t kNotVisited = 0xffffffffu;
// Some thread flows from there.
constexpr std::uint32_t kClaimed = 0xfffffffeu;

// What a stretch keeps of a course. The total is not known yet.
Stretch stretch_of(const Course& course, std::vector<ForestEnd>& ends) {
  Stretch stretch{.count = course.count, .first = course.first, .last = course.last};
  if (course.stationary) {
    stretch.end = static_cast<std::uint32_t>(ends.size());
    ends.push_back({course.end, *course.stationary});
  } else if (course.end.kind == Place::Kind::kVertex) {
    stretch.next = course.end.vertex;
  }
  return stretch;
}

}  // namespace

// What one thread adds to the forest. It flows from what it has reached before it takes another start, so that what it
// needs is still in the cache.
class SuccessorForest::Branch final : public CourseSource {
 public:
  Branch(FlowOperator& flow, std::span<const CellIndex> starts, geometry::Portions& portions,
         std::vector<std::uint32_t>& stretch_of)
      : flow_(flow), starts_(starts), portions_(portions), stretch_of_(stretch_of) {}

  void grow() { flow_.follow_all(*this); }

  CellIndex next() override {
    for (;;) {
      CellIndex start = kNoCell;
      if (!open_.empty()) {
        start = open_.back();
        open_.pop_back();
      } else {
        if (at_ == last_) std::tie(at_, last_) = portions_.next();
        if (at_ == last_) return kNoCell;
        start = starts_[at_++];
      }
      if (start != kNoCell && claim(start)) return start;
    }
  }

  void take(CellIndex start, const Course& course) override {
    clusters.push_back(start);
    stretches.push_back(flow::stretch_of(course, ends));
    const CellIndex next = stretches.back().next;
    if (next != kNoCell && !is_visited(next)) open_.push_back(next);
    flow_.count_sizes(exact_bytes, depth);
    flow_.drop_from(0);
  }

  std::vector<CellIndex> clusters;
  std::vector<Stretch> stretches;
  std::vector<ForestEnd> ends;
  Distribution exact_bytes;
  std::size_t depth = 0;

 private:
  // The threads exchange nothing but the claims before they end.
  [[nodiscard]] bool is_visited(CellIndex cluster) const {
    return geometry::relaxed_load(stretch_of_[cluster]) != kNotVisited;
  }
  [[nodiscard]] bool claim(CellIndex cluster) {
    return geometry::relaxed_exchange(stretch_of_[cluster], kNotVisited, kClaimed);
  }

  FlowOperator& flow_;
  std::span<const CellIndex> starts_;
  geometry::Portions& portions_;
  std::vector<std::uint32_t>& stretch_of_;
  std::size_t at_ = 0, last_ = 0;  // of the starts that are its own
  std::vector<CellIndex> open_;
};

void SuccessorForest::flow_from(std::span<const CellIndex> starts, std::span<FlowOperator* const> flows,
                                const Progress& progress) {
  FLOWCERT_REQUIRES(share_);
  if (stretch_of_.empty()) stretch_of_.assign(diagram_.delaunay().finite_count, kNotVisited);
  constexpr std::size_t kPortion = geometry::portion_size(512);
  geometry::Portions portions(starts.size(), kPortion, progress);
  std::vector<Branch> branches;
  branches.reserve(flows.size());
  for (FlowOperator* const flow : flows) branches.emplace_back(*flow, starts, portions, stretch_of_);
  geometry::parallel_for(branches.size(), static_cast<unsigned>(branches.size()),
                         [&](std::size_t k) { branches[k].grow(); });
  const std::size_t first = stretches_.size();
  for (Branch& branch : branches) append(branch);
  sum_up(first);
}

void SuccessorForest::append(Branch& branch) {
  const auto first_end = static_cast<std::uint32_t>(ends_.size());
  for (Stretch& stretch : branch.stretches) {
    if (stretch.end != Stretch::kInfinity) stretch.end += first_end;
  }
  auto number = static_cast<std::uint32_t>(stretches_.size());
  for (const CellIndex cluster : branch.clusters) stretch_of_[cluster] = number++;
  if (stretches_.empty()) {
    stretches_ = std::move(branch.stretches);
  } else {
    stretches_.insert(stretches_.end(), branch.stretches.begin(), branch.stretches.end());
  }
  ends_.insert(ends_.end(), branch.ends.begin(), branch.ends.end());
  for (const auto& [size, times] : branch.exact_bytes.times()) exact_bytes_.add(size, times);
  depth_ = std::max(depth_, branch.depth);
}

std::uint32_t SuccessorForest::stretch_behind(std::size_t stretch) const {
  if (stretches_[stretch].is_last()) return kNotVisited;
  // Without sharing, the stretch behind is the one that was made next.
  return share_ ? stretch_of_[stretches_[stretch].next] : static_cast<std::uint32_t>(stretch + 1);
}

// Goes from each stretch to one whose total is known, or to the orbit's end, and sums up on the way back.
void SuccessorForest::sum_up(std::size_t first) {
  for (std::size_t k = first; k < stretches_.size(); ++k) {
    auto at = static_cast<std::uint32_t>(k);
    for (; at != kNotVisited && stretches_[at].total == Stretch::kUnknown; at = stretch_behind(at)) {
      pending_.push_back(at);
    }
    for (; !pending_.empty(); pending_.pop_back()) {
      Stretch& stretch = stretches_[pending_.back()];
      stretch.total = stretch.count + (at != kNotVisited ? stretches_[at].total : 0);
      if (at != kNotVisited) stretch.end = stretches_[at].end;
      at = pending_.back();
    }
  }
}

// Without sharing it flows all of the orbit, stretch by stretch.
Stretch& SuccessorForest::stretch_from(CellIndex cluster, FlowOperator& flow) {
  const std::size_t first = stretches_.size();
  if (share_) {
    FlowOperator* const only = &flow;
    if (stretch_of_.empty() || stretch_of_[cluster] == kNotVisited) flow_from({&cluster, 1}, {&only, 1});
    return stretches_[stretch_of_[cluster]];
  }
  for (CellIndex at = cluster; at != kNoCell; at = stretches_.back().next) {
    stretches_.push_back(stretch_of(flow.follow(at), ends_));
    flow.count_sizes(exact_bytes_, depth_);
    flow.drop_from(0);
  }
  sum_up(first);
  return stretches_[first];
}

const Stretch& SuccessorForest::visit(CellIndex cluster, FlowOperator& flow) {
  Stretch& stretch = stretch_from(cluster, flow);
  ++stretch.visits;
  return stretch;
}

std::optional<ForestEnd> SuccessorForest::end_from(const Place& start, FlowOperator& flow) {
  if (start.kind == Place::Kind::kInfinity) return std::nullopt;
  FLOWCERT_REQUIRES(start.kind == Place::Kind::kVertex);
  return end_of(stretch_from(start.vertex, flow));
}

// A stretch is passed by the orbits that begin with it and by those that pass the stretches before it. So it is
// counted after all of these.
std::vector<std::size_t> SuccessorForest::passes() const {
  std::vector<std::size_t> passes(stretches_.size());
  std::vector<std::uint32_t> before(stretches_.size(), 0), next(stretches_.size(), kNotVisited);
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    passes[k] = stretches_[k].visits;
    next[k] = stretch_behind(k);
    if (next[k] != kNotVisited) ++before[next[k]];
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
  // Consecutive stretches often begin, and end, with segments of one type. A map is not asked again for that.
  using Types = std::map<SegmentType, std::size_t>;
  Types types;
  Types::iterator first = types.try_emplace({'E', 'F', 'E'}, 0).first, last = first;
  const auto add = [&types](Types::iterator& at, const SegmentType& type, std::size_t times) {
    if (at->first != type) at = types.try_emplace(type, 0).first;
    at->second += times;
  };
  std::vector<std::size_t> runs;
  const std::vector<std::size_t> passed = passes();
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    const Stretch& stretch = stretches_[k];
    statistics.segments_computed += stretch.count;
    if (stretch.count == 0) continue;
    // The last segment ends at a constructed point if the orbit ends inside a Voronoi edge.
    const bool is_constructed = stretch.last[2] == 'E';
    const std::size_t constructed = stretch.count - (is_constructed ? 0 : 1);
    add(first, stretch.first, passed[k]);
    if (stretch.count > 1) add(last, stretch.last, passed[k]);
    if (stretch.count > 2) types[{'E', 'F', 'E'}] += std::size_t{stretch.count - 2} * passed[k];
    // After its first constructed point, a stretch makes only constructed points until it ends. So they are one run.
    if (constructed == 0) continue;
    if (runs.size() <= constructed) runs.resize(constructed + 1);
    runs[constructed] += passed[k];
  }
  for (const auto& [type, times] : types) {
    if (times > 0) statistics.census[type] += times;
  }
  for (std::size_t length = 0; length < runs.size(); ++length) {
    if (runs[length] > 0) statistics.n_wcc.add(length, runs[length]);
  }
}

void SuccessorForest::drop() {
  stretch_of_.clear();
  stretches_.clear();
  ends_.clear();
  exact_bytes_ = {};
  depth_ = 0;
}

}  // namespace flowcert::flow
