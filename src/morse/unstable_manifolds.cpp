// Orbits are followed in the forest of Voronoi vertices (SuccessorForest). Their points are made again when an orbit
// is asked for, by a worker that no other thread has.
#include "flowcert/unstable_manifolds.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "flow/rounded_stretches.h"
#include "flow/segment_record.h"
#include "flow/successor_forest.h"
#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/parallel_for.h"
#include "geometry/portions.h"
#include "geometry/prefetch.h"
#include "geometry/rational_point.h"
#include "morse/along_the_curve.h"
#include "morse/layer.h"
#include "morse/polygon_turn.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::size_t kProgressStep = 256;

}  // namespace

struct UnstableManifolds::Parts {
  class Worker;

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, FlowOptions how)
      : diagram(voronoi), stationary(list), finder(list), options(how) {}

  void compute(const Progress& progress);
  [[nodiscard]] auto with_worker(const auto& use);

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  RecordFinder finder;
  FlowOptions options;
  std::vector<std::uint32_t> record_at;  // by cluster: the stationary point there
  // The index-2 points come one after the other in the list. A limit is a place in the list.
  static constexpr std::uint32_t kInfinity = 0xffffffffu;
  std::size_t first_saddle = 0;
  std::size_t critical_count = 0;  // these come first in the list
  std::vector<std::array<std::uint32_t, 2>> limits;
  FlowStatistics statistics;
  WorkerPool<Worker> workers;
};

class UnstableManifolds::Parts::Worker {
 public:
  explicit Worker(const Parts& all)
      : all_(all),
        faces_(all.diagram),
        flow_(make_flow_operator(faces_, all.options)),
        recorder_(all.diagram, *flow_),
        forest_(faces_.diagram(), all.options.share),
        rounded_(*flow_, faces_.diagram().delaunay().finite_count) {}

  // The Voronoi vertices to which the two sides of a manifold lead first, or kNoCell for infinity.
  [[nodiscard]] std::array<CellIndex, 2> first_vertices(std::size_t saddle) {
    const PolygonRef polygon = edge_of_record(all_.stationary, saddle);
    std::array<CellIndex, 2> ends{faces_.diagram().end(polygon, 0), faces_.diagram().end(polygon, 1)};
    if (is_reversed(saddle, polygon)) std::swap(ends[0], ends[1]);
    return ends;
  }
  // Flows from many Voronoi vertices, with all of these workers. The forest is this one's.
  void flow_from(std::span<const CellIndex> starts, std::span<const std::unique_ptr<Worker>> workers,
                 const Progress& progress);
  // The orbit from a first vertex on, alone: returns what it ends at.
  std::uint32_t follow_alone(CellIndex first_vertex) {
    if (first_vertex == kNoCell) return count_orbit(nullptr, kInfinity);
    const Stretch& first = forest_.visit(first_vertex, *flow_);
    return count_orbit(&first, limit_at(forest_.end_of(first)));
  }
  // Prefetches what follow_in() reads of this worker's forest.
  void prefetch(std::span<const CellIndex> first_vertices) const {
    for (const CellIndex vertex : first_vertices) {
      if (vertex != kNoCell) forest_.prefetch_known(vertex);
    }
  }
  // Follows the orbit where another worker's forest knows its first vertex. Workers may do this at once.
  std::uint32_t follow_in(Worker& other, CellIndex first_vertex) {
    if (first_vertex == kNoCell) return count_orbit(nullptr, kInfinity);
    const Stretch& first = other.forest_.visit_known(first_vertex);
    return count_orbit(&first, first.end == Stretch::kInfinity ? kInfinity : other.limit_at_end_[first.end]);
  }
  // Finds the limits that follow_in() reads of this worker.
  void find_limits() {
    for (const ForestEnd& end : forest_.ends()) limit_at_end_.push_back(limit_at(end));
  }
  // Adds what was flowed. Without sharing, all of that is forgotten.
  void count(FlowStatistics& statistics);
  std::optional<std::size_t> limit_beyond(std::size_t record, std::size_t choice);
  Orbit orbit(std::size_t saddle, std::size_t side);
  std::vector<RoundedSphere> rounded_orbit(std::size_t saddle, std::size_t side);
  // The orbit must go to infinity.
  Point direction_to_infinity(std::size_t saddle, std::size_t side);
  [[nodiscard]] const KernelTally& tally() const { return flow_->tally(); }

