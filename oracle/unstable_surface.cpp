// How the header's promises are kept: open intervals and single points are followed, each until it is known already.
//
// An open interval of a Voronoi edge either runs along the edge, or fans out in a facet. There it fills a convex
// region, between two rays from the midpoint. Bisectors of all samples cut the region (FC-VOR-01), and its sides that
// lie on no ray are the intervals that it leaves through. A single point has its own flow segment (FC-FLOW-01).
// The search ends, because the radius of the driver grows (FC-FLOW-05).
#include "oracle/unstable_surface.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "oracle/line_intervals.h"
#include "oracle/orbit.h"

namespace oracle {

namespace {

// The coordinate of a point w with <w, u> : <w, v> for its place, where the second is not negative.
Coordinate quotient(const Rational& u, const Rational& v) {
  if (v == 0) return {u.sign(), 0};
  return {0, u / v};
}

// The line of a Voronoi edge. Its coordinate is 0 at the centre of the polygon.
struct EdgeLine {
  EdgeLine(const PointSet& set, const Places& polygon) : corners(select(set.points, polygon)) {
    const std::vector<Point> triple = {corners[0], corners[1], corners[2]};
    centre = circumcentre(triple)->center;
    normal = cross(minus(triple[1], triple[0]), minus(triple[2], triple[0]));
    contains_centre = face_dimension(corners, centre).has_value();
  }
  [[nodiscard]] Coordinate coordinate(const Corner& x) const {
    return quotient(dot(way_to(x, centre), normal), x.at_infinity ? Rational(0) : dot(normal, normal));
  }
  [[nodiscard]] Corner at(const Coordinate& x) const {
    if (x.infinite != 0) return {as_direction(scaled(normal, x.infinite)), true};
    return {moved(centre, x.value, normal), false};
  }

  std::vector<Point> corners;
  Point centre, normal;
  bool contains_centre = false;
};

// The rays from the midpoint m of two samples through their Voronoi facet, which does not contain m. Their coordinate
// grows with the angle. Each x of the facet is not nearer to a sample q than to the two: 2 <x - m, q - m> <= h(q). So
// <x - m, m - q> > 0, if h(q) < 0, and its limit at infinity is not negative.
struct FacetRays {
  FacetRays(const PointSet& set, const std::array<std::size_t, 2>& samples) {
    const Point &p0 = set.points[samples[0]], &p1 = set.points[samples[1]];
    m = midpoint(p0, p1);
    const Point axis = minus(p1, p0);
    const auto q = std::find_if(set.points.begin(), set.points.end(),
                                [&](const Point& r) { return dot(minus(r, p0), minus(r, p1)) < 0; });
    if (q == set.points.end()) throw std::logic_error("a facet that contains its midpoint is not entered");
    ahead = minus(m, *q);
    ahead = moved(ahead, -dot(ahead, axis) / dot(axis, axis), axis);
    across = cross(axis, ahead);
  }
  [[nodiscard]] Coordinate coordinate(const Corner& x) const {
    return quotient(dot(way_to(x, m), across), dot(way_to(x, m), ahead));
  }
  // The length of `across` is that of `ahead`, times that of the axis.
  [[nodiscard]] Corner direction(const Coordinate& x) const {
    if (x.infinite != 0) return {as_direction(scaled(across, x.infinite)), true};
    const Rational ratio = x.value * dot(ahead, ahead) / dot(across, across);
    return {as_direction(moved(ahead, ratio, across)), true};
  }

  Point m, ahead, across;
};

bool is_side_at_infinity(const Corner& a, const Corner& b) { return a.at_infinity && b.at_infinity; }

// The part of the facet between two rays from m, which are less than half a circle apart.
std::vector<Corner> part_of_facet(const PointSet& set, std::size_t p, const Point& m, const Corner& first,
                                  const Corner& last) {
  std::vector<Corner> part = {{m, false}, first, last};
  for (const Point& q : set.points) part = clipped(part, set.points[p], q);
  return part;
}

// Corners of a convex region, in cyclic order: by their angles around an inner point.
std::vector<Corner> around(const std::set<Corner>& corners, const Point& axis) {
  Point sum = {};
  Rational count = 0;
  for (const Corner& x : corners) {
    if (!x.at_infinity) sum = moved(sum, 1, x.position), count += 1;
  }
  Point inner = scaled(sum, 1 / count);
  for (const Corner& x : corners) {
    if (x.at_infinity) inner = moved(inner, 1, x.position);
  }
  const Point first = way_to(*corners.begin(), inner);
  const auto is_beyond = [&](const Point& w) {  // half a turn
    const int sine = dot(axis, cross(first, w)).sign();
    return sine < 0 || (sine == 0 && dot(first, w) < 0);
  };
  std::vector<Corner> ordered(corners.begin(), corners.end());
  std::sort(ordered.begin(), ordered.end(), [&](const Corner& a, const Corner& b) {
    const Point u = way_to(a, inner), v = way_to(b, inner);
    if (is_beyond(u) != is_beyond(v)) return is_beyond(v);
    return dot(axis, cross(u, v)) > 0;
  });
  return ordered;
}

// ---- The search ----

class ForwardSearch {
 public:
  explicit ForwardSearch(const PointSet& set) : set_(set), dimension_(affine_dimension(set.points)) {}

