// How the header's promises are kept: a search against the flow finds what flows into each place.
//
// The search ends, because d decreases along each way back and there are finitely many faces. It finds no point twice,
// because a point has only one orbit, and is found only from the place where that orbit goes on. For infinity it begins
// with what goes on for ever: an edge or a polygon K with its centre c leads to infinity in the direction r if the
// points c + t r have contact set K for all large t (FC-STAB-08). These are found by trying all pairs and triples.
#include "oracle/stable_set.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/orbit.h"

namespace oracle {

namespace {

// A face K of a Delaunay polytope, by its places, with its centre c. K is an edge, or a polygon that contains c.
struct Lead {
  Places face;
  Point centre;

  [[nodiscard]] bool is_edge() const { return face.size() == 2; }
};

// The face K whose first points are these two or three, if it leads to y (FC-STAB-03). `contact` is C(y). All of C(y)
// lies on a sphere, so the other points of K, in the plane of the first three, lie on their circle.
std::optional<Lead> lead_from(const PointSet& set, const Point& y, const Places& contact, const Places& first_points) {
  const Point centre = circumcentre(select(set.points, first_points))->center;
  if (centre == y) return std::nullopt;
  const Lead lead{crossed_places(set, contact, minus(centre, y)), centre};
  const std::vector<Point> face = select(set.points, lead.face);
  const bool begins_so = spanning_subset(face) == select(set.points, first_points);
  return begins_so && face_dimension(face, centre) ? std::optional(lead) : std::nullopt;
}

// All faces that lead to y. No three points of a sphere lie on a line, so all pairs and triples have a centre.
std::vector<Lead> leads_to(const PointSet& set, const Point& y) {
  std::vector<Lead> leads;
  const Places contact = set.nearest_places(y);
  for_each_subset(contact.size(), 3, [&](const Places& subset) {
    if (subset.size() < 2) return;
    if (const auto lead = lead_from(set, y, contact, select(contact, subset))) leads.push_back(*lead);
  });
  return leads;
}

// The end of the way back from y. The way goes to the centre c, or to where its points no longer have contact set K.
Point way_back(const PointSet& set, const Point& y, const Lead& lead) {
  const Point way = minus(lead.centre, y);
  const auto meeting = set.first_meeting(lead.face.front(), y, way);
  return meeting && *meeting < 1 ? moved(y, *meeting, way) : lead.centre;
}

// The end of the way back from the end at infinity of the ray c + t r. A sample q outside of K is as near as those of K
// where 2 t <r, q - c> = |q - c|^2 - |p - c|^2. Behind the greatest such t, all of them are farther.
Point way_back_from_infinity(const PointSet& set, const Point& r, const Lead& lead) {
  const Rational radius = squared_distance(set.points[lead.face.front()], lead.centre);
  Rational time = 0;
  for (const Point& q : set.points) {
    const Rational height = dot(r, minus(q, lead.centre));
    if (height < 0) time = std::max(time, Rational((squared_distance(q, lead.centre) - radius) / (2 * height)));
  }
  return moved(lead.centre, time, r);
}

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

// It begins with what its caller adds. Each function adds what its name says, and all that flows into it (FC-STAB-03
// to 05).
class BackwardSearch {
 public:
  explicit BackwardSearch(const PointSet& set) : set_(set) {}

  void add_point(const Point& y);

  // The open segment or interval that flows straight away from the centre of a face, to `front`. The face leads there.
  void add_way(const Corner& front, const Lead& lead);

  // What flows straight away from the midpoint of an edge to the side between the two corners, in the edge's facet.
  void add_sector(const Corner& front, const Corner& back, const Lead& edge);

  // Where the search for infinity begins.
  void add_edge_to_infinity(const Places& edge);
  void add_polygon_to_infinity(const Places& first_points);

  // All that was found.
  StableSet sorted() &&;

 private:
  [[nodiscard]] std::array<std::size_t, 2> samples_of(const Lead& edge) const {
    return {set_.names[edge.face[0]], set_.names[edge.face[1]]};
  }
  [[nodiscard]] int dimension_at(const Point& x) const {
    return affine_dimension(select(set_.points, set_.nearest_places(x)));
  }
  void add_segment(const Corner& front, const Point& back, const Lead& edge);
  void add_sectors_at(const EdgePart& interval);