 private:
  [[nodiscard]] bool is_reversed(std::size_t record, PolygonRef polygon) const;
  // The normal of the plane through the saddle's contact points points to side 1.
  [[nodiscard]] RationalPoint normal_of(std::size_t saddle) const;
  [[nodiscard]] Point last_direction_from(CellIndex vertex);
  // If the polygon is reversed, side 0 of the manifold is end 1 of the Voronoi edge.
  [[nodiscard]] Location start_of(std::size_t saddle, std::size_t side) {
    const PolygonRef polygon = edge_of_record(all_.stationary, saddle);
    return flow_->end_of_edge(polygon, is_reversed(saddle, polygon) ? 1 - side : side);
  }
  void drop() {
    forest_.drop();
    flow_->drop_all();
  }
  // Most orbits end at a maximum, and others at the centre of an edge's polygon or at a regular stationary point.
  [[nodiscard]] std::optional<std::size_t> record_of(const std::optional<ForestEnd>& end) const {
    if (!end) return std::nullopt;
    if (end->place.kind == Place::Kind::kVertex) return all_.record_at[end->place.vertex];
    return all_.finder.find(end->index, recorder_.contact(end->place));
  }

  [[nodiscard]] std::uint32_t limit_at(const std::optional<ForestEnd>& end) const {
    const std::optional<std::size_t> record = record_of(end);
    return record ? static_cast<std::uint32_t>(*record) : kInfinity;
  }

  const Parts& all_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  SegmentRecorder recorder_;
  SuccessorForest forest_;
  RoundedStretches rounded_;
  std::unordered_map<CellIndex, Point> last_directions_;  // by the last Voronoi vertex
  std::vector<std::uint32_t> limit_at_end_;               // by the forest's ends
  // The orbit that begins with this stretch, or with none, and its limit, which it returns.
  std::uint32_t count_orbit(const Stretch* first, std::uint32_t limit);

  // Counts that go to the statistics together.
  struct {
    std::size_t to_critical = 0, to_regular = 0, to_infinity = 0;
  } ends_;
  std::size_t to_vertex_ = 0, to_infinity_ = 0;
  std::vector<std::size_t> lengths_;  // of orbits: how many have each
};

auto UnstableManifolds::Parts::with_worker(const auto& use) {
  return workers.with([this] { return std::make_unique<Worker>(*this); }, use);
}

// Whether the contact points a, b, c, in the order of their names, turn the other way than the polygon's
// corners. Ordinals ascend with names.
bool UnstableManifolds::Parts::Worker::is_reversed(std::size_t record, PolygonRef polygon) const {
  const auto corners = faces_.diagram().corners(polygon);
  const auto contact = all_.stationary.contact(record);
  if (contact.size() == 3) {
    const auto& ordinals = faces_.diagram().delaunay().ordinals;
    const std::array<std::uint32_t, 3> o{ordinals[corners[0]], ordinals[corners[1]], ordinals[corners[2]]};
    return int{o[0] < o[1]} + int{o[1] < o[2]} + int{o[2] < o[0]} == 1;
  }
  const auto sample = [&](std::size_t k) { return all_.diagram.named(contact[k]); };
  return !has_turn(all_.diagram, polygon, {sample(0), sample(1), sample(2)});
}

RationalPoint UnstableManifolds::Parts::Worker::normal_of(std::size_t saddle) const {
  const auto contact = all_.stationary.contact(saddle);
  const auto at = [&](std::size_t k) { return exact_position(all_.diagram.points().at_row(contact[k])); };
  return geometry::normal_of(at(0), at(1), at(2));
}

void UnstableManifolds::Parts::Worker::flow_from(std::span<const CellIndex> starts,
                                                 std::span<const std::unique_ptr<Worker>> workers,
                                                 const Progress& progress) {
  std::vector<FlowOperator*> flows;
  for (const auto& worker : workers) flows.push_back(worker->flow_.get());
  forest_.flow_from(starts, flows, progress);
}

std::uint32_t UnstableManifolds::Parts::Worker::count_orbit(const Stretch* first, std::uint32_t limit) {
  const std::size_t length = 1 + (first != nullptr ? std::size_t{first->total} : 0);
  ++(first != nullptr ? to_vertex_ : to_infinity_);
  if (lengths_.size() <= length) lengths_.resize(length + 1, 0);
  ++lengths_[length];
  ++(limit == kInfinity ? ends_.to_infinity : limit < all_.critical_count ? ends_.to_critical : ends_.to_regular);
  return limit;
}

