// How the header's promises are kept: a search against the flow finds what flows into each place.
//
// The search ends, because d decreases along each way back and there are finitely many faces. It finds no point
// twice, because a point has only one orbit, and is found only from the place where that orbit goes on.
#include "oracle/stable_set.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/orbit.h"

namespace oracle {

namespace {

// A face K of conv C(y), by its places, with its centre c.
struct Lead {
  Places face;
  Point centre;
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

bool collinear(const Point& a, const Point& b, const Point& c) { return cross(minus(b, a), minus(c, a)) == Point{}; }

Point middle(const Point& a, const Point& b) { return moved(a, Rational(1, 2), minus(b, a)); }

// The part of a convex polygon that is not nearer to q than to p.
std::vector<Point> clipped(const std::vector<Point>& polygon, const Point& p, const Point& q) {
  const auto lead = [&](const Point& x) { return Rational(squared_distance(x, q) - squared_distance(x, p)); };
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const Rational at_a = lead(a), at_b = lead(b);
    if (at_a >= 0) result.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
      const Rational time = at_a / (at_a - at_b);
      result.push_back(moved(a, time, minus(b, a)));
    }
  }
  return result;
}

// The same polygon, from the least corner towards the lesser of its neighbours.
std::vector<Point> canonical(std::vector<Point> polygon) {
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if (polygon.back() < polygon[1]) std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

// The search. Each function adds what its name says, and all that flows into it.
class Search {
 public:
  explicit Search(const PointSet& set) : set_(set) {}

  void add_point(const Point& y) {
    found_.points.push_back({y, contact_set(set_, y)});
    found_.has_vertex = found_.has_vertex || dimension_at(y) == 3;
    for (const Lead& lead : leads_to(set_, y)) {
      is_edge(lead) ? add_segment(y, lead) : add_interval_into(y, lead);
    }
  }

  StableSet sorted() && {
    std::sort(found_.points.begin(), found_.points.end());
    std::sort(found_.segments.begin(), found_.segments.end());
    std::sort(found_.intervals.begin(), found_.intervals.end());
    std::sort(found_.sectors.begin(), found_.sectors.end());
    return std::move(found_);
  }

 private:
  int dimension_at(const Point& x) const { return affine_dimension(select(set_.points, set_.nearest_places(x))); }

  // FC-STAB-04
  void add_segment(const Point& y, const Lead& lead) {
    const Point back = way_back(set_, y, lead);
    const int dimension = dimension_at(back);
    BackKind kind = dimension == 2 ? BackKind::kEdge : BackKind::kVertex;
    if (back == lead.centre) kind = dimension == 1 ? BackKind::kCritical : BackKind::kRegular;
    found_.segments.push_back({samples_of(set_, lead), y, back, contact_set(set_, y), contact_set(set_, back), kind});
    if (back != lead.centre) add_point(back);
  }

  // FC-STAB-05, with y at a Voronoi vertex.
  void add_interval_into(const Point& y, const Lead& lead) {
    const Point back = way_back(set_, y, lead);
    const bool whole = back == lead.centre;
    const IntervalKind kind = whole ? IntervalKind::kFromCentre : IntervalKind::kFromVertex;
    add_interval({select(set_.names, lead.face), y, back, kind});
    if (!whole) add_point(back);
  }

  // A face that leads to one point of the interval leads to all. The search may also find the polygon itself,
  // which leads along the interval.
  void add_interval(const BackwardInterval& interval) {
    found_.intervals.push_back(interval);
    for (const Lead& lead : leads_to(set_, middle(interval.front, interval.back))) {
      if (is_edge(lead)) add_sector(interval, lead);
    }
  }

  // The sector is the part of the triangle of the interval and the midpoint m that is in the facet. Its rays leave
  // the facet through sides that lie on no ray, and through corners between two such sides. The first and the last
  // ray are not in the sector. Any part of them that flows to z is a segment or an interval of its own.
  void add_sector(const BackwardInterval& interval, const Lead& lead) {
    const auto& [polygon, front, back, kind] = interval;
    const Point& m = lead.centre;
    std::vector<Point> sector = {front, back, m};
    for (const Point& q : set_.points) sector = clipped(sector, set_.points[lead.face[0]], q);
    found_.sectors.push_back({samples_of(set_, lead), canonical(sector)});
    for (std::size_t i = 0; i < sector.size(); ++i) {
      const Point& a = sector[i];
      const Point& b = sector[(i + 1) % sector.size()];
      if (!collinear(a, m, front) && !collinear(a, m, back)) add_point(a);
      const bool is_front_side = std::minmax(a, b) == std::minmax(front, back);
      if (!is_front_side && !collinear(a, b, m)) add_crossed_interval(a, b);
    }
  }

  void add_crossed_interval(const Point& a, const Point& b) {
    const std::vector<std::size_t> polygon = contact_set(set_, middle(a, b));
    add_interval({polygon, std::min(a, b), std::max(a, b), IntervalKind::kCrossed});
  }

  const PointSet& set_;
  StableSet found_;
};

}  // namespace

StableSet stable_set(const PointSet& set, const StationaryPoint& z) {
  Search search(set);
  search.add_point(z.center);
  return std::move(search).sorted();
}

}  // namespace oracle
