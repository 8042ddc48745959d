// Orbits are followed in the forest of Voronoi vertices (SuccessorForest). Their points are made again when an orbit
// is asked for, by a worker that no other thread has.
#include "flowcert/unstable_manifolds.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "flow/segment_record.h"
#include "flow/successor_forest.h"
#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::size_t kProgressStep = 256;

}  // namespace

struct UnstableManifolds::Parts {
  struct Saddle {
    std::size_t record;
    PolygonRef polygon;
    bool is_reversed;  // side 0 of the manifold is end 1 of the Voronoi edge
    std::array<std::optional<std::size_t>, 2> limits;
  };
  class Worker;

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, UnstableOptions how)
      : diagram(voronoi),
        stationary(list),
        finder(list),
        options(how),
        vertex_of(vertices_by_ordinal(voronoi.faces().delaunay())) {}

  void compute(const Progress& progress);
  [[nodiscard]] auto with_worker(const auto& use);

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  RecordFinder finder;
  UnstableOptions options;
  std::vector<VertexIndex> vertex_of;
  std::vector<Saddle> saddles;
  FlowStatistics statistics;
  WorkerPool<Worker> workers;
};

class UnstableManifolds::Parts::Worker {
 public:
  explicit Worker(const Parts& all)
      : all_(all),
        faces_(all.diagram),
        flow_(make_flow_operator(faces_, all.options.flow)),
        recorder_(all.diagram.points(), faces_.diagram(), *flow_),
        forest_(faces_.diagram(), *flow_, all.options.share) {}

  Saddle saddle(std::size_t record);
  // Follows one orbit, from stretch to stretch, and returns what it ends at.
  std::optional<std::size_t> follow(const Saddle& saddle, std::size_t side, FlowStatistics& statistics);
  // Adds what was flowed. Without sharing, all of that is forgotten.
  void count(FlowStatistics& statistics);
  std::optional<std::size_t> limit_beyond(std::size_t record, std::size_t choice);
  Orbit orbit(const Saddle& saddle, std::size_t side);
  [[nodiscard]] const KernelTally& tally() const { return flow_->tally(); }

 private:
  // Sets contact_ to the vertices of the record's contact set, in the order of their names.
  Place place_of(std::size_t record);
  [[nodiscard]] bool is_reversed(const Place& place) const;
  [[nodiscard]] Location start_of(const Saddle& saddle, std::size_t side) {
    return flow_->end_of_edge(saddle.polygon, saddle.is_reversed ? 1 - side : side);
  }
  [[nodiscard]] std::optional<std::size_t> record_of(const std::optional<ForestEnd>& end) const {
    return end ? all_.finder.find(end->index, recorder_.contact(end->place)) : std::nullopt;
  }

  const Parts& all_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  SegmentRecorder recorder_;
  SuccessorForest forest_;
  std::vector<VertexIndex> contact_;
  // By the last Voronoi vertex of an orbit.
  std::unordered_map<CellIndex, std::optional<std::size_t>> limit_of_;
};

auto UnstableManifolds::Parts::with_worker(const auto& use) {
  return workers.with([this] { return std::make_unique<Worker>(*this); }, use);
}

// Whether the contact points a, b, c, in the order of their names, turn the other way than the polygon's
// corners.
bool UnstableManifolds::Parts::Worker::is_reversed(const Place& place) const {
  const auto corners = faces_.corners(place.edge);
  if (contact_.size() == 3) {
    const auto at = std::find(corners.begin(), corners.end(), contact_[0]) - corners.begin();
    return corners[static_cast<std::size_t>(at + 1) % 3] != contact_[1];
  }
  const auto normal = [this](VertexIndex a, VertexIndex b, VertexIndex c) {
    const auto vector = [this](VertexIndex from, VertexIndex to) {
      const Point &p = faces_.point(from), &q = faces_.point(to);
      return Vector3<Rational>{Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y),
                               Rational(q.z) - Rational(p.z)};
    };
    return cross(vector(a, b), vector(a, c));
  };
  return dot(normal(corners[0], corners[1], corners[2]), normal(contact_[0], contact_[1], contact_[2])) < 0;
}

Place UnstableManifolds::Parts::Worker::place_of(std::size_t record) {
  contact_.clear();
  for (const PointId name : all_.stationary.contact(record)) {
    contact_.push_back(all_.vertex_of[all_.diagram.points().ordinal_of_row(name)]);
  }
  return faces_.place_of(contact_.front(), std::span(contact_).subspan(1));
}

UnstableManifolds::Parts::Saddle UnstableManifolds::Parts::Worker::saddle(std::size_t record) {
  const Place place = place_of(record);
  return {record, place.edge, is_reversed(place), {}};
}

