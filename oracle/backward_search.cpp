// How the promises of skeletons are kept: a search against the flow finds what flows into each place.
//
// The search ends, because d decreases along each way back and there are finitely many faces. It finds no point
// twice, because a point has only one orbit, and is found only from the place where that orbit goes on.
#include "oracle/backward_search.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/corners.h"
#include "oracle/orbit.h"

namespace oracle {

namespace {

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

bool is_edge(const Lead& lead) { return lead.face.size() == 2; }

std::array<std::size_t, 2> samples_of(const PointSet& set, const Lead& lead) {
  return {set.names[lead.face[0]], set.names[lead.face[1]]};
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

template <typename T>
void sort_list(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
}

}  // namespace

void BackwardSearch::add_point(const Point& y) {
  found_.bounded.points.push_back({y, contact_set(set_, y)});
  found_.bounded.has_vertex = found_.bounded.has_vertex || dimension_at(y) == 3;
  for (const Lead& lead : leads_to(set_, y)) add_way({y, false}, lead);
}

void BackwardSearch::add_way(const Corner& front, const Lead& lead) {
  const Point back =
      front.at_infinity ? way_back_from_infinity(set_, front.position, lead) : way_back(set_, front.position, lead);
  is_edge(lead) ? add_segment(front, back, lead) : add_interval_into(front, back, lead);
}

InfinitySet BackwardSearch::sorted() && {
  sort_list(found_.bounded.points);
  sort_list(found_.bounded.segments);
  sort_list(found_.bounded.intervals);
  sort_list(found_.bounded.sectors);
  sort_list(found_.segments);
  sort_list(found_.intervals);
  sort_list(found_.sectors);
  return std::move(found_);
}

int BackwardSearch::dimension_at(const Point& x) const {
  return affine_dimension(select(set_.points, set_.nearest_places(x)));
}

// FC-STAB-04
void BackwardSearch::add_segment(const Corner& front, const Point& back, const Lead& lead) {
  const int dimension = dimension_at(back);
  BackKind kind = dimension == 2 ? BackKind::kEdge : BackKind::kVertex;
  if (back == lead.centre) kind = dimension == 1 ? BackKind::kCritical : BackKind::kRegular;
  const auto samples = samples_of(set_, lead);
  const std::vector<std::size_t> back_contact = contact_set(set_, back);
  if (front.at_infinity) {
    found_.segments.push_back({samples, front.position, back, back_contact, kind});
  } else {
    const std::vector<std::size_t> front_contact = contact_set(set_, front.position);
    found_.bounded.segments.push_back({samples, front.position, back, front_contact, back_contact, kind});
  }
  if (back != lead.centre) add_point(back);
}

// FC-STAB-05, with the front at a Voronoi vertex or at infinity.
void BackwardSearch::add_interval_into(const Corner& front, const Point& back, const Lead& lead) {
  const bool whole = back == lead.centre;
  const IntervalKind kind = whole ? IntervalKind::kFromCentre : IntervalKind::kFromVertex;
  add_interval({select(set_.names, lead.face), front, {back, false}, kind});
  if (!whole) add_point(back);
}

// A face that leads to one point of the interval leads to all. The search may also find the polygon itself, which
// leads along the interval.
void BackwardSearch::add_interval(const Interval& interval) {
  const auto& [polygon, front, back, kind] = interval;
  if (front.at_infinity) {
    found_.intervals.push_back({polygon, front.position, back.position, kind});
  } else {
    found_.bounded.intervals.push_back({polygon, front.position, back.position, kind});
  }
  for (const Lead& lead : leads_to(set_, between(front, back))) {
    if (is_edge(lead)) add_sector(front, back, lead);
  }
}

// The sector is the part of the triangle of the side and the midpoint m that is in the facet. Its rays leave the facet
// through sides that lie on no ray, and through corners between two such sides. The first and the last ray are not in
// the sector. Any part of them that flows there is a segment or an interval of its own.
void BackwardSearch::add_sector(const Corner& front, const Corner& back, const Lead& edge) {
  const Point& m = edge.centre;
  std::vector<Corner> sector = {front, back, {m, false}};
  for (const Point& q : set_.points) sector = clipped(sector, set_.points[edge.face[0]], q);
  const std::vector<Corner> corners = canonical(sector);
  if (front.at_infinity || back.at_infinity) {
    found_.sectors.push_back({samples_of(set_, edge), corners});
  } else {
    std::vector<Point> polygon;
    polygon.reserve(corners.size());
    for (const Corner& corner : corners) polygon.push_back(corner.position);
    found_.bounded.sectors.push_back({samples_of(set_, edge), polygon});
  }
  for (std::size_t i = 0; i < sector.size(); ++i) {
    const Corner& a = sector[i];
    const Corner& b = sector[(i + 1) % sector.size()];
    if (!in_line(a, m, front) && !in_line(a, m, back)) add_point(a.position);
    const bool is_front_side = std::minmax(a, b) == std::minmax(front, back);
    if (!is_front_side && !in_line(a, m, b)) add_crossed_interval(a, b);
  }
}

// The front is the end at infinity, if there is one, and else the lesser end.
void BackwardSearch::add_crossed_interval(const Corner& a, const Corner& b) {
  const Corner &least = std::min(a, b), &greatest = std::max(a, b);
  const std::vector<std::size_t> polygon = contact_set(set_, between(a, b));
  const bool is_unbounded = greatest.at_infinity;
  add_interval({polygon, is_unbounded ? greatest : least, is_unbounded ? least : greatest, IntervalKind::kCrossed});
}

}  // namespace oracle
