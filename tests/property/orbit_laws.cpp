// The laws of orbits; see orbit_laws.h for what they guarantee.
#include "tests/property/orbit_laws.h"

#include <algorithm>
#include <utility>

#include "oracle/orbit.h"
#include "tests/property/orbit_census.h"

namespace flowcert::property {
namespace {

using oracle::Point;
using oracle::PointSet;

// A point strictly between start and end.
Point middle_of(const SegmentRecord& segment) {
  Point x = segment.start;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    x[axis] += segment.end ? Rational(((*segment.end)[axis] - x[axis]) / 2) : Rational(x[axis] - segment.driver[axis]);
  }
  return x;
}

// All between start and end have the crossed contact set if one has it, and if both ends' sets contain it.
std::string broken_contact(const PointSet& set, const SegmentRecord& segment) {
  const auto has_crossed = [&segment](const std::vector<std::size_t>& contact) {
    return std::includes(contact.begin(), contact.end(), segment.crossed_contact.begin(),
                         segment.crossed_contact.end());
  };
  if (oracle::contact_set(set, segment.start) != segment.start_contact || !has_crossed(segment.start_contact)) {
    return "FC-FLOW-01: wrong contact set at the start";
  }
  if (oracle::contact_set(set, middle_of(segment)) != segment.crossed_contact) {
    return "FC-FLOW-01: wrong contact set on the way";
  }
  if (!segment.end) {
    return segment.end_contact.empty() ? "" : "FC-FLOW-01: a contact set at infinity";
  }
  return oracle::contact_set(set, *segment.end) == segment.end_contact && has_crossed(segment.end_contact) &&
                 segment.end_contact != segment.crossed_contact
             ? ""
             : "FC-FLOW-01: wrong contact set at the end";
}

std::string broken_type(const PointSet& set, const SegmentRecord& segment) {
  const std::string type = std::string(1, oracle::face_letter(set, segment.start_contact)) + "-" +
                           oracle::face_letter(set, segment.crossed_contact) + "-" +
                           (segment.end ? std::string(1, oracle::face_letter(set, segment.end_contact)) : "inf");
  return kTableOne.contains(type) && segment.type == type ? "" : "FC-FLOW-02: " + type + " is the type";
}

// The driver lies in the hull, and the plane through it at right angles to x - driver separates x from the
// contact points: no point of the hull is nearer.
std::string broken_driver(const PointSet& set, const SegmentRecord& segment) {
  const auto contact = points_of(set, segment.start_contact);
  const auto crossed = points_of(set, segment.crossed_contact);
  const Point u = oracle::minus(segment.start, segment.driver);
  const auto height = [&](const Point& p) { return oracle::dot(u, oracle::minus(p, segment.driver)); };
  if (oracle::driver(set, oracle::places_of(set, segment.start_contact), segment.start) != segment.driver) {
    return "FC-DIST-02: the driver is not the nearest point of the hull";
  }
  if (!oracle::face_dimension(crossed, segment.driver) ||
      std::any_of(contact.begin(), contact.end(), [&](const Point& p) { return height(p) > 0; }) ||
      std::any_of(crossed.begin(), crossed.end(), [&](const Point& p) { return height(p) != 0; })) {
    return "FC-DIST-02: the driver's plane does not separate";
  }
  const auto places = oracle::places_of(set, segment.crossed_contact);
  return oracle::driver(set, places, middle_of(segment)) == segment.driver
             ? ""
             : "FC-FLOW-04: the driver changes on the way";
}

// The end is start + t (start - driver), t > 0. On a way to infinity no point becomes nearer than the crossed ones.
std::string broken_way(const PointSet& set, const SegmentRecord& segment) {
  const Point u = oracle::minus(segment.start, segment.driver);
  if (u == Point{}) {
    return "FC-FLOW-03: a segment from a stationary point";
  }
  if (segment.end) {
    const Point way = oracle::minus(*segment.end, segment.start);
    const Rational along = oracle::dot(u, way);
    return along > 0 && along * along == oracle::dot(u, u) * oracle::dot(way, way)
               ? ""
               : "FC-FLOW-01: not away from the driver";
  }
  const Point p = points_of(set, segment.crossed_contact).front();
  return std::any_of(set.points.begin(), set.points.end(),
                     [&](const Point& q) { return oracle::dot(u, oracle::minus(q, p)) > 0; })
             ? "FC-FLOW-01: a point is in the way to infinity"
             : "";
}

Rational squared_distance_to(const PointSet& set, const Point& x) {
  return oracle::squared_distance(x, set.points[set.nearest_places(x).front()]);
}

// The squared radius of the smallest ball that encloses C(x), by Pythagoras: C(x) is equally far from x.
Rational squared_ball_radius(const PointSet& set, const Point& x, const Point& driver) {
  return squared_distance_to(set, x) - oracle::squared_distance(x, driver);
}

// The places of an orbit at which segments start, with their drivers, and the limit, which drives itself.
std::vector<std::pair<Point, Point>> stations(const OrbitRecord& orbit) {
  std::vector<std::pair<Point, Point>> all;
  all.reserve(orbit.segments.size() + 1);
  for (const SegmentRecord& segment : orbit.segments) {
    all.emplace_back(segment.start, segment.driver);
  }
  if (orbit.limit) {
    all.emplace_back(orbit.limit->position, orbit.limit->position);
  }
  return all;
}

std::string broken_growth(const PointSet& set, const OrbitRecord& orbit) {
  const auto all = stations(orbit);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const auto& [x, driver] = all[k];
    const auto& [before, driver_before] = all[k - 1];
    if (squared_distance_to(set, before) >= squared_distance_to(set, x)) {
      return "FC-FLOW-05: d does not grow in segment " + std::to_string(k - 1);
    }
    if (driver == driver_before) return "FC-FLOW-09: the driver does not change after segment " + std::to_string(k - 1);
    const Rational radius = squared_ball_radius(set, x, driver);
    const Rational radius_before = squared_ball_radius(set, before, driver_before);
    if (radius <= radius_before) {
      return "FC-FLOW-05: the enclosing ball does not grow after segment " + std::to_string(k - 1);
    }
  }
  return {};
}

