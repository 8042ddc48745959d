// Stable sets are walked against the flow, from front to front (BackwardWalk); their geometry is made once more when
// it is asked for.
#include "flowcert/stable_manifolds.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "flow/drivers.h"
#include "flow/flow_operator.h"
#include "flow/segment_record.h"
#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "geometry/portions.h"
#include "morse/backward_walk.h"
#include "morse/chain_boundary.h"
#include "morse/layer.h"
#include "morse/record_face.h"
#include "morse/record_finder.h"
#include "morse/stable_sector.h"

namespace flowcert {

using namespace morse;

// ---- All sets ----

namespace {

constexpr std::size_t kProgressStep = geometry::portion_size(1024);
// So many sets are begun before the memory for one is there.
constexpr std::size_t kAhead = 12;

}  // namespace

struct StableManifolds::Parts {
  struct Set {
    std::uint32_t record = 0;
    std::uint32_t segments = 0;
    bool has_vertex = false, has_interval = false;
    std::uint32_t share = 0;  // where its boundary is
    std::size_t boundary_first = 0, boundary_count = 0;
  };
  class Worker;
  // What one thread finds.
  struct Share {
    std::vector<std::uint32_t> boundaries;
    std::vector<std::uint32_t> tied;                    // sets whose boundary a tie leaves open
    std::vector<std::size_t> lengths, triangle_counts;  // how many there are of each
    StableStatistics statistics;
  };

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, StableOptions how)
      : diagram(voronoi),
        points(voronoi.points()),
        stationary(list),
        options(how),
        vertex_of(vertices_by_ordinal(voronoi.faces().delaunay())),
        gabriel(points, list, vertex_of) {}

  void compute(const Progress& progress);
  void make_set(Worker& worker, std::uint32_t i, std::uint32_t share);
  // Sorts the ends.
  void set_boundary(Set& set, std::vector<std::uint32_t>& ends, std::uint32_t share);
  void count(const Set& set, const Worker& worker, Share& share) const;
  void break_ties(Worker& worker);
  void sum_up();
  void find_largest();
  [[nodiscard]] std::size_t record_of(std::size_t i) const {
    return i < critical_count ? first_critical + i : first_regular + (i - critical_count);
  }
  [[nodiscard]] const Set& at(std::size_t i) const {
    FLOWCERT_REQUIRES(i < sets.size());
    return sets[i];
  }

  const VoronoiDiagram& diagram;
  const PointSet& points;
  const StationaryPoints& stationary;
  StableOptions options;
  std::vector<VertexIndex> vertex_of;
  GabrielEdges gabriel;
  std::size_t first_critical = 0, critical_count = 0, first_regular = 0;  // records
  std::vector<Set> sets;
  std::vector<Share> shares;
  StableStatistics statistics;
  WorkerPool<Worker> workers;
};

// What makes one skeleton at a time.
class StableManifolds::Parts::Worker {
 public:
  explicit Worker(const Parts& all)
      : all_(all),
        faces_(all.diagram),
        flow_(make_flow_operator(faces_, all.options.flow)),
        recorder_(all.points, faces_.diagram(), *flow_),
        walk_(faces_, *flow_, all.gabriel) {}

  // Walks the segments of a record's skeleton that lie before its intervals, and adds them to `geometry` if given.
  void walk(std::size_t record, Set& set, StableSet* geometry = nullptr);
  StableSet geometry(std::size_t record);
  RoundedSegments rounded_segments(std::size_t record);

