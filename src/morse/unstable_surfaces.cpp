// Sets are walked with the flow (ForwardWalk), and then given names and coordinates.
#include "flowcert/unstable_surfaces.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "flow/segment_record.h"
#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "geometry/rational_point.h"
#include "morse/forward_walk.h"
#include "morse/record_face.h"
#include "morse/record_facet.h"

namespace flowcert {

using namespace morse;

namespace {

auto corner_key(const SurfaceCorner& corner) { return std::tie(corner.at_infinity, corner.position); }
bool is_lesser_corner(const SurfaceCorner& a, const SurfaceCorner& b) { return corner_key(a) < corner_key(b); }

SurfaceCorner corner_at_infinity(const Vector3<Rational>& vector) {
  const Rational largest = std::max({Rational(abs(vector.x)), Rational(abs(vector.y)), Rational(abs(vector.z))});
  return {{vector.x / largest, vector.y / largest, vector.z / largest}, true};
}

bool is_lesser_interval(const UnstableInterval& a, const UnstableInterval& b) {
  if (a.polygon != b.polygon) return a.polygon < b.polygon;
  return is_lesser_corner(a.from, b.from);
}

// From the least corner towards the lesser of its neighbours, each one once.
void make_canonical(std::vector<SurfaceCorner>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  std::rotate(corners.begin(), std::ranges::min_element(corners, is_lesser_corner), corners.end());
  if (corners.size() > 2 && is_lesser_corner(corners.back(), corners[1])) {
    std::reverse(corners.begin() + 1, corners.end());
  }
}

}  // namespace

struct UnstableSurfaces::Parts {
  class Worker;

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, FlowOptions how)
      : diagram(voronoi), stationary(list), options(how), vertex_of(vertices_by_ordinal(voronoi.faces().delaunay())) {
    for (std::size_t record = 0; record < list.size(); ++record) {
      if (list.index(record).face_dimension == 1) records.push_back(static_cast<std::uint32_t>(record));
    }
  }

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  FlowOptions options;
  std::vector<VertexIndex> vertex_of;
  std::vector<std::uint32_t> records;
  WorkerPool<Worker> workers;
};

// What makes one set at a time.
class UnstableSurfaces::Parts::Worker {
 public:
  explicit Worker(const Parts& all)
      : all_(all),
        faces_(all.diagram),
        flow_(make_flow_operator(faces_, all.options)),
        recorder_(all.diagram.points(), faces_.diagram(), *flow_),
        walk_(faces_, *flow_) {}

  [[nodiscard]] SurfaceParts parts(std::size_t record) {
    const FacetName facet =
        facet_of_record(faces_.diagram(), all_.diagram.points(), all_.vertex_of, all_.stationary, record);
    return walk_.walk(facet, cell_of_record(all_.stationary, record));
  }
  [[nodiscard]] UnstableSurface surface(std::size_t record);

 private:
  [[nodiscard]] Vector3<Rational> at(VertexIndex v) const {
    const Point& p = faces_.point(v);
    return {Rational(p.x), Rational(p.y), Rational(p.z)};
  }
  [[nodiscard]] std::array<PointId, 2> names(FacetName facet) const {
    const auto name = [this](VertexIndex v) { return all_.diagram.points().name(faces_.delaunay().ordinals[v]); };
    return {std::min(name(facet.v0), name(facet.v1)), std::max(name(facet.v0), name(facet.v1))};
  }
  [[nodiscard]] SurfaceCorner corner(const SurfaceEnd& end);
  [[nodiscard]] SurfaceCorner corner(PolygonRef polygon, const TraceEnd& end);
  void add_intervals(PolygonRef polygon, const std::vector<TracePart>& parts, std::vector<UnstableInterval>& to);

  const Parts& all_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  SegmentRecorder recorder_;
  ForwardWalk walk_;
};

SurfaceCorner UnstableSurfaces::Parts::Worker::corner(const SurfaceEnd& end) {
  if (end.kind == SurfaceEnd::Kind::kPoint) return {flow_->exact(end.at)};
  const Vector3<Rational> p0 = at(end.facet.v0), p1 = at(end.facet.v1);
  if (end.kind == SurfaceEnd::Kind::kAlong) {
    return corner_at_infinity(Rational(end.sign) * cross(p1 - p0, at(end.apex) - p0));
  }
  const RationalPoint x = flow_->exact(end.at);
  return corner_at_infinity(Rational(2) * Vector3<Rational>{x[0], x[1], x[2]} - p0 - p1);
}

