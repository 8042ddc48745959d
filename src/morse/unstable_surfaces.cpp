// Sets are walked with the flow (ForwardWalk), and then given names and coordinates.
#include "flowcert/unstable_surfaces.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "flow/segment_record.h"
#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "geometry/ring.h"
#include "morse/forward_walk.h"
#include "morse/record_finder.h"
#include "morse/surface_corners.h"

namespace flowcert {

using namespace morse;

namespace {

// A sheet keeps its sense.
void make_canonical(RoundedUnstableSurface::Part& part) {
  std::vector<std::uint32_t>& corners = part.corners;
  if (part.kind == RoundedUnstableSurface::Kind::kSheet) return begin_with_least(corners);
  if (corners.front() > corners.back()) std::ranges::reverse(corners);
}

}  // namespace

struct UnstableSurfaces::Parts {
  class Worker;

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, FlowOptions how)
      : diagram(voronoi), stationary(list), options(how) {
    for (std::size_t record = 0; record < list.size(); ++record) {
      if (list.index(record).face_dimension == 1) records.push_back(static_cast<std::uint32_t>(record));
    }
  }

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  FlowOptions options;
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
        recorder_(all.diagram, *flow_),
        walk_(faces_, *flow_),
        corners_(faces_, *flow_) {}

  [[nodiscard]] SurfaceParts parts(std::size_t record) {
    const FacetName facet = facet_of_record(all_.diagram, all_.stationary, record);
    return walk_.walk(facet, cell_of_record(all_.stationary, record));
  }
  [[nodiscard]] UnstableSurface<> surface(std::size_t record);
  [[nodiscard]] RoundedUnstableSurface rounded_surface(std::size_t record);

 private:
  using RoundedParts = std::vector<RoundedUnstableSurface::Part>;
  using Corners = std::vector<std::uint32_t>;  // by number

  [[nodiscard]] std::array<PointId, 2> names(FacetName facet) const { return all_.diagram.names(facet); }
  void add_intervals(PolygonRef polygon, const std::vector<TracePart>& parts, std::vector<EdgePart<>>& to);
  void add_rounded(const EdgeParts& edge, RoundedParts& to);
  void add_rounded(const SheetParts& sheet, bool is_root, RoundedParts& to);
  // If P does not span space: parts of which no two directions are opposite. Counterclockwise seen from v1.
  [[nodiscard]] std::vector<Corners> whole_facet(FacetName facet);

  const Parts& all_;
  VoronoiFaces faces_;
  std::unique_ptr<FlowOperator> flow_;
  SegmentRecorder recorder_;
  ForwardWalk walk_;
  SurfaceCorners corners_;
};

void UnstableSurfaces::Parts::Worker::add_intervals(PolygonRef polygon, const std::vector<TracePart>& parts,
                                                    std::vector<EdgePart<>>& to) {
  for (const TracePart& part : parts) {
    Corner<> a = corners_.exact(polygon, part.from), b = corners_.exact(polygon, part.to);
    if (b < a) std::swap(a, b);
    to.push_back({recorder_.contact(Place::on_edge(polygon)), std::move(a), std::move(b)});
  }
}

UnstableSurface<> UnstableSurfaces::Parts::Worker::surface(std::size_t record) {
  const SurfaceParts found = parts(record);
  UnstableSurface<> surface;
  for (const CellIndex cluster : found.vertices) {
    surface.vertices.push_back(flow_->exact({Place::at_vertex(cluster), kNoPoint}));
  }
  for (const EdgeParts& edge : found.edges) {
    add_intervals(edge.polygon, edge.traces, surface.traces);
    add_intervals(edge.polygon, edge.runs, surface.runs);
  }
  for (const SheetParts& sheet : found.sheets) {
    Region<>& made = surface.sheets.emplace_back(Region<>{names(sheet.facet), {}});
    for (const SurfaceEnd& end : sheet.corners) made.corners.push_back(corners_.exact(end));
    if (!made.corners.empty()) make_canonical(made.corners);
  }
  for (const SegmentParts& segment : found.segments) {
    surface.segments.push_back({names(segment.facet), corners_.exact(segment.end), {flow_->exact(segment.start)}});
  }
  const auto by_front = [](const EdgePart<>& x) { return std::tie(x.polygon, x.front); };
  std::ranges::sort(surface.vertices);
  std::ranges::sort(surface.traces, {}, by_front);
  std::ranges::sort(surface.runs, {}, by_front);
  std::ranges::sort(surface.sheets, {}, [](const Region<>& x) { return std::tie(x.samples, x.corners); });
  std::ranges::sort(surface.segments, {}, [](const Crossing<>& x) { return std::tie(x.samples, x.back); });
  return surface;
}

// ---- Rounded ----

void UnstableSurfaces::Parts::Worker::add_rounded(const EdgeParts& edge, RoundedParts& to) {
  using Kind = RoundedUnstableSurface::Kind;
  std::vector<PointId> samples = recorder_.contact(Place::on_edge(edge.polygon));
  samples.resize(3);
  const auto add = [&](Kind kind, const TracePart& part) {
    const std::uint32_t from = corners_.number(edge.polygon, part.from), end = corners_.number(edge.polygon, part.to);
    Corners corners = {from};
    if (faces_.diagram().dimension() == 2) corners.push_back(corners_.number(corners_.middle_of_line(edge.polygon)));
    if (end != from) corners.push_back(end);
    to.push_back({kind, samples, std::move(corners)});
  };
  for (const TracePart& part : edge.traces) add(Kind::kTrace, part);
  for (const TracePart& part : edge.runs) add(Kind::kRun, part);
}

