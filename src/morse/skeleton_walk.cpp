// A skeleton is walked from front to front (BackwardWalk). What is recorded of it is constructed on the way.
#include "morse/skeleton_walk.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geometry/ring.h"

namespace flowcert::morse {

// Begins at the point. All sides of a critical triangle are acute and lead there.
FrontNumber SkeletonWalk::start(std::size_t record) {
  const Place place = place_of_record(source_.stationary, record);
  if (place.kind == Place::Kind::kVertex) return walk_.at_vertex(place.vertex);
  const std::array<VertexIndex, 3> corners = faces_.diagram().corners(place.edge);
  const FrontNumber front = walk_.at_center(corners, place.edge);
  if (source_.stationary.index(record).is_critical() && source_.stationary.contact(record).size() == 3) {
    for (std::size_t k = 0; k < 3; ++k) tasks_.push_back({front, facet_name(corners[k], corners[(k + 1) % 3])});
  }
  return front;
}

void SkeletonWalk::push_sides(FrontNumber front, PolygonRef polygon) {
  for (const PolygonSide& side : faces_.diagram().sides(polygon)) {
    if (side.angle == Sign::kPositive) tasks_.push_back({front, side.facet()});
  }
}

void SkeletonWalk::push_vertex(CellIndex cluster, FrontNumber front) {
  if (!visited_.insert(cluster).second) return;
  size_.has_vertex = true;
  const VertexSources sources = vertex_sources(faces_.diagram(), cluster);
  for (const FacetName edge : sources.edges) tasks_.push_back({front, edge});
  size_.has_interval = size_.has_interval || !sources.polygons.empty();
  for (const PolygonRef polygon : sources.polygons) {
    sources_of_intervals_.push_back({cluster, {polygon, faces_.diagram().end(polygon, 0) == cluster ? 0u : 1u}});
  }
}

void SkeletonWalk::push_sources(FrontNumber front) {
  const Place place = walk_.place(front);
  if (place.kind == Place::Kind::kVertex) return push_vertex(place.vertex, front);
  push_sides(front, place.edge);
}

void SkeletonWalk::follow() {
  while (!tasks_.empty()) {
    const Task task = tasks_.back();
    tasks_.pop_back();
    ++size_.segments;
    const BackwardWalk::Back back = walk_.step(task.front, task.facet);
    if (is_recorded_) record_segment(task, back);
    if (is_traced_) trace_.push_back({task, back});
    if (back.critical) {
      ends_.push_back(*back.critical);
      lengths_.push_back(walk_.depth(task.front) + 1);
    } else if (back.is_regular) {
      ++regular_backs_;
    } else {
      push_sources(back.front);
    }
  }
}

void SkeletonWalk::clear() {
  size_ = {};
  tasks_.clear();
  if (!visited_.empty()) visited_.clear();  // which takes as long as it once was large
  ends_.clear();
  lengths_.clear();
  sources_of_intervals_.clear();
  regular_backs_ = 0;
  is_recorded_ = is_traced_ = false;
  found_ = {};
  trace_.clear();
  walk_.clear();
}

void SkeletonWalk::begin(std::size_t record) {
  const FrontNumber root = start(record);
  if (tasks_.empty()) push_sources(root);
  follow();
}

// A critical triangle whose sides are Gabriel: each segment ends at the midpoint of a side. Most triangles of a scan
// are such.
bool SkeletonWalk::ends_at_sides(std::size_t record) {
  if (source_.stationary.contact(record).size() != 3 || !source_.stationary.index(record).is_critical()) return false;
  const std::array<VertexIndex, 3> corners = source_.diagram.corners(edge_of_record(source_.stationary, record));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto side = source_.gabriel.find(facet_name(corners[k], corners[(k + 1) % 3]));
    if (!side) {
      ends_.clear();
      return false;
    }
    ends_.push_back(*side);
  }
  lengths_.assign(3, 1);
  size_.segments = 3;
  return true;
}

const SkeletonSize& SkeletonWalk::walk(std::size_t record) {
  clear();
  if (!ends_at_sides(record)) begin(record);
  return size_;
}

std::vector<BackwardWalk::Step> SkeletonWalk::tie_broken_steps(std::size_t record, TieBreaking& ties) {
  clear();
  std::vector<VertexIndex> samples;
  for (const PointId name : source_.stationary.contact(record)) {
    samples.push_back(source_.diagram.named(name));
  }
  return tie_broken_walk(faces_.diagram(), walk_, start(record), samples, ties);
}

std::vector<std::uint32_t> SkeletonWalk::tie_broken_ends(std::size_t record, TieBreaking& ties) {
  std::vector<std::uint32_t> ends;
  for (const BackwardWalk::Step& step : tie_broken_steps(record, ties)) {
    if (step.back.critical) ends.push_back(*step.back.critical);
  }
  return ends;
}

std::size_t SkeletonWalk::depth() const {
  Distribution ignored;
  std::size_t depth = 0;
  flow_->count_sizes(ignored, depth);
  return depth;
}

void SkeletonWalk::record_segment(const Task& task, const BackwardWalk::Back& back) {
  BackwardSegment<>& segment = found_.segments.emplace_back();
  segment.samples = names(task.facet);
  segment.front = corner(task.front);
  if (!segment.front.at_infinity) segment.front_contact = recorder_.contact(walk_.place(task.front));
  if (back.critical) {
    segment.back_contact = {segment.samples.begin(), segment.samples.end()};
    segment.back = {exact_sphere(source_.diagram.points(), segment.samples).center};
    return;
  }
  const Place& at = walk_.place(back.front);
  const bool is_edge = at.kind == Place::Kind::kEdge;
  segment.back_kind = back.is_regular ? BackKind::kRegular : is_edge ? BackKind::kEdge : BackKind::kVertex;
  segment.back = corner(back.front);
  segment.back_contact = recorder_.contact(walk_.place(back.front));
}