  // Of the latest skeleton: its critical backs and the lengths of the orbits to them, and how many backs are regular.
  [[nodiscard]] std::vector<std::uint32_t>& ends() { return ends_; }
  [[nodiscard]] const std::vector<std::uint32_t>& lengths() const { return lengths_; }
  [[nodiscard]] std::size_t regular_backs() const { return regular_backs_; }
  // The boundary of a record's set where ties are broken.
  [[nodiscard]] std::vector<std::uint32_t> tie_broken_ends(std::size_t record, TieBreaking& ties) {
    clear();
    std::vector<VertexIndex> samples;
    for (const PointId name : all_.stationary.contact(record)) {
      samples.push_back(all_.vertex_of[all_.points.ordinal_of_row(name)]);
    }
    return tie_broken_boundary(faces_.diagram(), walk_, start(record), samples, ties);
  }
  [[nodiscard]] const KernelTally& tally() const { return flow_->tally(); }
  [[nodiscard]] std::size_t depth() const {
    Distribution ignored;
    std::size_t depth = 0;
    flow_->count_sizes(ignored, depth);
    return depth;
  }

 private:
  struct Task {
    FrontNumber front;
    FacetName facet;
  };
  struct Traced {
    Task task;
    BackwardWalk::Back back;
  };
  struct Source {
    CellIndex cluster;
    PolygonRef polygon;
  };

  void clear();
  FrontNumber start(std::size_t record);
  void push_sources(FrontNumber front, Set& set);
  void push_sides(FrontNumber front, PolygonRef polygon);
  void push_vertex(CellIndex cluster, FrontNumber front, Set& set);
  void follow(Set& set, StableSet* geometry);

  [[nodiscard]] RoundedSegments rounded_trace();
  void sort_by_exact_fronts(RoundedSegments& rounded);
  void record_segment(const Task& task, const BackwardWalk::Back& back, StableSet& geometry);
  void record_intervals(StableSet& geometry, Set& set);
  void record_sectors(const Arc& arc, StableSet& geometry, Set& set);
  [[nodiscard]] std::vector<RationalPoint> corners_of(const SectorParts& parts, FacetName facet);
  [[nodiscard]] RationalPoint position(FrontNumber front) { return flow_->exact(walk_.location(front)); }
  PointId name(VertexIndex v) const { return all_.points.name(faces_.delaunay().ordinals[v]); }

  const Parts& all_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  SegmentRecorder recorder_;
  BackwardWalk walk_;
  // Of one skeleton.
  std::vector<Task> tasks_;
  std::unordered_set<CellIndex> visited_;  // Voronoi vertices
  std::vector<std::uint32_t> ends_;
  std::vector<std::uint32_t> lengths_;
  std::size_t regular_backs_ = 0;
  std::vector<Source> sources_of_intervals_;
  bool is_traced_ = false;
  std::vector<Traced> trace_;  // all segments, if it is
};

// Begins at the point. All sides of a critical triangle are acute and lead there.
FrontNumber StableManifolds::Parts::Worker::start(std::size_t record) {
  const Place place = place_of_record(all_.stationary, record);
  if (place.kind == Place::Kind::kVertex) return walk_.at_vertex(place.vertex);
  const std::array<VertexIndex, 3> corners = faces_.corners(place.edge);
  const FrontNumber front = walk_.at_center(corners, place.edge);
  if (all_.stationary.index(record).is_critical() && all_.stationary.contact(record).size() == 3) {
    for (std::size_t k = 0; k < 3; ++k) tasks_.push_back({front, facet_name(corners[k], corners[(k + 1) % 3])});
  }
  return front;
}

void StableManifolds::Parts::Worker::push_sides(FrontNumber front, PolygonRef polygon) {
  for (const PolygonSide& side : faces_.sides(polygon)) {
    if (side.angle == Sign::kPositive) tasks_.push_back({front, {side.v0, side.v1}});
  }
}

void StableManifolds::Parts::Worker::push_vertex(CellIndex cluster, FrontNumber front, Set& set) {
  if (!visited_.insert(cluster).second) return;
  set.has_vertex = true;
  const VertexSources sources = vertex_sources(faces_.diagram(), cluster);
  for (const FacetName edge : sources.edges) tasks_.push_back({front, edge});
  set.has_interval = set.has_interval || !sources.polygons.empty();
  for (const PolygonRef polygon : sources.polygons) sources_of_intervals_.push_back({cluster, polygon});
}

