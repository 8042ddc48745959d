// Where the search for infinity begins (FC-STAB-08), and the cones over its unbounded pieces.
//
// An edge or a polygon K with its centre c leads to infinity in the direction r if the points c + t r have contact set
// K for all large t. These are found by trying all pairs and triples of samples.
#include "oracle/infinity_set.h"

#include <algorithm>
#include <span>

#include "oracle/backward_search.h"
#include "oracle/stable_pieces.h"

namespace oracle {

namespace {

const Point& sample(const PointSet& set, std::size_t name) { return set.points[places_of(set, {name}).front()]; }

Point opposite(const Point& x) { return {-x[0], -x[1], -x[2]}; }

// The contact set of c + t r for all large t: |c + t r - q|^2 is t^2 |r|^2 - 2 t <r, q - c> + |q - c|^2.
Places far_contact(const PointSet& set, const Point& c, const Point& r) {
  Places nearest;
  std::pair<Rational, Rational> least;
  for (std::size_t place = 0; place < set.points.size(); ++place) {
    const Point& q = set.points[place];
    const std::pair<Rational, Rational> key(-dot(r, q), squared_distance(q, c));
    if (!nearest.empty() && key > least) continue;
    if (key < least) nearest.clear();
    nearest.push_back(place);
    least = key;
  }
  return nearest;
}

// The directions in which the closed Voronoi facet of two samples goes on for ever. They are a cone, which is cut here
// into pieces less than half a circle wide.
struct Recession {
  std::vector<Direction> rays;                           // single directions, and the ends of all pieces
  std::vector<std::pair<Direction, Direction>> between;  // pieces
};

// These directions u are orthogonal to the edge, and no sample is farther along u than those of the edge. If they are
// not the whole plane, an end of them is orthogonal to some sample, too.
Recession recession(const PointSet& set, const Point& p0, const Point& p1) {
  const auto is_free = [&](const Point& u) {
    return std::all_of(set.points.begin(), set.points.end(), [&](const Point& q) { return dot(u, minus(q, p0)) <= 0; });
  };
  const Point axis = minus(p1, p0);
  std::vector<Direction> ends;
  Point normal;  // of a plane with the edge and a further sample
  for (const Point& q : set.points) {
    const Point across = cross(axis, minus(q, p0));
    if (across == Point{}) continue;
    normal = across;
    for (const Point& u : {as_direction(across), as_direction(opposite(across))}) {
      if (is_free(u) && std::find(ends.begin(), ends.end(), u) == ends.end()) ends.push_back(u);
    }
  }
  const auto turned = [&](const Point& u) { return as_direction(cross(axis, u)); };
  if (normal == Point{}) {
    const Point first = as_direction(axis[0] != 0 || axis[1] != 0 ? cross(axis, {0, 0, 1}) : cross(axis, {1, 0, 0}));
    const Point second = turned(first), third = opposite(first), fourth = opposite(second);
    return {{first, second, third, fourth}, {{first, second}, {second, third}, {third, fourth}, {fourth, first}}};
  }
  if (ends.size() < 2) return {ends, {}};
  if (ends[0] != opposite(ends[1])) return {ends, {{ends[0], ends[1]}}};
  for (const Point& out : {turned(ends[0]), turned(ends[1])}) {
    if (is_free(out)) return {{ends[0], out, ends[1]}, {{ends[0], out}, {out, ends[1]}}};
  }
  return {ends, {}};
}

// An edge leads along single rays, and to all of the directions between two of them.
void add_edge(const PointSet& set, const Places& edge, BackwardSearch& search) {
  const Point &p0 = set.points[edge[0]], &p1 = set.points[edge[1]];
  const Lead lead = {edge, moved(p0, Rational(1, 2), minus(p1, p0))};
  const Recession found = recession(set, p0, p1);
  for (const Direction& r : found.rays) {
    if (far_contact(set, lead.centre, r) == edge) search.add_way({r, true}, lead);
  }
  for (const auto& [a, b] : found.between) {
    if (far_contact(set, lead.centre, moved(a, 1, b)) == edge) search.add_sector({a, true}, {b, true}, lead);
  }
}

// The polygon whose first three samples these are leads along its axis, if it contains its centre. No sample is beyond
// its plane.
void add_polygon(const PointSet& set, const Places& triple, BackwardSearch& search) {
  const std::vector<Point> corners = select(set.points, triple);
  const Point normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  if (normal == Point{}) return;
  for (const Point& r : {as_direction(normal), as_direction(opposite(normal))}) {
    const auto is_beyond = [&](const Point& q) { return dot(r, minus(q, corners[0])) > 0; };
    if (std::any_of(set.points.begin(), set.points.end(), is_beyond)) continue;
    const Point centre = circumcentre(corners)->center;
    const Places contact = far_contact(set, centre, r);
    const std::vector<Point> polygon = select(set.points, contact);
    if (spanning_subset(polygon) != corners || !face_dimension(polygon, centre)) continue;
    search.add_way({r, true}, {contact, centre});
  }
}

// Whether x is on a segment from the apex to a point of the open ray. The segment does not contain the apex.
bool in_cone_over_ray(const Point& apex, const Point& back, const Direction& front, const Point& x) {
  const auto weights = barycentric({back, moved(apex, 1, front), apex}, x);  // x = apex + w0 (back - apex) + w1 front
  return weights && (*weights)[0] > 0 && (*weights)[0] <= 1 && (*weights)[1] > 0;
}

// Whether x is on such a segment for one of these apexes, which are samples, that is nearest to x. `nearest` is C(x),
// by names.
bool in_some_cone_over_ray(const PointSet& set, const std::vector<std::size_t>& nearest,
                           std::span<const std::size_t> apexes, const Point& back, const Direction& front,
                           const Point& x) {
  return std::any_of(apexes.begin(), apexes.end(), [&](std::size_t p) {
    return std::binary_search(nearest.begin(), nearest.end(), p) && in_cone_over_ray(sample(set, p), back, front, x);
  });
}

bool in_cone_with_apex(const PointSet& set, const UnboundedSector& sector, std::size_t from, std::size_t to,
                       const Point& x) {
  const Point &apex = sample(set, from), &other = sample(set, to);
  std::vector<Point> rays;
  rays.reserve(sector.corners.size());
  for (const Corner& c : sector.corners) rays.push_back(c.at_infinity ? c.position : minus(c.position, apex));
  return in_cone_over_sector(apex, other, rays, x);
}

// Whether the ray from the only nearest sample through x never comes to another Voronoi cell.
bool stays_in_cell(const PointSet& set, const std::vector<std::size_t>& nearest, const Point& x) {
  if (nearest.size() != 1) return false;
  const Point& p = sample(set, nearest.front());
  return x != p && std::all_of(set.points.begin(), set.points.end(),
                               [&](const Point& q) { return dot(minus(x, p), minus(q, p)) <= 0; });
}

}  // namespace

InfinitySet stable_set_of_infinity(const PointSet& set) {
  BackwardSearch search(set);
  for_each_subset(set.points.size(), 3, [&](const Places& subset) {
    if (subset.size() == 2) add_edge(set, subset, search);
    if (subset.size() == 3) add_polygon(set, subset, search);
  });
  return std::move(search).sorted();
}

bool contains(const PointSet& set, const InfinitySet& infinity, const Point& x) {
  const std::vector<std::size_t> nearest = contact_set(set, x);
  if (stays_in_cell(set, nearest, x) || contains(set, infinity.bounded, x)) return true;
  for (const UnboundedSegment& s : infinity.segments) {
    if (in_some_cone_over_ray(set, nearest, s.samples, s.back, s.front, x)) return true;
  }
  for (const UnboundedInterval& i : infinity.intervals) {
    if (in_some_cone_over_ray(set, nearest, i.polygon, i.back, i.front, x)) return true;
  }
  return std::any_of(infinity.sectors.begin(), infinity.sectors.end(), [&](const UnboundedSector& s) {
    return in_cone_with_apex(set, s, s.samples[0], s.samples[1], x) ||
           in_cone_with_apex(set, s, s.samples[1], s.samples[0], x);
  });
}

}  // namespace oracle