void UnstableManifolds::Parts::Worker::count(FlowStatistics& statistics) {
  forest_.count(statistics);
  statistics.segments_computed += to_vertex_ + to_infinity_;
  statistics.to_critical += ends_.to_critical;
  statistics.to_regular += ends_.to_regular;
  statistics.to_infinity += ends_.to_infinity;
  ends_ = {};
  if (to_vertex_ > 0) statistics.census[{'E', 'E', 'V'}] += std::exchange(to_vertex_, 0);
  if (to_infinity_ > 0) statistics.census[{'E', 'E', 0}] += std::exchange(to_infinity_, 0);
  for (std::size_t length = 0; length < lengths_.size(); ++length) {
    if (lengths_[length] > 0) statistics.n_u2.add(length, std::exchange(lengths_[length], 0));
  }
  if (!all_.options.share) drop();
}

std::optional<std::size_t> UnstableManifolds::Parts::Worker::limit_beyond(std::size_t record, std::size_t choice) {
  const Place place = place_of_record(all_.stationary, record);
  Location start;
  if (place.kind == Place::Kind::kEdge) {
    start = flow_->end_of_edge(place.edge, choice % 2);
  } else {
    const std::vector<PolygonRef> polygons = polygons_through(faces_.diagram(), place.vertex);
    const PolygonRef polygon = polygons.at(choice % polygons.size());
    start = flow_->end_of_edge(polygon, faces_.diagram().end(polygon, 0) == place.vertex ? 1 : 0);
  }
  const std::optional<std::size_t> limit = record_of(forest_.end_from(start.place, *flow_));
  if (!all_.options.share) drop();
  return limit;
}

Orbit UnstableManifolds::Parts::Worker::orbit(std::size_t saddle, std::size_t side) {
  const PointSet& points = all_.diagram.points();
  Orbit orbit{exact_sphere(points, all_.stationary.contact(saddle)).center, {}, std::nullopt};
  FlowStep first;
  const PolygonRef polygon = edge_of_record(all_.stationary, saddle);
  first.crossed = Place::on_edge(polygon);
  first.driver = {faces_.diagram().corners(polygon), 3};
  first.end = start_of(saddle, side);
  orbit.segments.push_back(recorder_.segment({first.crossed, flow_->add(orbit.start)}, first));
  recorder_.follow(first.end, orbit);
  return orbit;
}

std::vector<RoundedSphere> UnstableManifolds::Parts::Worker::rounded_orbit(std::size_t saddle, std::size_t side) {
  const std::size_t dimension = all_.stationary.index(saddle).hull_dimension;
  std::vector<RoundedSphere> points{rounded_sphere(all_.diagram.points(), all_.stationary.contact(saddle), dimension)};
  const Place place = start_of(saddle, side).place;
  if (place.kind == Place::Kind::kVertex) rounded_.append_orbit(place.vertex, points);
  return points;
}

Point UnstableManifolds::Parts::Worker::direction_to_infinity(std::size_t saddle, std::size_t side) {
  const Place place = start_of(saddle, side).place;
  if (place.kind == Place::Kind::kVertex) return last_direction_from(rounded_.last_vertex(place.vertex));
  return rounded_point(as_direction(Rational(side == 1 ? 1 : -1) * normal_of(saddle)));
}

Point UnstableManifolds::Parts::Worker::last_direction_from(CellIndex vertex) {
  const auto [known, is_new] = last_directions_.try_emplace(vertex);
  if (!is_new) return known->second;
  Location at{Place::at_vertex(vertex), kNoPoint};
  FlowStep step = flow_->step(at);
  while (step.end.place.kind != Place::Kind::kInfinity) {
    at = step.end;
    step = flow_->step(at);
  }
  const FlowSegment last = recorder_.segment(at, step);
  flow_->drop_from(0);
  return known->second = rounded_point(as_direction(last.start - last.driver));
}

