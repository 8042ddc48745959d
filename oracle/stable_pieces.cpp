// A point is in the stable set iff it is in a cone over a piece. A comment above each function says why it is right.
#include "oracle/stable_pieces.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <stdexcept>

namespace oracle {

namespace {

const Point& point_of(const PointSet& set, std::size_t name) { return set.points[places_of(set, {name}).front()]; }

// Whether x is on a segment from the apex to a point between the corners. The segment does not contain the apex. The
// apex is outside of the affine hull of the corners, which are one or two.
bool in_cone(const Point& apex, const std::vector<Corner>& corners, const Point& x) {
  std::vector<Point> simplex = {apex};
  for (const Corner& corner : corners) simplex.push_back(moved(apex, 1, way_to(corner, apex)));
  const auto weights = barycentric(simplex, x);
  if (!weights) return false;
  Rational reach = 0;  // 1 between the corners
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if ((*weights)[i + 1] <= 0) return false;
    if (!corners[i].at_infinity) reach += (*weights)[i + 1];
  }
  return reach <= 1;
}

// Whether x is in such a cone with one of the apexes. A cone with apex p lies in the Voronoi cell of p. So only cones
// with apexes in C(x) can contain x. `nearest` is C(x), by names.
bool in_some_cone(const PointSet& set, const std::vector<std::size_t>& nearest, std::span<const std::size_t> apexes,
                  const std::vector<Corner>& corners, const Point& x) {
  return std::any_of(apexes.begin(), apexes.end(), [&](std::size_t p) {
    return std::binary_search(nearest.begin(), nearest.end(), p) && in_cone(point_of(set, p), corners, x);
  });
}

// Whether x is in the cone over a sector whose apex is one of its two samples: between the apex and the sector's plane,
// or on that, and the ray from the apex through x meets the sector.
bool in_cone_over_sector(const PointSet& set, const Region& sector, std::size_t from, const Point& x) {
  const Point &p0 = point_of(set, sector.samples[0]), &p1 = point_of(set, sector.samples[1]);
  const Point &apex = from == 0 ? p0 : p1, axis = minus(from == 0 ? p1 : p0, apex), way = minus(x, apex);
  const Rational height = dot(axis, way), full = dot(axis, axis);
  if (height <= 0 || 2 * height > full) return false;
  return is_in_region(sector.corners, axis, moved(apex, full / (2 * height), way), false);
}

// Whether the ray from the only nearest sample through x never comes to another Voronoi cell.
bool stays_in_cell(const PointSet& set, const Point& x) {
  const Places nearest = set.nearest_places(x);
  if (nearest.size() != 1) return false;
  const Point& p = set.points[nearest.front()];
  return x != p && std::all_of(set.points.begin(), set.points.end(),
                               [&](const Point& q) { return dot(minus(x, p), minus(q, p)) <= 0; });
}

// The corners of a convex polygon in cyclic order, from the first towards the lesser of its neighbours. b comes next
// after a if all other corners are on the left of the line from a to b.
std::vector<std::size_t> in_cyclic_order(const PointSet& set, const std::vector<std::size_t>& names) {
  const std::vector<Point> corners = select(set.points, places_of(set, names));
  const Point normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  const auto is_next = [&](std::size_t a, std::size_t b) {
    if (a == b) return false;
    for (const Point& c : corners) {
      if (dot(normal, cross(minus(corners[b], corners[a]), minus(c, corners[a]))) < 0) return false;
    }
    return true;
  };
  std::vector<std::size_t> ring = {0};
  while (ring.size() < corners.size()) {
    std::size_t next = 0;
    while (!is_next(ring.back(), next)) ++next;
    ring.push_back(next);
  }
  if (ring.back() < ring[1]) std::reverse(ring.begin() + 1, ring.end());
  return select(names, ring);
}

// Appends what replaces the side from a to b of a polygon in the final walk, without b. `front` is the front of the
// backward segment of a and b, if there is one.
void append_walk(const PointSet& set, const StableSet& stable, const Point& front, std::size_t a, std::size_t b,
                 std::vector<std::size_t>& walk) {
  const std::array<std::size_t, 2> samples = {std::min(a, b), std::max(a, b)};
  const auto segment = std::find_if(stable.segments.begin(), stable.segments.end(),
                                    [&](const BackwardSegment& s) { return s.front == front && s.samples == samples; });
  if (segment == stable.segments.end() || segment->back_kind != BackKind::kEdge) {
    walk.push_back(a);
    return;
  }
  std::vector<std::size_t> ring = in_cyclic_order(set, segment->back_contact);
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), a), ring.end());
  if (ring[1] == b) std::reverse(ring.begin() + 1, ring.end());
  for (std::size_t i = 1; i < ring.size(); ++i) {
    append_walk(set, stable, segment->back.position, ring[i - 1], ring[i], walk);
  }
}