SurfaceCorner UnstableSurfaces::Parts::Worker::corner(PolygonRef polygon, const TraceEnd& end) {
  if (end.kind == TraceEnd::Kind::kPoint) return {flow_->exact(end.at)};
  const Location at_end = flow_->end_of_edge(polygon, end.is_end(1) ? 1 : 0);
  if (at_end.place.kind == Place::Kind::kVertex) return {flow_->exact(at_end)};
  const auto [a, b, c] = faces_.corners(polygon);
  return corner_at_infinity(Rational(end.is_end(1) ? 1 : -1) * cross(at(b) - at(a), at(c) - at(a)));
}

void UnstableSurfaces::Parts::Worker::add_intervals(PolygonRef polygon, const std::vector<TracePart>& parts,
                                                    std::vector<UnstableInterval>& to) {
  for (const TracePart& part : parts) {
    SurfaceCorner a = corner(polygon, part.from), b = corner(polygon, part.to);
    if (is_lesser_corner(b, a)) std::swap(a, b);
    to.push_back({recorder_.contact(Place::on_edge(polygon)), std::move(a), std::move(b)});
  }
}

UnstableSurface UnstableSurfaces::Parts::Worker::surface(std::size_t record) {
  const SurfaceParts found = parts(record);
  UnstableSurface surface;
  for (const CellIndex cluster : found.vertices) {
    surface.vertices.push_back(flow_->exact({Place::at_vertex(cluster), kNoPoint}));
  }
  for (const EdgeParts& edge : found.edges) {
    add_intervals(edge.polygon, edge.traces, surface.traces);
    add_intervals(edge.polygon, edge.runs, surface.runs);
  }
  for (const SheetParts& sheet : found.sheets) {
    UnstableSheet& made = surface.sheets.emplace_back(UnstableSheet{names(sheet.facet), {}});
    for (const SurfaceEnd& end : sheet.corners) made.corners.push_back(corner(end));
    if (!made.corners.empty()) make_canonical(made.corners);
  }
  for (const SegmentParts& segment : found.segments) {
    surface.segments.push_back({names(segment.facet), flow_->exact(segment.start), corner(segment.end)});
  }
  std::ranges::sort(surface.vertices);
  std::ranges::sort(surface.traces, is_lesser_interval);
  std::ranges::sort(surface.runs, is_lesser_interval);
  std::ranges::sort(surface.sheets, [](const UnstableSheet& a, const UnstableSheet& b) {
    if (a.samples != b.samples) return a.samples < b.samples;
    return std::ranges::lexicographical_compare(a.corners, b.corners, is_lesser_corner);
  });
  std::ranges::sort(surface.segments, {}, [](const UnstableSegment& s) { return std::tie(s.samples, s.start); });
  return surface;
}

UnstableSurfaces::UnstableSurfaces(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                                   FlowOptions options)
    : parts_(std::make_unique<Parts>(diagram, stationary, options)) {}
UnstableSurfaces::~UnstableSurfaces() = default;
UnstableSurfaces::UnstableSurfaces(UnstableSurfaces&&) noexcept = default;
UnstableSurfaces& UnstableSurfaces::operator=(UnstableSurfaces&&) noexcept = default;

std::size_t UnstableSurfaces::size() const { return parts_->records.size(); }
std::size_t UnstableSurfaces::record(std::size_t i) const {
  FLOWCERT_REQUIRES(i < parts_->records.size());
  return parts_->records[i];
}

UnstableSurface UnstableSurfaces::set(std::size_t i) const {
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) { return worker.surface(record(i)); });
}

UnstableSurfaceSize UnstableSurfaces::size_of(std::size_t i) const {
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) {
    const SurfaceParts parts = worker.parts(record(i));
    UnstableSurfaceSize size{parts.vertices.size(), 0, 0, parts.sheets.size(), parts.segments.size()};
    for (const EdgeParts& edge : parts.edges) size.traces += edge.traces.size(), size.runs += edge.runs.size();
    return size;
  });
}

}  // namespace flowcert
