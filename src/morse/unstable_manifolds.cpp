// See flowcert/unstable_manifolds.h.
//
// The orbits are kept as a forest of stretches: from each visited Voronoi vertex to the next, or to where the
// orbit ends. A stretch keeps what it is made of and where it leads, not its points: they, with the history
// that the lazy kernel keeps of each, would take 1 GiB for 35,000 samples, and are made again when an orbit
// is asked for.
#include "flowcert/unstable_manifolds.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "flow/segment_record.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::size_t kProgressStep = 256;
constexpr std::uint32_t kNotVisited = 0xffffffffu;

using SegmentType = std::array<char, 3>;

// The flow from one Voronoi vertex to the next one, or to its end.
struct Stretch {
  std::size_t first = 0, count = 0;  // of the segment types
  CellIndex next = kNoCell;          // the Voronoi vertex reached
  std::optional<std::size_t> limit;  // where there is none: the record it ends at; nothing for infinity
  std::size_t visits = 0;            // by orbits

  [[nodiscard]] bool is_last() const { return next == kNoCell; }
};

}  // namespace

struct UnstableManifolds::Machine {
  Machine(const VoronoiDiagram& diagram, const StationaryPoints& list, UnstableOptions how)
      : points(diagram.points()),
        stationary(list),
        finder(list),
        options(how),
        faces(diagram),
        machine(make_flow_machine(faces, how.flow)),
        recorder(points, faces, *machine) {}

  void compute(const Progress& progress);
  void find_saddles();
  std::optional<std::size_t> follow(std::size_t i, std::size_t side);
  Stretch& stretch_from(CellIndex cluster);
  Stretch new_stretch(CellIndex cluster);
  std::optional<std::size_t> limit_from(const Position& start);
  std::optional<std::size_t> limit_beyond(std::size_t record, std::size_t choice);
  void count_sizes();
  void count_stretches();
  void drop_orbit();
  Orbit orbit(std::size_t i, std::size_t side);

  const PointSet& points;
  const StationaryPoints& stationary;
  RecordFinder finder;
  UnstableOptions options;
  VoronoiFaces faces;
  std::unique_ptr<FlowMachine> machine;
  SegmentRecorder recorder;

  struct Saddle {
    std::size_t record;
    PolygonRef polygon;
    bool is_reversed;  // side 0 of the manifold is end 1 of the Voronoi edge
    std::array<std::optional<std::size_t>, 2> limits;
  };
  std::vector<Saddle> saddles;
  std::vector<SegmentType> types;
  std::vector<Stretch> stretches;
  std::vector<std::uint32_t> stretch_of;  // by cluster, shared
  FlowStatistics statistics;

 private:
  Place place_of(std::size_t record);
  [[nodiscard]] bool is_reversed(const Place& place, std::span<const VertexIndex> contact) const;
  [[nodiscard]] Position start_of(const Saddle& saddle, std::size_t side) {
    return machine->end_of_edge(saddle.polygon, saddle.is_reversed ? 1 - side : side);
  }

  std::vector<VertexIndex> vertex_of;
  std::vector<VertexIndex> contact;
};