  // All that flows from the closed Voronoi facet of these samples, without their midpoint.
  void add_root(const Places& samples);
  UnstableSurface surface();

 private:
  struct Edge {
    std::vector<Interval> arrived, run;
  };
  struct Facet {
    std::vector<Interval> rays;
    std::vector<UnstableSegment> segments;
  };
  using Samples = std::array<std::size_t, 2>;  // places

  void add_point(const Point& x);
  void add_interval(const Places& polygon, const Corner& a, const Corner& b);
  void add_run(const Places& polygon, const EdgeLine& line, const Coordinate& a, const Coordinate& b);
  void add_fan(const Places& polygon, const Corner& a, const Corner& b);
  void add_run_to(const Places& polygon, const Corner& x, const FlowSegment& segment);

  void list_edge(const Places& polygon, const Edge& edge, UnstableSurface& result) const;
  void list_facet(const Samples& samples, const Facet& facet, UnstableSurface& result) const;
  void require_closed(const Places& samples, const std::vector<Corner>& part, const FacetRays& rays,
                      const Coordinate& end) const;
  [[nodiscard]] int dimension_of(const Places& contact) const { return affine_dimension(select(set_.points, contact)); }
  [[nodiscard]] Samples names(const Samples& samples) const { return {set_.names[samples[0]], set_.names[samples[1]]}; }

  const PointSet& set_;
  int dimension_;
  std::set<Point> points_, vertices_;
  std::map<Places, Edge> edges_;
  std::map<Samples, Facet> facets_;
  UnstableSheet root_;
};

// The facet is taken by quarters of the circle around its midpoint. Their corners that are no Voronoi vertices are no
// corners of the facet.
void ForwardSearch::add_root(const Places& samples) {
  const Point &p0 = set_.points[samples[0]], &p1 = set_.points[samples[1]];
  const Point m = midpoint(p0, p1), axis = minus(p1, p0);
  const Point first = axis[0] != 0 || axis[1] != 0 ? cross(axis, {0, 0, 1}) : cross(axis, {1, 0, 0});
  const Point second = cross(axis, first);
  const std::array<Point, 4> ways = {first, second, scaled(first, -1), scaled(second, -1)};
  std::set<Corner> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner from = {as_direction(ways[k]), true}, to = {as_direction(ways[(k + 1) % 4]), true};
    const std::vector<Corner> part = part_of_facet(set_, samples[0], m, from, to);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Corner &a = part[i], &b = part[(i + 1) % part.size()];
      const int dimension = a.at_infinity ? 0 : dimension_of(set_.nearest_places(a.position));
      if (dimension >= 2) add_point(a.position);
      if (dimension == 3) corners.insert(a);
      if (a == b || is_side_at_infinity(a, b)) continue;
      const Places contact = set_.nearest_places(between(a, b));
      if (dimension_of(contact) != 2) continue;
      add_interval(contact, a, b);
      if (a.at_infinity) corners.insert(a);
      if (b.at_infinity) corners.insert(b);
    }
  }
  root_ = {names({samples[0], samples[1]}), {}};
  if (dimension_ == 3) root_.corners = canonical(around(corners, axis));
}

void ForwardSearch::add_point(const Point& x) {
  if (!points_.insert(x).second) return;
  const Places contact = set_.nearest_places(x);
  const int dimension = dimension_of(contact);
  if (dimension == 3) vertices_.insert(x);
  if (dimension == 2) {
    const Coordinate at = EdgeLine(set_, contact).coordinate({x, false});
    edges_[contact].arrived.push_back({at, at, true, true});
  }
  const auto segment = flow_segment(set_, x);
  if (!segment) return;
  const Places crossed = places_of(set_, segment->crossed_contact);
  if (dimension_of(crossed) == 2) {
    add_run_to(crossed, {x, false}, *segment);
  } else {
    const Samples samples = {crossed.at(0), crossed.at(1)};
    const Corner end =
        segment->end ? Corner{*segment->end, false} : Corner{as_direction(minus(x, segment->driver)), true};
    const Coordinate ray = FacetRays(set_, samples).coordinate({x, false});
    facets_[samples].rays.push_back({ray, ray, true, true});
    facets_[samples].segments.push_back({names(samples), x, end});
  }
  if (segment->end) add_point(*segment->end);
}

