// Orbits are followed in the forest of Voronoi vertices (SuccessorForest); their points are made again when an orbit
// is asked for.
#include "flowcert/unstable_manifolds.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "flow/segment_record.h"
#include "flow/successor_forest.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::size_t kProgressStep = 256;

}  // namespace

struct UnstableManifolds::Parts {
  Parts(const VoronoiDiagram& diagram, const StationaryPoints& list, UnstableOptions how)
      : points(diagram.points()),
        stationary(list),
        finder(list),
        options(how),
        faces(diagram),
        flow(make_flow_operator(faces, how.flow)),
        recorder(points, faces.diagram(), *flow),
        forest(faces.diagram(), *flow, how.share, statistics) {}

  void compute(const Progress& progress);
  void find_saddles();
  std::optional<std::size_t> follow(std::size_t i, std::size_t side);
  std::optional<std::size_t> record_of(const std::optional<ForestEnd>& end) const;
  std::optional<std::size_t> limit_beyond(std::size_t record, std::size_t choice);
  Orbit orbit(std::size_t i, std::size_t side);

  const PointSet& points;
  const StationaryPoints& stationary;
  RecordFinder finder;
  UnstableOptions options;
  VoronoiFaces faces;
  std::unique_ptr<FlowOperator> flow;
  SegmentRecorder recorder;

  struct Saddle {
    std::size_t record;
    PolygonRef polygon;
    bool is_reversed;  // side 0 of the manifold is end 1 of the Voronoi edge
    std::array<std::optional<std::size_t>, 2> limits;
  };
  std::vector<Saddle> saddles;
  FlowStatistics statistics;
  SuccessorForest forest;
  std::mutex flowing;  // flowing once more changes the forest and the operator's points

  Place place_of(std::size_t record);
  [[nodiscard]] bool is_reversed(const Place& place, std::span<const VertexIndex> contact) const;
  [[nodiscard]] Location start_of(const Saddle& saddle, std::size_t side) {
    return flow->end_of_edge(saddle.polygon, saddle.is_reversed ? 1 - side : side);
  }

  std::vector<VertexIndex> vertex_of;
  std::vector<VertexIndex> contact;
  // By the last Voronoi vertex of an orbit.
  std::unordered_map<CellIndex, std::optional<std::size_t>> limit_of;
};

// Whether the contact points a, b, c, in the order of their names, turn the other way than the polygon's
// corners.
bool UnstableManifolds::Parts::is_reversed(const Place& place, std::span<const VertexIndex> contact) const {
  const auto corners = faces.corners(place.edge);
  if (contact.size() == 3) {
    const auto at = std::find(corners.begin(), corners.end(), contact[0]) - corners.begin();
    return corners[static_cast<std::size_t>(at + 1) % 3] != contact[1];
  }
  const auto normal = [this](VertexIndex a, VertexIndex b, VertexIndex c) {
    const auto vector = [this](VertexIndex from, VertexIndex to) {
      const Point &p = faces.point(from), &q = faces.point(to);
      return Vector3<Rational>{Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y),
                               Rational(q.z) - Rational(p.z)};
    };
    return cross(vector(a, b), vector(a, c));
  };
  return dot(normal(corners[0], corners[1], corners[2]), normal(contact[0], contact[1], contact[2])) < 0;
}

// Sets `contact` to the vertices of the record's contact set, in the order of their names.
Place UnstableManifolds::Parts::place_of(std::size_t record) {
  contact.clear();
  for (const PointId name : stationary.contact(record)) {
    contact.push_back(vertex_of[points.ordinal_of_row(name)]);
  }
  return faces.place_of(contact.front(), std::span(contact).subspan(1));
}

void UnstableManifolds::Parts::find_saddles() {
  vertex_of = vertices_by_ordinal(faces.delaunay());
  const auto [first, last] = finder.range({2, 2});
  for (std::size_t record = first; record < last; ++record) {
    const Place place = place_of(record);
    saddles.push_back({record, place.edge, is_reversed(place, contact), {}});
  }
}

std::optional<std::size_t> UnstableManifolds::Parts::record_of(const std::optional<ForestEnd>& end) const {
  return end ? finder.find(end->index, recorder.contact(end->place)) : std::nullopt;
}