// The volume of the two cones over a bounded sector (FC-VOL-01).
Rational term_of(const PointSet& set, const Region& sector) {
  const Point& first = sector.corners[0].position;
  Point normal;
  for (const auto& [a, b] : sides_of(sector.corners)) {
    normal = moved(normal, 1, cross(minus(a.position, first), minus(b.position, first)));
  }
  const Point axis = minus(point_of(set, sector.samples[1]), point_of(set, sector.samples[0]));
  return abs(dot(normal, axis)) / 6;
}

}  // namespace

std::vector<Triangle> triangles(const PointSet& set, const StableSet& stable) {
  if (!stable.intervals.empty()) throw std::invalid_argument("this stable set has dimension 3");
  std::vector<Triangle> result;
  for (const BackwardSegment& segment : stable.segments) {
    for (const std::size_t name : segment.samples) {
      result.push_back({point_of(set, name), segment.front.position, segment.back.position});
    }
  }
  return result;
}

std::vector<Rational> squared_areas(const PointSet& set, const StableSet& stable) {
  std::vector<Rational> squares;
  for (const BackwardSegment& segment : stable.segments) {
    for (const std::size_t name : segment.samples) {
      const Point p = point_of(set, name);
      const Point normal = cross(way_to(segment.front, p), way_to(segment.back, p));
      squares.push_back(dot(normal, normal) / 4);
    }
  }
  return squares;
}

std::vector<std::size_t> boundary_walk(const PointSet& set, const StationaryPoint& z, const StableSet& stable) {
  if (z.hull_dimension != 2 || stable.has_vertex) {
    throw std::invalid_argument("only a disc without Voronoi vertices has a boundary walk");
  }
  std::vector<std::size_t> walk;
  const std::vector<std::size_t> ring = in_cyclic_order(set, z.contact);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    append_walk(set, stable, z.center, ring[i], ring[(i + 1) % ring.size()], walk);
  }
  return walk;
}

std::vector<std::array<std::size_t, 2>> boundary_edges(const StableSet& stable) {
  if (stable.has_vertex) throw std::invalid_argument("not a disc without Voronoi vertices");
  std::map<Corner, std::set<std::size_t>> odd;  // w -> all p with side p w in an odd number of them
  for (const BackwardSegment& segment : stable.segments) {
    for (const std::size_t p : segment.samples) {
      for (const Corner* w : {&segment.front, &segment.back}) {
        if (!odd[*w].insert(p).second) odd[*w].erase(p);
      }
    }
  }
  std::vector<std::array<std::size_t, 2>> edges;
  for (const auto& [w, samples] : odd) {
    if (!samples.empty()) edges.push_back({*samples.begin(), *samples.rbegin()});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::size_t segments_without_intervals(const StationaryPoint& z, const StableSet& stable) {
  std::set<Corner> ends = {z.center};  // of chains
  std::size_t count = 0;
  for (std::size_t before = 0; before != ends.size();) {
    before = ends.size();
    count = 0;
    for (const BackwardSegment& segment : stable.segments) {
      if (ends.count(segment.front) == 0) continue;
      ends.insert(segment.back);
      ++count;
    }
  }
  return count;
}

bool has_tie(const StableSet& stable) {
  for (const BackwardSegment& segment : stable.segments) {
    if (segment.back_kind == BackKind::kRegular) return true;
  }
  return stable.has_vertex;
}

Rational volume(const PointSet& set, const StableSet& stable) {
  Rational sum = 0;
  for (const Region& sector : stable.sectors) sum += term_of(set, sector);
  return sum;
}

std::vector<Rational> shares(const PointSet& set, const StableSet& stable) {
  std::vector<Rational> result(set.points.size(), 0);
  for (const Region& sector : stable.sectors) {
    if (is_unbounded(sector)) continue;
    const Rational half = term_of(set, sector) / 2;
    for (const std::size_t p : sector.samples) result[places_of(set, {p}).front()] += half;
  }
  return result;
}

bool contains(const PointSet& set, const StableSet& stable, const Point& x) {
  const std::vector<std::size_t> nearest = contact_set(set, x);
  for (const SkeletonPoint& w : stable.points) {
    if (x == w.position || in_some_cone(set, nearest, w.contact, {w.position}, x)) return true;
  }
  for (const BackwardSegment& s : stable.segments) {
    if (in_some_cone(set, nearest, s.samples, {s.front, s.back}, x)) return true;
  }
  for (const auto* parts : {&stable.intervals, &stable.crossed}) {
    for (const EdgePart& part : *parts) {
      if (in_some_cone(set, nearest, part.polygon, {part.front, part.back}, x)) return true;
    }
  }
  return std::any_of(stable.sectors.begin(), stable.sectors.end(), [&](const Region& s) {
    return in_cone_over_sector(set, s, 0, x) || in_cone_over_sector(set, s, 1, x);
  });
}

bool flows_to_infinity(const PointSet& set, const StableSet& infinity, const Point& x) {
  return stays_in_cell(set, x) || contains(set, infinity, x);
}

}  // namespace oracle
