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
#include <tuple>
#include <utility>

#include "oracle/line_intervals.h"
#include "oracle/orbit.h"
#include "oracle/unstable_set.h"

namespace oracle {

namespace {

// The rays from the midpoint m of two samples through their Voronoi facet, which does not contain m. A ray is named by
// the corner where it meets the line through m + ahead that is orthogonal to `ahead`; this order is that of the angles.
// Each x of the facet is not nearer to a sample q than to the two: 2 <x - m, q - m> <= h(q). So <x - m, m - q> > 0, if
// h(q) < 0, and its limit at infinity is not negative.
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
  }
  [[nodiscard]] Corner through(const Corner& x) const {
    const Point way = way_to(x, m);
    const Rational part = dot(way, ahead);
    return part == 0 ? Corner(as_direction(way), true) : Corner(moved(m, dot(ahead, ahead) / part, way));
  }
  // The part of the facet between two rays.
  [[nodiscard]] std::vector<Corner> between(const PointSet& set, std::size_t sample, const Interval& rays) const {
    const auto end_of = [&](const Corner& ray) { return Corner(as_direction(way_to(ray, m)), true); };
    return in_cell(set, sample, {m, end_of(rays.from), end_of(rays.to)});
  }

  Point m, ahead;
};

bool is_side_at_infinity(const Corner& a, const Corner& b) { return a.at_infinity && b.at_infinity; }

Corner end_of(const FlowSegment& segment) {
  if (segment.end) return *segment.end;
  return {as_direction(minus(segment.start, segment.driver)), true};
}

// ---- The search ----

class ForwardSearch {
 public:
  explicit ForwardSearch(const PointSet& set) : set_(set), dimension_(affine_dimension(set.points)) {}

  // All that flows from the closed Voronoi facet of F, without y.
  void add_root(const StationaryPoint& y);
  UnstableSurface surface();

 private:
  struct Edge {
    std::vector<Interval> arrived, run;
  };
  struct Facet {
    std::vector<Interval> rays;
    std::vector<Crossing> segments;
  };
  using Samples = std::array<std::size_t, 2>;  // places

  void add_point(const Point& x);
  void add_interval(const Places& polygon, const Corner& a, const Corner& b);
  void add_run(const Places& polygon, const Corner& x, const FlowSegment& segment);
  void add_fan(const Places& polygon, const Interval& interval);

  void list_edge(const Places& polygon, const Edge& edge, UnstableSurface& result) const;
  void list_facet(const Samples& samples, const Facet& facet, UnstableSurface& result) const;
  void require_closed(const Places& samples, const std::vector<Corner>& part, const FacetRays& rays,
                      const Corner& end) const;
  [[nodiscard]] int dimension_of(const Places& contact) const { return affine_dimension(select(set_.points, contact)); }
  [[nodiscard]] Samples names(const Samples& samples) const { return {set_.names[samples[0]], set_.names[samples[1]]}; }

  const PointSet& set_;
  int dimension_;
  std::set<Point> points_, vertices_;
  std::map<Places, Edge> edges_;
  std::map<Samples, Facet> facets_;
  Region root_;
};

// The facet is taken by the arcs of the directions of y, in their order. The corners of these parts that are no Voronoi
// vertices, and no ends of unbounded Voronoi edges, are no corners of the facet.
void ForwardSearch::add_root(const StationaryPoint& y) {
  const Places face = face_of(set_, y);
  const std::vector<Point> contact_of_y = select(set_.points, places_of(set_, y.contact));
  std::vector<Corner> corners;
  const auto add_corner = [&](const Corner& x) {
    if (corners.empty() || corners.back() != x) corners.push_back(x);
  };
  for (const auto& [first, last] : free_directions(contact_of_y, set_.points[face[0]], set_.points[face[1]]).arcs) {
    const std::vector<Corner> part = in_cell(set_, face[0], {y.center, {first, true}, {last, true}});
    for (const auto& [a, b] : sides_of(part)) {
      const int dimension = a.at_infinity ? 0 : dimension_of(set_.nearest_places(a.position));
      if (dimension >= 2) add_point(a.position);
      if (dimension == 3) add_corner(a);
      if (a == b || is_side_at_infinity(a, b)) continue;
      const Places contact = set_.nearest_places(between(a, b));
      if (dimension_of(contact) != 2) continue;
      add_interval(contact, a, b);
      if (a.at_infinity) add_corner(a);
      if (b.at_infinity) add_corner(b);
    }
  }
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  root_ = {names({face[0], face[1]}), {}};
  if (dimension_ == 3) root_.corners = canonical(corners);
}

void ForwardSearch::add_point(const Point& x) {
  if (!points_.insert(x).second) return;
  const Places contact = set_.nearest_places(x);
  const int dimension = dimension_of(contact);
  if (dimension == 3) vertices_.insert(x);
  if (dimension == 2) edges_[contact].arrived.push_back({x, x, true, true});
  const auto segment = flow_segment(set_, x);
  if (!segment) return;
  const Places crossed = places_of(set_, segment->crossed_contact);
  if (dimension_of(crossed) == 2) {
    add_run(crossed, x, *segment);
  } else {
    const Samples samples = {crossed.at(0), crossed.at(1)};
    const Corner ray = FacetRays(set_, samples).through(x);
    facets_[samples].rays.push_back({ray, ray, true, true});
    facets_[samples].segments.push_back({names(samples), end_of(*segment), x});
  }
  if (segment->end) add_point(*segment->end);
}