// Where P spans a plane, the facet is between two lines, or beyond one of them. It is cut in two, across the lines.
std::vector<UnstableSurfaces::Parts::Worker::Corners> UnstableSurfaces::Parts::Worker::whole_facet(FacetName facet) {
  const auto at = [this](VertexIndex v) { return exact_position(faces_.diagram().point(v)); };
  const auto direction = [this](const Rational& sign, const RationalPoint& u) {
    return corners_.number(Corner<>{as_direction(sign * u), true});
  };
  const RationalPoint p0 = at(facet.v0), p1 = at(facet.v1), along = p1 - p0;
  if (faces_.diagram().dimension() == 1) {
    const std::uint32_t m = corners_.number(Corner<>{Rational(1, 2) * (p0 + p1)});
    RationalPoint u{0, along[2], -along[1]};
    if (is_zero(u)) u = {-along[2], 0, along[0]};
    const RationalPoint v = cross(along, u);
    const std::uint32_t right = direction(1, u), up = direction(1, v), left = direction(-1, u), down = direction(-1, v);
    return {{m, right, up}, {m, up, left}, {m, left, down}, {m, down, right}};
  }
  std::vector<RingPiece> lines;
  for (const RingPiece& piece : faces_.ring(facet).pieces) {
    if (piece.is_finite()) lines.push_back(piece);
  }
  const Corner<> first = corners_.middle_of_line(lines.front().polygon());
  const RationalPoint normal = cross(along, at(lines.front().apex) - p0);
  RationalPoint across = cross(along, normal);
  std::uint32_t beyond = 0;
  if (lines.size() == 1) {
    if (dot(across, at(lines.front().apex) - p0) > 0) across = -across;
    beyond = direction(1, across);
  } else {
    Corner<> second = corners_.middle_of_line(lines.back().polygon());
    across = second.position - first.position;
    beyond = corners_.number(std::move(second));
  }
  const Rational turn = dot(cross(normal, across), along) > 0 ? 1 : -1;
  const std::uint32_t near = corners_.number(first);
  return {{near, direction(turn, normal), beyond}, {near, beyond, direction(-turn, normal)}};
}

void UnstableSurfaces::Parts::Worker::add_rounded(const SheetParts& sheet, bool is_root, RoundedParts& to) {
  const std::array<PointId, 2> samples = names(sheet.facet);
  std::vector<Corners> regions(1);
  if (sheet.corners.empty()) regions = whole_facet(sheet.facet);
  for (const SurfaceEnd& end : sheet.corners) regions.front().push_back(corners_.number(end));
  // The walk goes around any sheet but its first one clockwise, seen from v1.
  const bool is_clockwise = !sheet.corners.empty() && !is_root;
  const bool is_seen_from_v0 = all_.diagram.name(sheet.facet.v0) == samples[1];
  for (Corners& corners : regions) {
    if (is_clockwise != is_seen_from_v0) std::ranges::reverse(corners);
    to.push_back({RoundedUnstableSurface::Kind::kSheet, {samples[0], samples[1]}, std::move(corners)});
  }
}

RoundedUnstableSurface UnstableSurfaces::Parts::Worker::rounded_surface(std::size_t record) {
  using Part = RoundedUnstableSurface::Part;
  const SurfaceParts found = parts(record);
  corners_.clear();
  RoundedUnstableSurface surface;
  for (const EdgeParts& edge : found.edges) add_rounded(edge, surface.parts);
  for (const SegmentParts& segment : found.segments) {
    const std::array<PointId, 2> samples = names(segment.facet);
    surface.parts.push_back({RoundedUnstableSurface::Kind::kSegment,
                             {samples[0], samples[1]},
                             {corners_.number(segment.start), corners_.number(segment.end)}});
  }
  for (const SheetParts& sheet : found.sheets) add_rounded(sheet, &sheet == found.sheets.data(), surface.parts);
  const std::vector<std::uint32_t> number = corners_.sort();
  for (Part& part : surface.parts) {
    for (std::uint32_t& corner : part.corners) corner = number[corner];
    make_canonical(part);
  }
  std::ranges::sort(surface.parts, {},
                    [](const Part& part) { return std::tie(part.kind, part.samples, part.corners); });
  surface.corners = corners_.rounded();
  return surface;
}

UnstableSurfaces::UnstableSurfaces(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                                   FlowOptions options)
    : parts_(geometry::in_ieee_doubles([&] { return std::make_unique<Parts>(diagram, stationary, options); })) {}
UnstableSurfaces::~UnstableSurfaces() = default;
UnstableSurfaces::UnstableSurfaces(UnstableSurfaces&&) noexcept = default;
UnstableSurfaces& UnstableSurfaces::operator=(UnstableSurfaces&&) noexcept = default;

std::size_t UnstableSurfaces::size() const { return parts_->records.size(); }
std::size_t UnstableSurfaces::record(std::size_t i) const {
  FLOWCERT_REQUIRES(i < parts_->records.size());
  return parts_->records[i];
}

UnstableSurface<> UnstableSurfaces::set(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) { return worker.surface(record(i)); });
}

RoundedUnstableSurface UnstableSurfaces::rounded_set(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) { return worker.rounded_surface(record(i)); });
}

UnstableSurfaceSize UnstableSurfaces::size_of(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  const auto make = [this] { return std::make_unique<Parts::Worker>(*parts_); };
  return parts_->workers.with(make, [&](Parts::Worker& worker) {
    const SurfaceParts parts = worker.parts(record(i));
    UnstableSurfaceSize size{parts.vertices.size(), 0, 0, parts.sheets.size(), parts.segments.size()};
    for (const EdgeParts& edge : parts.edges) size.traces += edge.traces.size(), size.runs += edge.runs.size();
    return size;
  });
}

}  // namespace flowcert
