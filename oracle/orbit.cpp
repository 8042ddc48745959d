// How the header's promises are kept.
#include "oracle/orbit.h"

#include <algorithm>
#include <stdexcept>

namespace oracle {

namespace {

// The same direction in integers without a common factor: the length does not matter, but that of the numbers
// does.
Point in_integers(const Point& direction) {
  Integer common = 1, factor = 0;
  for (const Rational& u : direction) common = lcm(common, Integer(denominator(u)));
  for (const Rational& u : direction) factor = gcd(factor, Integer(numerator(u * common)));
  const Rational scale = Rational(common) / Rational(factor);
  Point result = direction;
  for (Rational& u : result) u *= scale;
  return result;
}

// The first point on the way of x where a point q outside of the crossed set is as near as those inside, p
// being one of them: |x - q|^2 - |x - p|^2 = 2 t <u, q - p>, t > 0. Nothing iff no point ever is. As the lead
// of p over q changes linearly in t, q comes before the first so far iff it is nearer than p there.
std::optional<Point> first_meeting(const PointSet& set, std::size_t p, const Point& x,
                                   const Point& integer_direction) {
  const Point& u = integer_direction;
  Form advance;
  for (std::size_t axis = 0; axis < 3; ++axis) advance[axis] = numerator(u[axis]);
  const Integer advance_of_p = value(advance, set.lifted[p]);
  std::optional<Point> first;
  Form distance;  // from the first so far
  Integer distance_of_p;
  for (std::size_t q = 0; q < set.lifted.size(); ++q) {
    const bool comes_earlier =
        first ? value(distance, set.lifted[q]) < distance_of_p : value(advance, set.lifted[q]) > advance_of_p;
    if (!comes_earlier) continue;
    const Rational lead = squared_distance(x, set.points[q]) - squared_distance(x, set.points[p]);
    first = moved(x, lead / (2 * dot(u, minus(set.points[q], set.points[p]))), u);
    distance = distance_form(set, *first);
    distance_of_p = value(distance, set.lifted[p]);
  }
  return first;
}

// The segment from x in a direction in which, of the points of C(x), the crossed ones stay nearest.
FlowSegment segment_along(const PointSet& set, const Point& x, const Point& driver,
                          const std::vector<std::size_t>& contact, const std::vector<std::size_t>& crossed,
                          const Point& direction) {
  FlowSegment segment{x, driver, select(set.names, contact), select(set.names, crossed), std::nullopt, {}};
  segment.end = first_meeting(set, crossed.front(), x, direction);
  if (segment.end) segment.end_contact = contact_set(set, *segment.end);
  return segment;
}

// Nothing iff x is stationary. `contact` are the places of C(x).
std::optional<FlowSegment> segment_from(const PointSet& set, const Point& x,
                                        const std::vector<std::size_t>& contact) {
  const Point driver_of_x = driver(select(set.points, contact), x);
  if (driver_of_x == x) return std::nullopt;
  const Point direction = in_integers(minus(x, driver_of_x));
  return segment_along(set, x, driver_of_x, contact, crossed_places(set, contact, direction), direction);
}

// Lets the path go on from x to its limit.
void follow(const PointSet& set, Point x, Orbit& path) {
  std::vector<std::size_t> contact = nearest_places(set, x);
  while (auto segment = segment_from(set, x, contact)) {
    path.segments.push_back(*segment);
    if (!segment->end) return;
    x = *segment->end;
    contact = places_of(set, segment->end_contact);
  }
  const std::vector<Point> points = select(set.points, contact);
  path.limit = StationaryPoint{x, squared_distance(x, points.front()), select(set.names, contact),
                               *face_dimension(points, x), affine_dimension(points)};
}

}  // namespace

// |x + t u - p|^2 = |x - p|^2 + 2 t <u, x - p> + t^2 |u|^2, so among the
// points of C(x), equally far from x, those stay nearest for which <u, p> is largest.
std::vector<std::size_t> crossed_places(const PointSet& set, const std::vector<std::size_t>& contact,
                                        const Point& direction) {
  Rational largest = dot(direction, set.points[contact.front()]);
  for (const std::size_t place : contact) largest = std::max(largest, dot(direction, set.points[place]));
  std::vector<std::size_t> crossed;
  for (const std::size_t place : contact) {
    if (dot(direction, set.points[place]) == largest) crossed.push_back(place);
  }
  return crossed;
}

// The nearest point lies in the relative interior of the simplex of some affinely independent points of C(x)
// (Caratheodory), and is the projection of x to the affine hull of that simplex: its circumcentre, as x is
// equally far from its points.
Point driver(const std::vector<Point>& contact, const Point& x) {
  std::vector<Point> centres;
  for_each_subset(contact.size(), 4, [&](const std::vector<std::size_t>& subset) {
    const auto centre = inner_circumcentre(select(contact, subset));
    if (centre) centres.push_back(*centre);
  });
  return *std::min_element(centres.begin(), centres.end(), [&](const Point& a, const Point& b) {
    return squared_distance(x, a) < squared_distance(x, b);
  });
}

std::optional<FlowSegment> flow_segment(const PointSet& set, const Point& x) {
  return segment_from(set, x, nearest_places(set, x));
}

Orbit orbit(const PointSet& set, const Point& start) {
  Orbit path;
  follow(set, start, path);
  return path;
}

// The points of C(x) lie on a circle, so no three of them on a line. All of them stay nearest along the axis.
FlowSegment unstable_segment(const PointSet& set, const StationaryPoint& saddle, int side) {
  if (saddle.face_dimension != 2 || saddle.hull_dimension != 2 || side < 0 || side > 1) {
    throw std::invalid_argument("U2 has two sides, and belongs to a critical point of index 2");
  }
  const std::vector<std::size_t> contact = places_of(set, saddle.contact);
  const Point ab = minus(set.points[contact[1]], set.points[contact[0]]);
  const Point ac = minus(set.points[contact[2]], set.points[contact[0]]);
  const Point direction = in_integers(side == 1 ? cross(ab, ac) : cross(ac, ab));
  return segment_along(set, saddle.center, saddle.center, contact, contact, direction);
}

Orbit unstable_orbit(const PointSet& set, const StationaryPoint& saddle, int side) {
  const FlowSegment first = unstable_segment(set, saddle, side);
  Orbit path;
  path.segments.push_back(first);
  if (first.end) follow(set, *first.end, path);
  return path;
}

std::array<Orbit, 2> unstable_orbits(const PointSet& set, const StationaryPoint& saddle) {
  return {unstable_orbit(set, saddle, 0), unstable_orbit(set, saddle, 1)};
}

char face_letter(const PointSet& set, const std::vector<std::size_t>& contact_names) {
  return "CFEV"[affine_dimension(select(set.points, places_of(set, contact_names)))];
}

std::string segment_type(const PointSet& set, const FlowSegment& segment) {
  const std::string start(1, face_letter(set, segment.start_contact));
  const std::string crossed(1, face_letter(set, segment.crossed_contact));
  const std::string end = segment.end ? std::string(1, face_letter(set, segment.end_contact)) : "inf";
  return start + "-" + crossed + "-" + end;
}

}  // namespace oracle