// The points of an open interval of a Voronoi edge. One of its ends at least is finite. If the polygon contains its
// centre, they run along the edge, away from the centre. So do all points that are farther from it.
void ForwardSearch::add_interval(const Places& polygon, const Corner& a, const Corner& b) {
  const Interval interval = open_interval(a, b);
  std::vector<Interval>& arrived = edges_[polygon].arrived;
  if (covers(components(arrived), interval)) return;
  arrived.push_back(interval);
  const std::vector<Point> corners = select(set_.points, polygon);
  const Corner centre = circumcentre({corners[0], corners[1], corners[2]})->center;
  if (!face_dimension(corners, centre.position)) return add_fan(polygon, interval);
  const bool is_from_before = is_before(interval.from, centre), is_to_behind = is_before(centre, interval.to);
  const auto run = [&](const Corner& near, const Corner& far) {
    add_run(polygon, near, *flow_segment(set_, between(near, far)));
  };
  if (is_from_before) run(is_to_behind ? centre : interval.to, interval.from);
  if (is_to_behind) run(is_from_before ? centre : interval.from, interval.to);
}

// The open interval from x to the end of the segment, which runs along a Voronoi edge.
void ForwardSearch::add_run(const Places& polygon, const Corner& x, const FlowSegment& segment) {
  edges_[polygon].run.push_back(open_interval(x, end_of(segment)));
  if (segment.end) add_point(*segment.end);
}

// The polygon is obtuse. The rays through the interval leave the facet through the sides that lie on no ray, and
// through the corners between two of these.
void ForwardSearch::add_fan(const Places& polygon, const Interval& interval) {
  const Samples samples = obtuse_edge(set_, polygon);
  const FacetRays rays(set_, samples);
  const Interval fan = open_interval(rays.through(interval.from), rays.through(interval.to));
  facets_[samples].rays.push_back(fan);
  const std::vector<Corner> part = rays.between(set_, samples[0], fan);
  for (const auto& [c, d] : sides_of(part)) {
    if (!c.at_infinity && !in_line(c, rays.m, fan.from) && !in_line(c, rays.m, fan.to)) add_point(c.position);
    if (c == d || is_side_at_infinity(c, d) || in_line(c, rays.m, d)) continue;
    const Places contact = set_.nearest_places(between(c, d));
    if (contact != polygon) add_interval(contact, c, d);
  }
}

// ---- The parts of the set ----

// All ends of traces that are no ends of the edge belong to them, and Voronoi vertices at their ends to the set.
void ForwardSearch::list_edge(const Places& polygon, const Edge& edge, UnstableSurface& result) const {
  const std::vector<Interval> arrived = components(edge.arrived);
  const auto part = [&](const Interval& interval) {
    const auto [least, greatest] = std::minmax({interval.from, interval.to});
    return EdgePart{select(set_.names, polygon), least, greatest};
  };
  const auto require_end = [&](const Corner& end, bool is_in) {
    if (is_in || end.at_infinity || vertices_.count(end.position) > 0) return;
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
                                   const Corner& end) const {
  for (const auto& [a, b] : sides_of(part)) {
    const bool is_on_ray = !is_side_at_infinity(a, b) && a != b && rays.through(a) == end && rays.through(b) == end;
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
        return rays.through(segment.back) == interval.from;
      }));
    } else if (dimension_ < 3) {
      result.sheets.push_back({names(samples), {}});
    } else {
      const std::vector<Corner> part = rays.between(set_, samples[0], interval);
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
  const auto key = [](const Crossing& segment) { return std::tie(segment.samples, segment.back); };
  std::sort(result.segments.begin(), result.segments.end(),
            [&](const Crossing& a, const Crossing& b) { return key(a) < key(b); });
  return result;
}

// ---- What is in the set ----

// Whether x, on the line of the ends, is between them, or is one of them and `is_closed`.
bool is_between(const Corner& from, const Corner& to, const Point& x, bool is_closed) {
  if (from == x || to == x) return is_closed;
  if (is_side_at_infinity(from, to)) return true;
  const Point u = way_to(from, x), v = way_to(to, x);
  return cross(u, v) == Point{} && dot(u, v) < 0;
}

}  // namespace

UnstableSurface unstable_surface(const PointSet& set, const StationaryPoint& y) {
  if (y.face_dimension != 1) throw std::invalid_argument("only points of index 1, 1-2 and 1-3 have sheets");
  ForwardSearch search(set);
  search.add_root(y);
  return search.surface();
}

bool contains(const PointSet& set, const UnstableSurface& surface, const Point& x) {
  const std::vector<std::size_t> contact = contact_set(set, x);
  const std::vector<Point> samples = select(set.points, places_of(set, contact));
  const int dimension = affine_dimension(samples);
  const auto is_part_with_x = [&](bool is_closed) {
    return [&, is_closed](const EdgePart& part) {
      return part.polygon == contact && is_between(part.front, part.back, x, is_closed);
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
                     [&](const Region& s) { return is_there(s) && is_in_region(s.corners, axis, x, true); }) ||
         std::any_of(surface.segments.begin(), surface.segments.end(),
                     [&](const Crossing& s) { return is_there(s) && is_between(s.back, s.front, x, false); });
}

}  // namespace oracle