  const PointSet& set_;
  StableSet found_;
};

void BackwardSearch::add_point(const Point& y) {
  found_.points.push_back({y, contact_set(set_, y)});
  found_.has_vertex = found_.has_vertex || dimension_at(y) == 3;
  for (const Lead& lead : leads_to(set_, y)) add_way(y, lead);
}

void BackwardSearch::add_way(const Corner& front, const Lead& lead) {
  const Point back =
      front.at_infinity ? way_back_from_infinity(set_, front.position, lead) : way_back(set_, front.position, lead);
  if (lead.is_edge()) {
    add_segment(front, back, lead);
  } else {
    const EdgePart interval = {select(set_.names, lead.face), front, back};
    found_.intervals.push_back(interval);
    add_sectors_at(interval);
  }
  if (back != lead.centre) add_point(back);
}

// FC-STAB-04
void BackwardSearch::add_segment(const Corner& front, const Point& back, const Lead& edge) {
  const int dimension = dimension_at(back);
  BackKind kind = dimension == 2 ? BackKind::kEdge : BackKind::kVertex;
  if (back == edge.centre) kind = dimension == 1 ? BackKind::kCritical : BackKind::kRegular;
  const auto front_contact = front.at_infinity ? std::vector<std::size_t>{} : contact_set(set_, front.position);
  found_.segments.push_back({{samples_of(edge), front, back}, front_contact, contact_set(set_, back), kind});
}

// FC-STAB-05. A face that leads to one point of the interval leads to all. The search may also find the polygon itself,
// which leads along the interval.
void BackwardSearch::add_sectors_at(const EdgePart& interval) {
  for (const Lead& lead : leads_to(set_, between(interval.front, interval.back))) {
    if (lead.is_edge()) add_sector(interval.front, interval.back, lead);
  }
}

// The sector is the part of the triangle of the side and the midpoint m that is in the facet. Its rays leave the facet
// through sides that lie on no ray, and through corners between two such sides. The first and the last ray are not in
// the sector. Any part of them that flows there is a segment or an interval of its own.
void BackwardSearch::add_sector(const Corner& front, const Corner& back, const Lead& edge) {
  const Point& m = edge.centre;
  const std::vector<Corner> corners = in_cell(set_, edge.face[0], {front, back, m});
  found_.sectors.push_back({samples_of(edge), canonical(corners)});
  for (const auto& [a, b] : sides_of(corners)) {
    if (!in_line(a, m, front) && !in_line(a, m, back)) add_point(a.position);
    const auto ends = std::minmax({a, b});
    if (in_line(a, m, b) || ends == std::minmax({front, back})) continue;
    const EdgePart crossed = {contact_set(set_, between(a, b)), ends.first, ends.second};
    found_.crossed.push_back(crossed);
    add_sectors_at(crossed);
  }
}

// An edge leads along single rays, and to all of the directions between two of them.
void BackwardSearch::add_edge_to_infinity(const Places& edge) {
  const Point &p0 = set_.points[edge[0]], &p1 = set_.points[edge[1]];
  const Lead lead = {edge, midpoint(p0, p1)};
  const Directions unbounded = free_directions(set_.points, p0, p1);
  for (const Direction& r : unbounded.single) {
    if (far_contact(set_, lead.centre, r) == edge) add_way({r, true}, lead);
  }
  for (const auto& [a, b] : unbounded.arcs) {
    if (far_contact(set_, lead.centre, moved(a, 1, b)) == edge) add_sector({a, true}, {b, true}, lead);
  }
}

// The polygon whose first three samples these are leads along its axis, if it contains its centre. No sample is beyond
// its plane.
void BackwardSearch::add_polygon_to_infinity(const Places& first_points) {
  const std::vector<Point> corners = select(set_.points, first_points);
  const Point normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  if (normal == Point{}) return;
  for (const int sign : {-1, 1}) {
    const Direction r = as_direction(scaled(normal, sign));
    const auto is_beyond = [&](const Point& q) { return dot(r, minus(q, corners[0])) > 0; };
    if (std::any_of(set_.points.begin(), set_.points.end(), is_beyond)) continue;
    const Point centre = circumcentre(corners)->center;
    const Places contact = far_contact(set_, centre, r);
    const std::vector<Point> polygon = select(set_.points, contact);
    if (spanning_subset(polygon) != corners || !face_dimension(polygon, centre)) continue;
    add_way({r, true}, {contact, centre});
  }
}

StableSet BackwardSearch::sorted() && {
  std::sort(found_.points.begin(), found_.points.end());
  std::sort(found_.segments.begin(), found_.segments.end());
  std::sort(found_.intervals.begin(), found_.intervals.end());
  std::sort(found_.crossed.begin(), found_.crossed.end());
  std::sort(found_.sectors.begin(), found_.sectors.end());
  return std::move(found_);
}

}  // namespace

StableSet stable_set(const PointSet& set, const Point& y) {
  BackwardSearch search(set);
  search.add_point(y);
  return std::move(search).sorted();
}

StableSet stable_set_of_infinity(const PointSet& set) {
  BackwardSearch search(set);
  for_each_subset(set.points.size(), 3, [&](const Places& subset) {
    if (subset.size() == 2) search.add_edge_to_infinity(subset);
    if (subset.size() == 3) search.add_polygon_to_infinity(subset);
  });
  return std::move(search).sorted();
}

}  // namespace oracle