// FC-STAB-08: what lies outside of conv P flows to infinity. Some planes that separate the start from P are tried:
// those orthogonal to an axis, or to the way from a sample.
std::string broken_escape(const PointSet& set, const OrbitRecord& orbit) {
  std::vector<Point> normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Point& p : set.points) normals.push_back(oracle::minus(orbit.start, p));
  const bool is_outside = std::ranges::any_of(normals, [&](const Point& normal) {
    return std::ranges::all_of(set.points,
                               [&](const Point& p) { return oracle::dot(normal, oracle::minus(orbit.start, p)) > 0; });
  });
  return is_outside && orbit.limit ? "FC-STAB-08: a start outside of the hull does not flow to infinity" : "";
}

std::string broken_chain(const OrbitRecord& orbit) {
  std::optional<RationalPoint> x = orbit.start;
  for (const SegmentRecord& segment : orbit.segments) {
    if (x != segment.start) {
      return "FC-FLOW-05: a segment does not start where the one before it ends";
    }
    if (&segment != &orbit.segments.front() && segment.crossed_contact.size() == 1) {
      return "FC-STAB-09: the orbit enters a Voronoi cell again";
    }
    x = segment.end;
  }
  const std::optional<RationalPoint> limit = orbit.limit ? std::optional(orbit.limit->position) : std::nullopt;
  return x == limit ? "" : "FC-FLOW-05: the orbit does not end where its last segment does";
}

std::string broken_limit(const PointSet& set, const LimitRecord& limit) {
  if (oracle::contact_set(set, limit.position) != limit.contact) {
    return "FC-FLOW-05: wrong contact set at the limit";
  }
  const auto contact = points_of(set, limit.contact);
  const auto face = oracle::face_dimension(contact, limit.position);
  if (!face) {
    return "FC-FLOW-05: the limit is not stationary";
  }
  const bool right = *face == limit.face_dimension && oracle::affine_dimension(contact) == limit.hull_dimension &&
                     (*face == limit.hull_dimension || (*face > 0 && *face < limit.hull_dimension));
  return right ? "" : "FC-CRIT-03: the limit is of another kind";
}

}  // namespace

std::vector<Point> points_of(const PointSet& set, const std::vector<std::size_t>& names) {
  std::vector<Point> found;
  for (const std::size_t name : names) {
    const auto place = std::lower_bound(set.names.begin(), set.names.end(), name) - set.names.begin();
    found.push_back(set.points.at(static_cast<std::size_t>(place)));
  }
  return found;
}

std::string broken_law(const PointSet& set, const OrbitRecord& orbit) {
  for (const SegmentRecord& segment : orbit.segments) {
    for (const auto& law : {broken_contact, broken_type, broken_driver, broken_way}) {
      const std::string broken = law(set, segment);
      if (!broken.empty()) {
        return broken + ": " + to_text(segment);
      }
    }
  }
  std::string broken = broken_chain(orbit);
  if (broken.empty()) broken = broken_escape(set, orbit);
  if (broken.empty() && orbit.limit) {
    broken = broken_limit(set, *orbit.limit);
  }
  return broken.empty() ? broken_growth(set, orbit) : broken;
}

}  // namespace flowcert::property
