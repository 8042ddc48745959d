// A segment is found from its driver, the points that stay nearest on the way from it, and the first meeting.
#include "oracle/orbit.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace oracle {

namespace {

// The segment from x in the given direction. Among the points of C(x), the crossed ones stay nearest on the way.
FlowSegment segment_along(const PointSet& set, const Point& x, const Point& driver, const Places& contact,
                          const Places& crossed, const Point& direction) {
  FlowSegment segment{x, driver, select(set.names, contact), select(set.names, crossed), std::nullopt, {}};
  if (const auto time = set.first_meeting(crossed.front(), x, direction)) {
    segment.end = moved(x, *time, direction);
    segment.end_contact = contact_set(set, *segment.end);
  }
  return segment;
}

// Nothing iff x is stationary. `contact` is C(x).
std::optional<FlowSegment> segment_from(const PointSet& set, const Point& x, const Places& contact) {
  const Point driver_of_x = driver(set, contact, x);
  if (driver_of_x == x) return std::nullopt;
  const Point direction = minus(x, driver_of_x);
  return segment_along(set, x, driver_of_x, contact, crossed_places(set, contact, direction), direction);
}

// Lets the path go on from x to its limit.
void follow(const PointSet& set, Point x, Orbit& path) {
  Places contact = set.nearest_places(x);
  while (const auto segment = segment_from(set, x, contact)) {
    path.segments.push_back(*segment);
    if (!segment->end) return;
    x = *segment->end;
    contact = places_of(set, segment->end_contact);
  }
  path.limit = stationary_point(set, x, contact);
}

}  // namespace

// |x + t u - p|^2 = |x - p|^2 + 2 t <u, x - p> + t^2 |u|^2, and the points of C(x) are equally far from x. So the
// points p with the largest <u, p> stay nearest.
Places crossed_places(const PointSet& set, const Places& contact, const Point& direction) {
  const auto height = [&](std::size_t place) { return dot(direction, set.points[place]); };
  Rational largest = height(contact.front());
  for (const std::size_t place : contact) largest = std::max(largest, height(place));
  Places crossed;
  std::copy_if(contact.begin(), contact.end(), std::back_inserter(crossed),
               [&](std::size_t place) { return height(place) == largest; });
  return crossed;
}

std::optional<FlowSegment> flow_segment(const PointSet& set, const Point& x) {
  assert(!set.points.empty());
  return segment_from(set, x, set.nearest_places(x));
}

Orbit orbit(const PointSet& set, const Point& start) {
  assert(!set.points.empty());
  Orbit path;
  follow(set, start, path);
  return path;
}

Location locate(const PointSet& set, const Point& x) {
  if (set.points.empty()) throw std::invalid_argument("without samples no point has a location");
  return {orbit(set, x).limit, contact_set(set, x)};
}

// The points of C(x) lie on a circle, so no three are on a line. All of them stay nearest along the circle's axis.
FlowSegment unstable_segment(const PointSet& set, const StationaryPoint& saddle, int side) {
  if (saddle.face_dimension != 2 || saddle.hull_dimension != 2 || side < 0 || side > 1) {
    throw std::invalid_argument("U2 has two sides, and belongs to a critical point of index 2");
  }
  const Places contact = places_of(set, saddle.contact);
  const Point ab = minus(set.points[contact[1]], set.points[contact[0]]);
  const Point ac = minus(set.points[contact[2]], set.points[contact[0]]);
  const Point direction = side == 1 ? cross(ab, ac) : cross(ac, ab);
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