std::optional<std::size_t> UnstableManifolds::Parts::Worker::follow(const Saddle& saddle, std::size_t side,
                                                                    FlowStatistics& statistics) {
  const Location start = start_of(saddle, side);
  std::size_t length = 1;
  ++statistics.census[{'E', 'E', letter(start.place.kind)}];
  ++statistics.segments_computed;
  std::optional<std::size_t> limit;
  for (CellIndex at = start.place.vertex; at != kNoCell;) {
    const Stretch& stretch = forest_.visit(at);
    length += stretch.count;
    if (stretch.is_last()) {
      const auto [known, is_new] = limit_of_.try_emplace(at);
      if (is_new) known->second = record_of(stretch.end);
      limit = known->second;
    }
    at = stretch.next;
  }
  statistics.n_u2.add(length);
  ++(!limit                                        ? statistics.to_infinity
     : all_.stationary.index(*limit).is_critical() ? statistics.to_critical
                                                   : statistics.to_regular);
  return limit;
}

void UnstableManifolds::Parts::Worker::count(FlowStatistics& statistics) {
  forest_.count(statistics);
  if (!all_.options.share) forest_.drop();
}

std::optional<std::size_t> UnstableManifolds::Parts::Worker::limit_beyond(std::size_t record, std::size_t choice) {
  const Place place = place_of(record);
  Location start;
  if (place.kind == Place::Kind::kEdge) {
    start = flow_->end_of_edge(place.edge, choice % 2);
  } else {
    const std::vector<PolygonRef> polygons = polygons_through(faces_.diagram(), place.vertex);
    const PolygonRef polygon = polygons.at(choice % polygons.size());
    start = flow_->end_of_edge(polygon, faces_.end(polygon, 0) == place.vertex ? 1 : 0);
  }
  const std::optional<std::size_t> limit = record_of(forest_.end_from(start.place));
  if (!all_.options.share) forest_.drop();
  return limit;
}

Orbit UnstableManifolds::Parts::Worker::orbit(const Saddle& saddle, std::size_t side) {
  const PointSet& points = all_.diagram.points();
  Orbit orbit{exact_sphere(points, all_.stationary.contact(saddle.record)).center, {}, std::nullopt};
  FlowStep first;
  first.crossed = Place::on_edge(saddle.polygon);
  first.driver = {faces_.corners(saddle.polygon), 3};
  first.end = start_of(saddle, side);
  orbit.segments.push_back(recorder_.segment({first.crossed, flow_->add(orbit.start)}, first));
  recorder_.follow(first.end, orbit);
  return orbit;
}

void UnstableManifolds::Parts::compute(const Progress& progress) {
  auto worker = std::make_unique<Worker>(*this);
  const auto [first, last] = finder.range({2, 2});
  for (std::size_t record = first; record < last; ++record) saddles.push_back(worker->saddle(record));
  for (std::size_t i = 0; i < saddles.size(); ++i) {
    if (progress && i % kProgressStep == 0) progress(i, saddles.size());
    for (std::size_t side = 0; side < 2; ++side) {
      saddles[i].limits[side] = worker->follow(saddles[i], side, statistics);
      if (!options.share) worker->count(statistics);
    }
  }
  if (options.share) worker->count(statistics);
  statistics.tally = worker->tally();
  workers.give(std::move(worker));
  if (progress) progress(saddles.size(), saddles.size());
}

UnstableManifolds::UnstableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                                     UnstableOptions options, const Progress& progress)
    : parts_(std::make_unique<Parts>(diagram, stationary, options)) {
  parts_->compute(progress);
}
UnstableManifolds::~UnstableManifolds() = default;
UnstableManifolds::UnstableManifolds(UnstableManifolds&&) noexcept = default;
UnstableManifolds& UnstableManifolds::operator=(UnstableManifolds&&) noexcept = default;

std::size_t UnstableManifolds::size() const { return parts_->saddles.size(); }
std::size_t UnstableManifolds::saddle(std::size_t i) const {
  FLOWCERT_REQUIRES(i < size());
  return parts_->saddles[i].record;
}
std::optional<std::size_t> UnstableManifolds::limit(std::size_t i, std::size_t side) const {
  FLOWCERT_REQUIRES(i < size() && side < 2);
  return parts_->saddles[i].limits[side];
}
Orbit UnstableManifolds::orbit(std::size_t i, std::size_t side) const {
  FLOWCERT_REQUIRES(i < size() && side < 2);
  return parts_->with_worker([&](Parts::Worker& worker) { return worker.orbit(parts_->saddles[i], side); });
}
std::optional<std::size_t> UnstableManifolds::limit_beyond(std::size_t record, std::size_t choice) const {
  FLOWCERT_REQUIRES(parts_->stationary.index(record) == (StationaryIndex{2, 2}) ||
                    !parts_->stationary.index(record).is_critical());
  return parts_->with_worker([&](Parts::Worker& worker) { return worker.limit_beyond(record, choice); });
}
const FlowStatistics& UnstableManifolds::statistics() const { return parts_->statistics; }

}  // namespace flowcert