void StableManifolds::Parts::Worker::push_sources(FrontNumber front, Set& set) {
  const Place place = walk_.place(front);
  if (place.kind == Place::Kind::kVertex) return push_vertex(place.vertex, front, set);
  push_sides(front, place.edge);
}

void StableManifolds::Parts::Worker::follow(Set& set, StableSet* geometry) {
  while (!tasks_.empty()) {
    const Task task = tasks_.back();
    tasks_.pop_back();
    ++set.segments;
    const BackwardWalk::Back back = walk_.step(task.front, task.facet);
    if (geometry != nullptr) record_segment(task, back, *geometry);
    if (is_traced_) trace_.push_back({task, back});
    if (back.critical) {
      ends_.push_back(*back.critical);
      lengths_.push_back(walk_.depth(task.front) + 1);
    } else if (back.is_regular) {
      ++regular_backs_;
    } else {
      push_sources(back.front, set);
    }
  }
}

void StableManifolds::Parts::Worker::clear() {
  tasks_.clear();
  visited_.clear();
  ends_.clear();
  lengths_.clear();
  sources_of_intervals_.clear();
  regular_backs_ = 0;
  walk_.clear();
}

void StableManifolds::Parts::Worker::walk(std::size_t record, Set& set, StableSet* geometry) {
  clear();
  const FrontNumber root = start(record);
  if (tasks_.empty()) push_sources(root, set);
  follow(set, geometry);
}

void StableManifolds::Parts::Worker::record_segment(const Task& task, const BackwardWalk::Back& back,
                                                    StableSet& geometry) {
  BackwardSegment segment;
  segment.samples = {name(task.facet.v0), name(task.facet.v1)};
  std::ranges::sort(segment.samples);
  const Location front = walk_.location(task.front);
  segment.front = flow_->exact(front);
  segment.front_contact = recorder_.contact(front.place);
  if (back.critical) {
    segment.back_contact = {segment.samples.begin(), segment.samples.end()};
    segment.back = exact_sphere(all_.points, segment.samples).center;
  } else {
    const Location at = walk_.location(back.front);
    const bool is_edge = at.place.kind == Place::Kind::kEdge;
    segment.back_kind = back.is_regular ? BackKind::kRegular : is_edge ? BackKind::kEdge : BackKind::kVertex;
    segment.back = flow_->exact(at);
    segment.back_contact = recorder_.contact(at.place);
  }
  geometry.segments.push_back(std::move(segment));
}

// One interval may lead to a Voronoi vertex that adds segments and more intervals.
void StableManifolds::Parts::Worker::record_intervals(StableSet& geometry, Set& set) {
  while (!sources_of_intervals_.empty()) {
    const auto [cluster, polygon] = sources_of_intervals_.back();
    sources_of_intervals_.pop_back();
    const std::size_t far = faces_.end(polygon, 0) == cluster ? 1 : 0;
    const CellIndex other = faces_.end(polygon, far);
    const Sign beyond = other == kNoCell ? Sign::kPositive : side_at(faces_.diagram(), polygon, far);
    const FrontNumber front = walk_.at_vertex(cluster);
    BackwardInterval interval;
    interval.polygon = recorder_.contact(Place::on_edge(polygon));
    interval.front = position(front);
    interval.back_is_stationary = beyond != Sign::kNegative;
    const FrontNumber back =
        interval.back_is_stationary ? walk_.at_center(faces_.corners(polygon), polygon) : walk_.at_vertex(other);
    interval.back = position(back);
    if (!interval.back_is_stationary) push_vertex(other, back, set);
    record_sectors({polygon, far == 1 ? front : back, far == 1 ? back : front}, geometry, set);
    geometry.intervals.push_back(std::move(interval));
    follow(set, &geometry);
  }
}