// Whether the contact points a, b, c, in the order of their names, turn the other way than the polygon's
// corners.
bool UnstableManifolds::Machine::is_reversed(const Place& place, std::span<const VertexIndex> contact) const {
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

// Sets `contact` to the vertices of its contact set, in the order of their names.
Place UnstableManifolds::Machine::place_of(std::size_t record) {
  contact.clear();
  for (const PointId name : stationary.contact(record)) {
    contact.push_back(vertex_of[points.position_of_row(name)]);
  }
  return faces.place_of(contact.front(), std::span(contact).subspan(1));
}

void UnstableManifolds::Machine::find_saddles() {
  vertex_of = vertices_by_position(faces.delaunay());
  const auto [first, last] = finder.range({2, 2});
  for (std::size_t record = first; record < last; ++record) {
    const Place place = place_of(record);
    saddles.push_back({record, place.edge, is_reversed(place, contact), {}});
  }
}

// Steps from a Voronoi vertex until the next one, or the end.
Stretch UnstableManifolds::Machine::new_stretch(CellIndex cluster) {
  Stretch stretch;
  stretch.first = types.size();
  Position at{Place::at_vertex(cluster), kNoPoint};
  do {
    const FlowStep step = machine->step(at);
    if (step.stationary) {
      stretch.limit = finder.find(*step.stationary, recorder.contact(at.place));
      break;
    }
    types.push_back(segment_type(at.place, step));
    at = step.end;
    if (at.place.kind == Place::Kind::kVertex) stretch.next = at.place.vertex;
  } while (at.place.kind == Place::Kind::kEdge);
  stretch.count = types.size() - stretch.first;
  count_sizes();
  machine->drop_from(0);
  return stretch;
}

Stretch& UnstableManifolds::Machine::stretch_from(CellIndex cluster) {
  if (stretch_of.empty()) stretch_of.assign(faces.delaunay().finite_count, kNotVisited);
  if (!options.share || stretch_of[cluster] == kNotVisited) {
    stretch_of[cluster] = static_cast<std::uint32_t>(stretches.size());
    stretches.push_back(new_stretch(cluster));
  }
  return stretches[stretch_of[cluster]];
}

// One orbit, from stretch to stretch; what it ends at.
std::optional<std::size_t> UnstableManifolds::Machine::follow(std::size_t i, std::size_t side) {
  const Position start = start_of(saddles[i], side);
  std::size_t length = 1;
  ++statistics.census[{'E', 'E', letter(start.place.kind)}];
  ++statistics.segments_computed;
  std::optional<std::size_t> limit;
  for (CellIndex at = start.place.vertex; at != kNoCell;) {
    Stretch& stretch = stretch_from(at);
    ++stretch.visits;
    length += stretch.count;
    if (stretch.is_last()) limit = stretch.limit;
    at = stretch.next;
  }
  statistics.n_u2.add(length);
  ++(!limit                                   ? statistics.to_infinity
     : stationary.index(*limit).is_critical() ? statistics.to_critical
                                              : statistics.to_regular);
  return limit;
}

// Without counting it among the orbits.
std::optional<std::size_t> UnstableManifolds::Machine::limit_from(const Position& start) {
  if (start.place.kind == Place::Kind::kInfinity) return std::nullopt;
  const Stretch* stretch = &stretch_from(start.place.vertex);
  while (!stretch->is_last()) stretch = &stretch_from(stretch->next);
  return stretch->limit;
}

std::optional<std::size_t> UnstableManifolds::Machine::limit_beyond(std::size_t record, std::size_t choice) {
  const Place place = place_of(record);
  if (place.kind == Place::Kind::kEdge) return limit_from(machine->end_of_edge(place.edge, choice % 2));
  const std::vector<PolygonRef> polygons = polygons_through(faces, place.vertex);
  const PolygonRef polygon = polygons.at(choice % polygons.size());
  return limit_from(machine->end_of_edge(polygon, faces.end(polygon, 0) == place.vertex ? 1 : 0));
}

void UnstableManifolds::Machine::count_sizes() {
  for (PointNumber point = 0; point < machine->kept(); ++point) {
    statistics.depth = std::max(statistics.depth, machine->depth(point));
    if (const auto bytes = machine->exact_bytes(point)) {
      for (const std::size_t count : *bytes) statistics.exact_bytes.add(count);
    }
  }
}

// Hands the stretches' part of the statistics over.
void UnstableManifolds::Machine::count_stretches() {
  for (const Stretch& stretch : stretches) {
    statistics.segments_computed += stretch.count;
    std::size_t constructed = 0;
    for (std::size_t k = stretch.first; k < stretch.first + stretch.count; ++k) {
      statistics.census[types[k]] += stretch.visits;
      constructed += types[k][2] == 'E' ? 1 : 0;
    }
    // From its first constructed point on, a stretch makes nothing else until it ends.
    if (constructed > 0) statistics.n_wcc.add(constructed, stretch.visits);
  }
}

void UnstableManifolds::Machine::compute(const Progress& progress) {
  find_saddles();
  for (std::size_t i = 0; i < saddles.size(); ++i) {
    if (progress && i % kProgressStep == 0) progress(i, saddles.size());
    for (std::size_t side = 0; side < 2; ++side) {
      saddles[i].limits[side] = follow(i, side);
      if (!options.share) drop_orbit();
    }
  }
  if (options.share) count_stretches();
  statistics.tally = machine->tally();
  if (progress) progress(saddles.size(), saddles.size());
}

void UnstableManifolds::Machine::drop_orbit() {
  count_stretches();
  stretches.clear();
  types.clear();
  machine->drop_all();
}

Orbit UnstableManifolds::Machine::orbit(std::size_t i, std::size_t side) {
  const Saddle& saddle = saddles[i];
  Orbit orbit{exact_sphere(points, stationary.contact(saddle.record)).center, {}, std::nullopt};

  FlowStep first;
  first.crossed = Place::on_edge(saddle.polygon);
  first.driver = {faces.corners(saddle.polygon), 3};
  first.end = start_of(saddle, side);
  orbit.segments.push_back(recorder.segment({first.crossed, machine->add(orbit.start)}, first));

  for (Position at = first.end; at.place.kind != Place::Kind::kInfinity;) {
    const FlowStep step = machine->step(at);
    if (step.stationary) {
      orbit.limit = recorder.limit(at, *step.stationary);
      break;
    }
    orbit.segments.push_back(recorder.segment(at, step));
    at = step.end;
  }
  machine->drop_from(0);
  return orbit;
}

UnstableManifolds::UnstableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                                     UnstableOptions options, const Progress& progress)
    : machine_(std::make_unique<Machine>(diagram, stationary, options)) {
  machine_->compute(progress);
}
UnstableManifolds::~UnstableManifolds() = default;
UnstableManifolds::UnstableManifolds(UnstableManifolds&&) noexcept = default;
UnstableManifolds& UnstableManifolds::operator=(UnstableManifolds&&) noexcept = default;

std::size_t UnstableManifolds::size() const { return machine_->saddles.size(); }
std::size_t UnstableManifolds::saddle(std::size_t i) const { return machine_->saddles[i].record; }
std::optional<std::size_t> UnstableManifolds::limit(std::size_t i, std::size_t side) const {
  return machine_->saddles[i].limits[side];
}
Orbit UnstableManifolds::orbit(std::size_t i, std::size_t side) { return machine_->orbit(i, side); }
std::optional<std::size_t> UnstableManifolds::limit_beyond(std::size_t record, std::size_t choice) {
  return machine_->limit_beyond(record, choice);
}
const FlowStatistics& UnstableManifolds::statistics() const { return machine_->statistics; }

}  // namespace flowcert