// The points of an open interval of a Voronoi edge. A whole line is cut at the centre of its polygon.
void ForwardSearch::add_interval(const Places& polygon, const Corner& a, const Corner& b) {
  const EdgeLine line(set_, polygon);
  if (is_side_at_infinity(a, b)) {
    add_point(line.centre);
    add_interval(polygon, a, {line.centre, false});
    add_interval(polygon, {line.centre, false}, b);
    return;
  }
  const auto [from, to] = std::minmax({line.coordinate(a), line.coordinate(b)});
  const Interval interval = {from, to};
  std::vector<Interval>& arrived = edges_[polygon].arrived;
  if (covers(components(arrived), interval)) return;
  arrived.push_back(interval);
  if (!line.contains_centre) return add_fan(polygon, a, b);
  const Coordinate zero;
  if (from < zero && zero < to) {
    add_run(polygon, line, from, zero);
    add_run(polygon, line, zero, to);
  } else {
    add_run(polygon, line, from, to);
  }
}

// The points of the open interval run along the edge. So do all points that are farther from the centre.
void ForwardSearch::add_run(const Places& polygon, const EdgeLine& line, const Coordinate& a, const Coordinate& b) {
  const auto segment = flow_segment(set_, between(line.at(a), line.at(b)));
  add_run_to(polygon, b.infinite > 0 || Coordinate() < b ? line.at(a) : line.at(b), *segment);
}

// The open interval from x to the end of the segment, which runs along a Voronoi edge.
void ForwardSearch::add_run_to(const Places& polygon, const Corner& x, const FlowSegment& segment) {
  const EdgeLine line(set_, polygon);
  const Corner end =
      segment.end ? Corner{*segment.end, false} : Corner{as_direction(minus(segment.start, segment.driver)), true};
  const auto [from, to] = std::minmax({line.coordinate(x), line.coordinate(end)});
  edges_[polygon].run.push_back({from, to});
  if (segment.end) add_point(*segment.end);
}

// The polygon is obtuse. The rays through the interval leave the facet through the sides that lie on no ray, and
// through the corners between two of these.
void ForwardSearch::add_fan(const Places& polygon, const Corner& a, const Corner& b) {
  const Samples samples = obtuse_edge(set_, polygon);
  const FacetRays rays(set_, samples);
  const auto [from, to] = std::minmax({rays.coordinate(a), rays.coordinate(b)});
  facets_[samples].rays.push_back({from, to});
  const Corner first = rays.direction(from), last = rays.direction(to);
  const std::vector<Corner> part = part_of_facet(set_, samples[0], rays.m, first, last);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Corner &c = part[i], &d = part[(i + 1) % part.size()];
    if (!c.at_infinity && !in_line(c, rays.m, first) && !in_line(c, rays.m, last)) add_point(c.position);
    if (c == d || is_side_at_infinity(c, d) || in_line(c, rays.m, d)) continue;
    const Places contact = set_.nearest_places(between(c, d));
    if (contact != polygon) add_interval(contact, c, d);
  }
}

// ---- The parts of the set ----

// All ends of traces that are no ends of the edge belong to them, and Voronoi vertices at their ends to the set.
void ForwardSearch::list_edge(const Places& polygon, const Edge& edge, UnstableSurface& result) const {
  const EdgeLine line(set_, polygon);
  const std::vector<Interval> arrived = components(edge.arrived);
  const auto part = [&](const Interval& interval) {
    const auto [least, greatest] = std::minmax({line.at(interval.from), line.at(interval.to)});
    return EdgePart{select(set_.names, polygon), least, greatest};
  };
  const auto require_end = [&](const Coordinate& at, bool is_in) {
    if (is_in || at.infinite != 0 || vertices_.count(line.at(at).position) > 0) return;
    throw std::logic_error("a trace that is not closed");
  };
  for (const Interval& interval : arrived) {
    require_end(interval.from, interval.has_from);
    require_end(interval.to, interval.has_to);
    result.traces.push_back(part(interval));
  }
  for (const Interval& interval : open_remainder(components(edge.run), arrived)) result.runs.push_back(part(interval));
}