void StableManifolds::Parts::Worker::record_sectors(const Arc& arc, StableSet& geometry, Set& set) {
  std::vector<Arc> arcs{arc};
  while (!arcs.empty()) {
    const Arc next = arcs.back();
    arcs.pop_back();
    for (const PolygonSide& side : faces_.sides(next.polygon)) {
      if (side.angle != Sign::kPositive) continue;
      const SectorParts parts = sector_of(faces_, walk_, {side.v0, side.v1}, next);
      for (const CellIndex cluster : parts.vertices) push_vertex(cluster, walk_.at_vertex(cluster), set);
      arcs.insert(arcs.end(), parts.arcs.begin(), parts.arcs.end());
      BackwardSector sector{{name(side.v0), name(side.v1)}, corners_of(parts, {side.v0, side.v1})};
      std::ranges::sort(sector.samples);
      geometry.sectors.push_back(std::move(sector));
    }
  }
}

std::vector<RationalPoint> StableManifolds::Parts::Worker::corners_of(const SectorParts& parts, FacetName facet) {
  std::vector<RationalPoint> corners;
  for (const FrontNumber front : parts.corners) corners.push_back(position(front));
  if (parts.has_midpoint) {
    const Point &p = faces_.point(facet.v0), &q = faces_.point(facet.v1);
    corners.push_back({(Rational(p.x) + Rational(q.x)) / 2, (Rational(p.y) + Rational(q.y)) / 2,
                       (Rational(p.z) + Rational(q.z)) / 2});
  }
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  if (corners.size() > 2 && corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

StableSet StableManifolds::Parts::Worker::geometry(std::size_t record) {
  Set set;
  StableSet geometry;
  walk(record, set, &geometry);
  record_intervals(geometry, set);
  clear();
  std::ranges::sort(geometry.segments, {}, [](const BackwardSegment& x) { return std::tie(x.samples, x.front); });
  std::ranges::sort(geometry.intervals, {}, [](const BackwardInterval& x) { return std::tie(x.polygon, x.front); });
  std::ranges::sort(geometry.sectors, {}, [](const BackwardSector& x) { return std::tie(x.samples, x.corners); });
  return geometry;
}

RoundedSegments StableManifolds::Parts::Worker::rounded_segments(std::size_t record) {
  Set set;
  StableSet exact;  // only sets with intervals make any of it
  trace_.clear();
  is_traced_ = true;
  walk(record, set);
  record_intervals(exact, set);
  is_traced_ = false;
  RoundedSegments rounded = rounded_trace();
  clear();
  return rounded;
}

// The flow leads from a point to one front, through one facet. So no two fronts of a walk are equal, unless both are
// one Voronoi vertex.
RoundedSegments StableManifolds::Parts::Worker::rounded_trace() {
  RoundedSegments all;
  std::unordered_map<FrontNumber, std::uint32_t> place_of_front;
  std::unordered_map<CellIndex, std::uint32_t> place_of_vertex;
  const auto add = [&](const RoundedSphere& sphere, std::vector<PointId> end) {
    all.positions.push_back({sphere, std::move(end)});
    return static_cast<std::uint32_t>(all.positions.size() - 1);
  };
  const auto place_of = [&](FrontNumber front) {
    const Place& face = walk_.place(front);
    auto [at, is_new] = face.kind == Place::Kind::kVertex ? place_of_vertex.try_emplace(face.vertex, 0)
                                                          : place_of_front.try_emplace(front, 0);
    if (is_new) at->second = add(flow_->rounded(walk_.location(front)), {});
    return at->second;
  };
  for (const auto& [task, back] : trace_) {
    std::array<PointId, 2> samples{name(task.facet.v0), name(task.facet.v1)};
    std::ranges::sort(samples);
    const std::uint32_t front = place_of(task.front);
    std::uint32_t end = 0;
    if (back.critical) {
      end = add(rounded_sphere(all_.points, samples, 1), {samples.begin(), samples.end()});
    } else if (back.is_regular) {
      const Location at = walk_.location(back.front);
      end = add(flow_->rounded(at), recorder_.contact(at.place));
    } else {
      end = place_of(back.front);
    }
    all.segments.push_back({samples, front, end});
  }
  sort_by_exact_fronts(all);
  return all;
}

// The segments are those of the trace. Rounding keeps the order of numbers, or makes them equal.
void StableManifolds::Parts::Worker::sort_by_exact_fronts(RoundedSegments& rounded) {
  std::vector<std::uint32_t> order(trace_.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    const RoundedSegments::Segment &x = rounded.segments[i], &y = rounded.segments[j];
    if (x.samples != y.samples) return x.samples < y.samples;
    const double a = rounded.positions[x.front].sphere.center.x, b = rounded.positions[y.front].sphere.center.x;
    if (a != b) return a < b;
    return flow_->exact(walk_.location(trace_[i].task.front)) < flow_->exact(walk_.location(trace_[j].task.front));
  });
  std::vector<RoundedSegments::Segment> sorted;
  sorted.reserve(order.size());
  for (const std::uint32_t k : order) sorted.push_back(rounded.segments[k]);
  rounded.segments.swap(sorted);
}

void StableManifolds::Parts::count(const Set& set, const Worker& worker, Share& share) const {
  for (const std::uint32_t length : worker.lengths()) {
    if (share.lengths.size() <= length) share.lengths.resize(length + 1, 0);
    ++share.lengths[length];
  }
  share.statistics.with_vertex += set.has_vertex ? 1 : 0;
  share.statistics.with_interval += set.has_interval ? 1 : 0;
  share.statistics.ends_at_regular += worker.regular_backs();
  if (set.has_interval) return;
  const std::size_t triangles = 2 * std::size_t{set.segments};
  if (share.triangle_counts.size() <= triangles) share.triangle_counts.resize(triangles + 1, 0);
  ++share.triangle_counts[triangles];
  share.statistics.triangle_count += triangles;
}

void StableManifolds::Parts::make_set(Worker& worker, std::uint32_t i, std::uint32_t share) {
  Set& set = sets[i];
  set = {};
  set.record = static_cast<std::uint32_t>(record_of(i));
  worker.walk(set.record, set);
  if (!stationary.index(set.record).is_critical()) return;
  count(set, worker, shares[share]);
  if (set.has_vertex || worker.regular_backs() > 0) {
    shares[share].tied.push_back(i);
  } else {
    set_boundary(set, worker.ends(), share);
  }
}

void StableManifolds::Parts::set_boundary(Set& set, std::vector<std::uint32_t>& ends, std::uint32_t share) {
  std::vector<std::uint32_t>& boundaries = shares[share].boundaries;
  set.share = share;
  set.boundary_first = boundaries.size();
  add_mod_2(ends, boundaries);
  set.boundary_count = boundaries.size() - set.boundary_first;
}

// The first of the sets with the most triangles.
void StableManifolds::Parts::find_largest() {
  for (std::size_t i = 0; i < critical_count; ++i) {
    if (sets[i].has_interval) continue;
    if (!statistics.largest || sets[i].segments > sets[*statistics.largest].segments) statistics.largest = i;
  }
}

// Ties are broken in the order of the list, on which the choices depend.
void StableManifolds::Parts::break_ties(Worker& worker) {
  std::vector<std::uint32_t> tied;
  for (const Share& share : shares) tied.insert(tied.end(), share.tied.begin(), share.tied.end());
  std::ranges::sort(tied);
  TieBreaking ties(options.seed, TieBreaking::Of::kStable);
  for (const std::uint32_t i : tied) {
    std::vector<std::uint32_t> ends = worker.tie_broken_ends(sets[i].record, ties);
    set_boundary(sets[i], ends, 0);
  }
  statistics.broken_ties = tied.size();
}

void StableManifolds::Parts::sum_up() {
  for (Share& share : shares) {
    statistics.with_vertex += share.statistics.with_vertex;
    statistics.with_interval += share.statistics.with_interval;
    statistics.ends_at_regular += share.statistics.ends_at_regular;
    statistics.triangle_count += share.statistics.triangle_count;
    for (std::size_t k = 0; k < share.lengths.size(); ++k) {
      if (share.lengths[k] > 0) statistics.n_s2.add(k, share.lengths[k]);
    }
    for (std::size_t k = 0; k < share.triangle_counts.size(); ++k) {
      if (share.triangle_counts[k] > 0) statistics.triangles.add(k, share.triangle_counts[k]);
    }
    share.tied = {}, share.lengths = {}, share.triangle_counts = {};
  }
  find_largest();
}

void StableManifolds::Parts::compute(const Progress& progress) {
  const RecordFinder finder(stationary);
  const auto [first, last] = finder.range({2, 2});
  first_critical = first;
  critical_count = last - first;
  first_regular = finder.range({3, 3}).second;
  sets.resize(critical_count + stationary.size() - first_regular);
  const std::vector<std::uint32_t> order =
      along_the_curve(stationary, sets.size(), [this](std::uint32_t k) { return record_of(k); });
  std::vector<std::unique_ptr<Worker>> team;
  const unsigned threads = team_size(options.flow, options.threads);
  for (unsigned k = 0; k < threads; ++k) team.push_back(std::make_unique<Worker>(*this));
  shares.resize(team.size());
  const geometry::Portions::Progress tell = [&](std::size_t begun) {
    if (progress) progress(begun, sets.size());
  };
  geometry::in_portions(threads, order.size(), kProgressStep, tell, [&](std::size_t thread, std::size_t at) {
    if (at + kAhead < order.size()) {
      stationary.prefetch(record_of(order[at + kAhead]));
      __builtin_prefetch(&sets[order[at + kAhead]], 1);
    }
    make_set(*team[thread], order[at], static_cast<std::uint32_t>(thread));
  });
  break_ties(*team.front());
  sum_up();
  for (const auto& worker : team) {
    statistics.tally += worker->tally();
    statistics.depth = std::max(statistics.depth, worker->depth());
  }
  if (progress) progress(sets.size(), sets.size());
}

StableManifolds::StableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                                 StableOptions options, const Progress& progress)
    : parts_(std::make_unique<Parts>(diagram, stationary, options)) {
  parts_->compute(progress);
}
StableManifolds::~StableManifolds() = default;
StableManifolds::StableManifolds(StableManifolds&&) noexcept = default;
StableManifolds& StableManifolds::operator=(StableManifolds&&) noexcept = default;