void UnstableManifolds::Parts::compute(const Progress& progress) {
  if (diagram.dimension() == 3) record_at.resize(diagram.delaunay().finite_count);
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    if (stationary.index(record).hull_dimension != 3) continue;
    record_at[cell_of_record(stationary, record)] = static_cast<std::uint32_t>(record);
  }
  const auto [first, last] = finder.range({2, 2});
  first_saddle = first;
  critical_count = finder.range({3, 3}).second;
  limits.resize(last - first);
  const auto record_of = [first = first](std::uint32_t i) { return first + i; };
  const std::vector<std::uint32_t> order = along_the_curve(stationary, limits.size(), record_of, options.threads);
  std::vector<std::unique_ptr<Worker>> team;
  const unsigned most = team_size(options, options.threads), threads = options.share ? most : 1;
  team.reserve(threads);
  for (unsigned k = 0; k < threads; ++k) team.push_back(std::make_unique<Worker>(*this));
  constexpr std::size_t kPortion = geometry::portion_size(1024);
  std::vector<CellIndex> starts(2 * order.size());
  geometry::in_portions(threads, order.size(), kPortion, {}, [&](std::size_t thread, std::size_t k) {
    geometry::prefetch_ahead(k, order.size(), [&](std::size_t at) { stationary.prefetch(first_saddle + order[at]); });
    const auto [one, other] = team[thread]->first_vertices(first_saddle + order[k]);
    starts[2 * k] = one;
    starts[2 * k + 1] = other;
  });
  Worker& leader = *team.front();
  if (options.share) {
    leader.flow_from(starts, team, progress);
    leader.find_limits();
    geometry::in_portions(threads, order.size(), kPortion, {}, [&](std::size_t thread, std::size_t k) {
      geometry::prefetch_ahead(k, order.size(),
                               [&](std::size_t at) { leader.prefetch(std::span(starts).subspan(2 * at, 2)); });
      for (const std::size_t side : {0U, 1U}) {
        limits[order[k]][side] = team[thread]->follow_in(leader, starts[2 * k + side]);
      }
    });
  }
  for (std::size_t k = 0; k < order.size() && !options.share; ++k) {
    if (progress && k % kProgressStep == 0) progress(k, limits.size());
    for (const std::size_t side : {0U, 1U}) {
      limits[order[k]][side] = leader.follow_alone(starts[2 * k + side]);
      leader.count(statistics);
    }
  }
  for (const auto& worker : team) worker->count(statistics);
  for (const auto& worker : team) statistics.tally += worker->tally();
  // Where ties are broken, the leader's forest gives most limits (limit_beyond). Otherwise its memory is given back.
  const RegularCounts& regular = stationary.regular_counts();
  if (regular.kind12 + regular.kind13 + regular.kind23 > 0) workers.give(std::move(team.front()));
  if (progress) progress(limits.size(), limits.size());
}

UnstableManifolds::UnstableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                                     FlowOptions options, const Progress& progress)
    : parts_(geometry::in_ieee_doubles([&] {
        auto parts = std::make_unique<Parts>(diagram, stationary, options);
        parts->compute(progress);
        return parts;
      })) {}
UnstableManifolds::~UnstableManifolds() = default;
UnstableManifolds::UnstableManifolds(UnstableManifolds&&) noexcept = default;
UnstableManifolds& UnstableManifolds::operator=(UnstableManifolds&&) noexcept = default;

std::size_t UnstableManifolds::size() const { return parts_->limits.size(); }
std::size_t UnstableManifolds::saddle(std::size_t i) const {
  FLOWCERT_REQUIRES(i < size());
  return parts_->first_saddle + i;
}
std::optional<std::size_t> UnstableManifolds::limit(std::size_t i, std::size_t side) const {
  FLOWCERT_REQUIRES(i < size() && side < 2);
  const std::uint32_t limit = parts_->limits[i][side];
  return limit == Parts::kInfinity ? std::nullopt : std::optional<std::size_t>(limit);
}
Orbit UnstableManifolds::orbit(std::size_t i, std::size_t side) const {
  const geometry::IeeeDoubles ieee;
  FLOWCERT_REQUIRES(i < size() && side < 2);
  return parts_->with_worker([&](Parts::Worker& worker) { return worker.orbit(saddle(i), side); });
}
std::vector<RoundedSphere> UnstableManifolds::rounded_orbit(std::size_t i, std::size_t side) const {
  const geometry::IeeeDoubles ieee;
  FLOWCERT_REQUIRES(i < size() && side < 2);
  return parts_->with_worker([&](Parts::Worker& worker) { return worker.rounded_orbit(saddle(i), side); });
}
std::optional<Point> UnstableManifolds::direction_to_infinity(std::size_t i, std::size_t side) const {
  const geometry::IeeeDoubles ieee;
  if (limit(i, side)) return std::nullopt;
  return parts_->with_worker([&](Parts::Worker& worker) { return worker.direction_to_infinity(saddle(i), side); });
}
std::optional<std::size_t> UnstableManifolds::limit_beyond(std::size_t record, std::size_t choice) const {
  FLOWCERT_REQUIRES(parts_->stationary.index(record) == (StationaryIndex{2, 2}) ||
                    !parts_->stationary.index(record).is_critical());
  return parts_->with_worker([&](Parts::Worker& worker) { return worker.limit_beyond(record, choice); });
}
const FlowStatistics& UnstableManifolds::statistics() const { return parts_->statistics; }

}  // namespace flowcert