// Follows one orbit, from stretch to stretch, and returns what it ends at.
std::optional<std::size_t> UnstableManifolds::Parts::follow(std::size_t i, std::size_t side) {
  const Location start = start_of(saddles[i], side);
  std::size_t length = 1;
  ++statistics.census[{'E', 'E', letter(start.place.kind)}];
  ++statistics.segments_computed;
  std::optional<std::size_t> limit;
  for (CellIndex at = start.place.vertex; at != kNoCell;) {
    const Stretch& stretch = forest.visit(at);
    length += stretch.count;
    if (stretch.is_last()) {
      const auto [known, is_new] = limit_of.try_emplace(at);
      if (is_new) known->second = record_of(stretch.end);
      limit = known->second;
    }
    at = stretch.next;
  }
  statistics.n_u2.add(length);
  ++(!limit                                   ? statistics.to_infinity
     : stationary.index(*limit).is_critical() ? statistics.to_critical
                                              : statistics.to_regular);
  return limit;
}

std::optional<std::size_t> UnstableManifolds::Parts::limit_beyond(std::size_t record, std::size_t choice) {
  const Place place = place_of(record);
  if (place.kind == Place::Kind::kEdge)
    return record_of(forest.end_from(flow->end_of_edge(place.edge, choice % 2).place));
  const std::vector<PolygonRef> polygons = polygons_through(faces.diagram(), place.vertex);
  const PolygonRef polygon = polygons.at(choice % polygons.size());
  const std::size_t side = faces.end(polygon, 0) == place.vertex ? 1 : 0;
  return record_of(forest.end_from(flow->end_of_edge(polygon, side).place));
}

void UnstableManifolds::Parts::compute(const Progress& progress) {
  find_saddles();
  for (std::size_t i = 0; i < saddles.size(); ++i) {
    if (progress && i % kProgressStep == 0) progress(i, saddles.size());
    for (std::size_t side = 0; side < 2; ++side) {
      saddles[i].limits[side] = follow(i, side);
      if (options.share) continue;
      forest.count();
      forest.drop();
    }
  }
  if (options.share) forest.count();
  statistics.tally = flow->tally();
  if (progress) progress(saddles.size(), saddles.size());
}

Orbit UnstableManifolds::Parts::orbit(std::size_t i, std::size_t side) {
  const Saddle& saddle = saddles[i];
  Orbit orbit{exact_sphere(points, stationary.contact(saddle.record)).center, {}, std::nullopt};

  FlowStep first;
  first.crossed = Place::on_edge(saddle.polygon);
  first.driver = {faces.corners(saddle.polygon), 3};
  first.end = start_of(saddle, side);
  orbit.segments.push_back(recorder.segment({first.crossed, flow->add(orbit.start)}, first));

  for (Location at = first.end; at.place.kind != Place::Kind::kInfinity;) {
    const FlowStep step = flow->step(at);
    if (step.stationary) {
      orbit.limit = recorder.limit(at, *step.stationary);
      break;
    }
    orbit.segments.push_back(recorder.segment(at, step));
    at = step.end;
  }
  flow->drop_from(0);
  return orbit;
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
std::size_t UnstableManifolds::saddle(std::size_t i) const { return parts_->saddles[i].record; }
std::optional<std::size_t> UnstableManifolds::limit(std::size_t i, std::size_t side) const {
  FLOWCERT_REQUIRES(i < size() && side < 2);
  return parts_->saddles[i].limits[side];
}
Orbit UnstableManifolds::orbit(std::size_t i, std::size_t side) const {
  FLOWCERT_REQUIRES(i < size() && side < 2);
  require_ieee_doubles();
  const std::scoped_lock lock(parts_->flowing);
  return parts_->orbit(i, side);
}
std::optional<std::size_t> UnstableManifolds::limit_beyond(std::size_t record, std::size_t choice) const {
  FLOWCERT_REQUIRES(parts_->stationary.index(record) == (StationaryIndex{2, 2}) ||
                    !parts_->stationary.index(record).is_critical());
  require_ieee_doubles();
  const std::scoped_lock lock(parts_->flowing);
  return parts_->limit_beyond(record, choice);
}
const FlowStatistics& UnstableManifolds::statistics() const { return parts_->statistics; }

}  // namespace flowcert
