// How the header's promises are kept.
#include "oracle/orbit.h"

#include <algorithm>

namespace oracle {

namespace {

std::vector<std::size_t> names_at(const PointSet& set, const std::vector<std::size_t>& places) {
  return select(set.names, places);
}

Point moved(const Point& x, const Rational& time, const Point& direction) {
  return {x[0] + time * direction[0], x[1] + time * direction[1], x[2] + time * direction[2]};
}

// C(x + t u) for all small t > 0. |x + t u - p|^2 = |x - p|^2 + 2 t <u, x - p> + t^2 |u|^2, so among the
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

// The first t > 0 at which a point q outside of the crossed set is as near as those inside, p being one of
// them: |x - q|^2 - |x - p|^2 = 2 t <u, q - p>. Nothing iff no point ever is.
std::optional<Rational> first_meeting(const PointSet& set, const std::vector<std::size_t>& crossed,
                                      const Point& x, const Point& direction) {
  const Point& p = set.points[crossed.front()];
  const Rational nearest = squared_distance(x, p);
  std::optional<Rational> first;
  for (std::size_t place = 0; place < set.points.size(); ++place) {
    const Point& q = set.points[place];
    const Rational approach = dot(direction, minus(q, p));
    if (approach <= 0) continue;  // q falls behind p, or keeps its lag
    const Rational time = (squared_distance(x, q) - nearest) / (2 * approach);
    if (!first || time < *first) first = time;
  }
  return first;
}

}  // namespace

// The nearest point lies in the relative interior of the simplex of some affinely independent points of C(x)
// (Caratheodory), and is the projection of x to the affine hull of that simplex: its circumcentre, as x is
// equally far from its points.
Point driver(const std::vector<Point>& contact, const Point& x) {
  std::optional<Point> nearest;
  for_each_subset(contact.size(), 4, [&](const std::vector<std::size_t>& subset) {
    const auto centre = circumcentre(select(contact, subset));
    if (!centre) return;
    const auto is_positive = [](const Rational& weight) { return weight > 0; };
    if (!std::all_of(centre->weights.begin(), centre->weights.end(), is_positive)) return;
    if (!nearest || squared_distance(x, centre->center) < squared_distance(x, *nearest))
      nearest = centre->center;
  });
  return *nearest;
}

std::optional<FlowSegment> flow_segment(const PointSet& set, const Point& x) {
  const std::vector<std::size_t> contact = nearest_places(set, x);
  FlowSegment segment;
  segment.start = x;
  segment.driver = driver(select(set.points, contact), x);
  if (segment.driver == x) return std::nullopt;
  const Point direction = minus(x, segment.driver);
  const std::vector<std::size_t> crossed = crossed_places(set, contact, direction);
  segment.start_contact = names_at(set, contact);
  segment.crossed_contact = names_at(set, crossed);
  if (const auto time = first_meeting(set, crossed, x, direction)) {
    segment.end = moved(x, *time, direction);
    segment.end_contact = contact_set(set, *segment.end);
  }
  return segment;
}

Orbit orbit(const PointSet& set, const Point& start) {
  Orbit result;
  Point x = start;
  while (auto segment = flow_segment(set, x)) {
    result.segments.push_back(*segment);
    if (!segment->end) return result;
    x = *segment->end;
  }
  const std::vector<std::size_t> places = nearest_places(set, x);
  const std::vector<Point> contact = select(set.points, places);
  result.limit = StationaryPoint{x, squared_distance(x, contact.front()), names_at(set, places),
                                 *face_dimension(contact, x), affine_dimension(contact)};
  return result;
}

char face_letter(const PointSet& set, const std::vector<std::size_t>& contact_names) {
  std::vector<Point> contact;
  for (std::size_t place = 0; place < set.points.size(); ++place) {
    if (std::binary_search(contact_names.begin(), contact_names.end(), set.names[place])) {
      contact.push_back(set.points[place]);
    }
  }
  return "CFEV"[affine_dimension(contact)];
}

}  // namespace oracle