FrontNumber SkeletonWalk::front_of(const Source& source) {
  if (source.cluster != kNoCell) return walk_.at_vertex(source.cluster);
  return walk_.at_infinity(direction_of(faces_.diagram(), source.at), source.at.polygon.cell);
}

// One interval may lead to a Voronoi vertex that adds segments and more intervals.
void SkeletonWalk::record_intervals() {
  while (!sources_of_intervals_.empty()) {
    const Source source = sources_of_intervals_.back();
    sources_of_intervals_.pop_back();
    const PolygonRef polygon = source.at.polygon;
    const std::size_t far = 1 - source.at.end;
    const CellIndex other = faces_.diagram().end(polygon, far);
    const Sign beyond = other == kNoCell ? Sign::kPositive : side_at(faces_.diagram(), polygon, far);
    const FrontNumber front = front_of(source);
    const bool back_is_stationary = beyond != Sign::kNegative;
    const FrontNumber back =
        back_is_stationary ? walk_.at_center(faces_.diagram().corners(polygon), polygon) : walk_.at_vertex(other);
    if (!back_is_stationary) push_vertex(other, back);
    record_sectors({polygon, far == 1 ? front : back, far == 1 ? back : front});
    found_.intervals.push_back(
        {{recorder_.contact(Place::on_edge(polygon)), corner(front), corner(back)}, back_is_stationary});
    follow();
  }
}

void SkeletonWalk::record_sectors(const Arc& arc) {
  std::vector<Arc> arcs{arc};
  while (!arcs.empty()) {
    const Arc next = arcs.back();
    arcs.pop_back();
    for (const PolygonSide& side : faces_.diagram().sides(next.polygon)) {
      if (side.angle != Sign::kPositive) continue;
      record_sector(side.facet(), sector_of(faces_, walk_, side.facet(), next), arcs);
    }
  }
}

void SkeletonWalk::record_sector(FacetName facet, const SectorParts& parts, std::vector<Arc>& arcs) {
  for (const CellIndex cluster : parts.vertices) push_vertex(cluster, walk_.at_vertex(cluster));
  arcs.insert(arcs.end(), parts.arcs.begin(), parts.arcs.end());
  std::vector<Corner<>> corners;
  for (const FrontNumber front : parts.corners) corners.push_back(corner(front));
  if (parts.has_midpoint) corners.push_back({exact_sphere(source_.diagram.points(), names(facet)).center});
  make_canonical(corners);
  found_.sectors.push_back({names(facet), std::move(corners)});
}

void SkeletonWalk::record_unbounded_facet(const UnboundedFacet& unbounded) {
  for (const RationalPoint& ray : unbounded.rays) {
    tasks_.push_back({walk_.at_infinity(ray, unbounded.hint), unbounded.facet});
  }
  for (const auto& [from, to] : unbounded.arcs) {
    const FrontNumber a = walk_.at_infinity(from, unbounded.hint), b = walk_.at_infinity(to, unbounded.hint);
    std::vector<Arc> arcs;
    const SectorParts parts = sector_at_infinity(faces_, walk_, unbounded.facet, a, b, unbounded.hint);
    record_sector(unbounded.facet, parts, arcs);
    for (const Arc& arc : arcs) record_sectors(arc);
  }
}

StableSet<> SkeletonWalk::recorded() {
  record_intervals();
  std::ranges::sort(found_.segments, {}, [](const BackwardSegment<>& x) { return std::tie(x.samples, x.front); });
  std::ranges::sort(found_.intervals, {}, [](const BackwardInterval<>& x) { return std::tie(x.polygon, x.front); });
  std::ranges::sort(found_.sectors, {}, [](const Region<>& x) { return std::tie(x.samples, x.corners); });
  StableSet<> set = std::move(found_);
  clear();
  return set;
}

StableSet<> SkeletonWalk::set(std::size_t record) {
  clear();
  is_recorded_ = true;
  begin(record);
  return recorded();
}

StableSet<> SkeletonWalk::set_of_infinity() {
  clear();
  is_recorded_ = true;
  const UnboundedFaces unbounded = unbounded_faces(faces_);
  for (const UnboundedFacet& facet : unbounded.facets) record_unbounded_facet(facet);
  for (const EdgeEnd& end : unbounded.edges) sources_of_intervals_.push_back({kNoCell, end});
  follow();
  return recorded();
}

// Only sets with intervals make anything exact.
RoundedSegments SkeletonWalk::rounded_segments(std::size_t record) {
  clear();
  is_traced_ = true;
  begin(record);
  is_recorded_ = true;
  record_intervals();
  RoundedSegments rounded = rounded_trace();
  clear();
  return rounded;
}

RoundedSegments SkeletonWalk::tie_broken_segments(std::size_t record, TieBreaking& ties) {
  trace_ = tie_broken_steps(record, ties);
  RoundedSegments rounded = rounded_trace();
  clear();
  return rounded;
}

// The flow leads from a point to one front, through one facet. So no two fronts of a walk are equal, unless both are
// one Voronoi vertex.
RoundedSegments SkeletonWalk::rounded_trace() {
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
    const std::array<PointId, 2> samples = names(task.facet);
    const std::uint32_t front = place_of(task.front);
    std::uint32_t end = 0;
    if (back.critical) {
      end = add(rounded_sphere(source_.diagram.points(), samples, 1), {samples.begin(), samples.end()});
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
void SkeletonWalk::sort_by_exact_fronts(RoundedSegments& rounded) {
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

}  // namespace flowcert::morse