// A ray at the end of a sheet that does not belong to it has no point in the open facet.
void ForwardSearch::require_closed(const Places& samples, const std::vector<Corner>& part, const FacetRays& rays,
                                   const Coordinate& end) const {
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Corner &a = part[i], &b = part[(i + 1) % part.size()];
    const bool is_on_ray =
        !is_side_at_infinity(a, b) && a != b && rays.coordinate(a) == end && rays.coordinate(b) == end;
    if (is_on_ray && set_.nearest_places(between(a, b)) == samples) {
      throw std::logic_error("a sheet that is not closed");
    }
  }
}

void ForwardSearch::list_facet(const Samples& samples, const Facet& facet, UnstableSurface& result) const {
  const FacetRays rays(set_, samples);
  for (const Interval& interval : components(facet.rays)) {
    if (interval.is_point()) {
      result.segments.push_back(*std::find_if(facet.segments.begin(), facet.segments.end(), [&](const auto& segment) {
        return rays.coordinate({segment.start, false}) == interval.from;
      }));
    } else if (dimension_ < 3) {
      result.sheets.push_back({names(samples), {}});
    } else {
      const Corner first = rays.direction(interval.from), last = rays.direction(interval.to);
      const std::vector<Corner> part = part_of_facet(set_, samples[0], rays.m, first, last);
      if (!interval.has_from) require_closed({samples[0], samples[1]}, part, rays, interval.from);
      if (!interval.has_to) require_closed({samples[0], samples[1]}, part, rays, interval.to);
      result.sheets.push_back({names(samples), canonical(part)});
    }
  }
}

UnstableSurface ForwardSearch::surface() {
  UnstableSurface result;
  result.vertices.assign(vertices_.begin(), vertices_.end());
  result.sheets.push_back(root_);
  for (const auto& [polygon, edge] : edges_) list_edge(polygon, edge, result);
  for (const auto& [samples, facet] : facets_) list_facet(samples, facet, result);
  std::sort(result.traces.begin(), result.traces.end());
  std::sort(result.runs.begin(), result.runs.end());
  std::sort(result.sheets.begin(), result.sheets.end());
  std::sort(result.segments.begin(), result.segments.end());
  return result;
}

// ---- What is in the set ----

// Whether x, on the line of the ends, is between them, or is one of them and `is_closed`.
bool is_between(const Corner& from, const Corner& to, const Point& x, bool is_closed) {
  if (Corner{x, false} == from || Corner{x, false} == to) return is_closed;
  if (is_side_at_infinity(from, to)) return true;
  const Point u = way_to(from, x), v = way_to(to, x);
  return cross(u, v) == Point{} && dot(u, v) < 0;
}

// Whether x, in the plane of the region with these corners, is in it or on a side of it.
bool is_in_region(const std::vector<Corner>& corners, const Point& axis, const Point& x) {
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point u = way_to(corners[i], x), v = way_to(corners[(i + 1) % corners.size()], x);
    const int side = dot(axis, cross(u, v)).sign();
    if (side >= 0) ++left;
    if (side <= 0) ++right;
  }
  return left == corners.size() || right == corners.size();
}

}  // namespace

UnstableSurface unstable_surface(const PointSet& set, const StationaryPoint& y) {
  if (y.face_dimension != 1) throw std::invalid_argument("only points of index 1, 1-2 and 1-3 have sheets");
  ForwardSearch search(set);
  search.add_root(face_of(set, y));
  return search.surface();
}

bool contains(const PointSet& set, const UnstableSurface& surface, const Point& x) {
  const std::vector<std::size_t> contact = contact_set(set, x);
  const std::vector<Point> samples = select(set.points, places_of(set, contact));
  const int dimension = affine_dimension(samples);
  const auto is_part_with_x = [&](bool is_closed) {
    return [&, is_closed](const EdgePart& part) {
      return part.polygon == contact && is_between(part.from, part.to, x, is_closed);
    };
  };
  if (dimension == 3) return std::binary_search(surface.vertices.begin(), surface.vertices.end(), x);
  if (dimension == 2) {
    return std::any_of(surface.traces.begin(), surface.traces.end(), is_part_with_x(true)) ||
           std::any_of(surface.runs.begin(), surface.runs.end(), is_part_with_x(false));
  }
  if (dimension < 1) return false;
  const auto is_there = [&](const auto& part) { return part.samples == std::array{contact[0], contact[1]}; };
  const Point axis = minus(samples[1], samples[0]);
  return std::any_of(surface.sheets.begin(), surface.sheets.end(),
                     [&](const UnstableSheet& s) { return is_there(s) && is_in_region(s.corners, axis, x); }) ||
         std::any_of(surface.segments.begin(), surface.segments.end(), [&](const UnstableSegment& s) {
           return is_there(s) && is_between({s.start, false}, s.end, x, false);
         });
}

}  // namespace oracle