const char* back_kind_text(BackKind kind) {
  constexpr std::array<const char*, 4> kTexts = {"critical", "regular", "edge", "vertex"};
  return kTexts.at(static_cast<std::size_t>(kind));
}

StableSet StableManifolds::set(std::size_t i) const { return set_of_record(record(i)); }
StableSet StableManifolds::set_of_record(std::size_t record) const {
  if (parts_->stationary.index(record).hull_dimension < 2) return {};
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) { return worker.geometry(record); });
}
RoundedSegments StableManifolds::rounded_segments(std::size_t i) const {
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) { return worker.rounded_segments(record(i)); });
}
std::size_t StableManifolds::size() const { return parts_->sets.size(); }
std::size_t StableManifolds::record(std::size_t i) const { return parts_->at(i).record; }
std::size_t StableManifolds::segment_count(std::size_t i) const { return parts_->at(i).segments; }
bool StableManifolds::has_vertex(std::size_t i) const { return parts_->at(i).has_vertex; }
bool StableManifolds::has_interval(std::size_t i) const { return parts_->at(i).has_interval; }
std::span<const std::uint32_t> StableManifolds::boundary(std::size_t i) const {
  const auto& set = parts_->at(i);
  return std::span(parts_->shares[set.share].boundaries).subspan(set.boundary_first, set.boundary_count);
}
const StableStatistics& StableManifolds::statistics() const { return parts_->statistics; }

}  // namespace flowcert
