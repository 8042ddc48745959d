// How the header's promises are kept: rays are followed in families.
//
// A family has a parameter t. Its ray t is at X(t) / W(t), where X and W are linear in t, and W is 0 where the ray has
// run to infinity. Rays that leave the midpoint m of a facet's samples p0, p1 run along v = X - W m. A ray meets the
// sample q, for which h(q) = <q - p0, q - p1> > 0, at m + v / L(q), where L(q) = 2 <v, q - m> / h(q) > 0: there,
// |x - q|^2 = |x - p0|^2. So it leaves the facet where L(q) is greatest, and that is the place X' / W' with
// X' = L m + v and W' = L, which are linear again. Where no L(q) is positive, the ray stays in the facet for ever.
// A sample with h(q) <= 0 is met by no ray that starts inside the facet: L(q) would have to be less than 0.
#include "oracle/unstable_set.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "oracle/orbit.h"

namespace oracle {

namespace {

using Limit = std::optional<StationaryPoint>;

// A number or a vector that is linear in t.
struct Linear {
  Rational at_0, at_1;
  Rational operator()(const Rational& t) const { return at_0 + t * (at_1 - at_0); }
  friend bool operator==(const Linear&, const Linear&) = default;
};
struct LinearPoint {
  Point at_0, at_1;
  Point operator()(const Rational& t) const { return moved(at_0, t, minus(at_1, at_0)); }
};

struct Family {
  LinearPoint x;
  Linear w;
};

// The values of t at which the limits of a family's rays can change, ascending.
using Breaks = std::vector<Rational>;

void add_breaks_in_facet(const PointSet& set, const std::array<std::size_t, 2>& samples, const Family& family,
                         const Rational& from, const Rational& to, Breaks& breaks);

// The rays for from < t < to have come to one Voronoi edge. If its polygon contains its centre z, that is the driver of
// all of them but z itself: they run along the edge, away from z. On the line of the edge, the vectors from z are
// multiples of one vector, and z is between the first and the last place if these are opposite.
void add_breaks_on_edge(const PointSet& set, const Family& family, const Rational& from, const Rational& to,
                        Breaks& breaks) {
  const Rational middle = (from + to) / 2;
  const Places polygon = set.nearest_places(scaled(family.x(middle), 1 / family.w(middle)));
  const std::vector<Point> corners = select(set.points, polygon);
  const Point z = circumcentre(spanning_subset(corners))->center;
  if (!face_dimension(corners, z)) {
    return add_breaks_in_facet(set, obtuse_edge(set, polygon), family, from, to, breaks);
  }
  const auto from_z = [&](const Rational& t) { return minus(family.x(t), scaled(z, family.w(t))); };
  const Point first = from_z(from), last = from_z(to), along = minus(last, first);
  const Rational a = dot(first, along), b = dot(last, along);
  if (a < 0 && b > 0) breaks.push_back(from + (to - from) * a / (a - b));
}

// The greatest just after t. These are the L(q) of samples, and 0 for infinity.
Linear greatest_after(const std::vector<Linear>& lengths, const Rational& t) {
  const auto key = [&](const Linear& length) { return std::pair(length(t), Rational(length.at_1 - length.at_0)); };
  return *std::max_element(lengths.begin(), lengths.end(),
                           [&](const Linear& a, const Linear& b) { return key(a) < key(b); });
}

// The first time after t, and before `to`, at which another one becomes greater; otherwise `to`.
Rational end_of_greatest(const std::vector<Linear>& lengths, const Linear& greatest, const Rational& t,
                         const Rational& to) {
  Rational end = to;
  for (const Linear& other : lengths) {
    const Rational lead = greatest(t) - other(t), lead_at_end = greatest(end) - other(end);
    if (lead_at_end < 0) end = t + (end - t) * lead / (lead - lead_at_end);
  }
  return end;
}

// The rays for from < t < to run away from the midpoint of two samples in their Voronoi facet.
void add_breaks_in_facet(const PointSet& set, const std::array<std::size_t, 2>& samples, const Family& family,
                         const Rational& from, const Rational& to, Breaks& breaks) {
  const Point &p0 = set.points[samples[0]], &p1 = set.points[samples[1]];
  const Point m = midpoint(p0, p1);
  const LinearPoint v = {moved(family.x.at_0, -family.w.at_0, m), moved(family.x.at_1, -family.w.at_1, m)};
  const Linear infinity = {0, 0};
  std::vector<Linear> lengths = {infinity};
  for (const Point& q : set.points) {
    const Rational h = dot(minus(q, p0), minus(q, p1));
    if (h > 0) lengths.push_back({2 * dot(v.at_0, minus(q, m)) / h, 2 * dot(v.at_1, minus(q, m)) / h});
  }
  for (Rational t = from; t < to;) {
    if (t > from) breaks.push_back(t);
    const Linear length = greatest_after(lengths, t);
    const Rational end = end_of_greatest(lengths, length, t, to);
    const LinearPoint beyond = {moved(v.at_0, length.at_0, m), moved(v.at_1, length.at_1, m)};
    if (length != infinity) add_breaks_on_edge(set, {beyond, length}, t, end, breaks);
    t = end;
  }
}

// ---- The directions of a stationary point ----

// The limit of y + e u for all small e > 0. The driver of these points is y, so that they run along u.
Limit limit_along(const PointSet& set, const StationaryPoint& y, const Point& u) {
  const Places crossed = crossed_places(set, places_of(set, y.contact), u);
  const auto meeting = set.first_meeting(crossed.front(), y.center, u);
  return meeting ? orbit(set, moved(y.center, *meeting, u)).limit : std::nullopt;
}

// y is inside a face of dimension 2. The directions are those of its normal, but not towards other points of C(y).
std::vector<UnstableEntry> list_of_polygon(const PointSet& set, const StationaryPoint& y, const Places& face) {
  const Point &a = set.points[face[0]], &b = set.points[face[1]], &c = set.points[face[2]];
  std::vector<UnstableEntry> list;
  for (const int sign : {-1, 1}) {
    const Direction u = as_direction(scaled(cross(minus(b, a), minus(c, a)), sign));
    const bool is_free = crossed_places(set, places_of(set, y.contact), u) == face;
    if (is_free) list.push_back({false, u, u, limit_along(set, y, u)});
  }
  return list;
}

// A direction, with its limit and that of all directions after it, up to the next one of the list.
struct Break {
  Direction direction;
  Limit limit, after;
};

// The directions of y that break an arc of less than half a circle, with its beginning, and without its end.
std::vector<Break> breaks_of(const PointSet& set, const StationaryPoint& y, const Places& face,
                             const LinearPoint& arc) {
  Breaks times = {0};
  add_breaks_in_facet(set, {face[0], face[1]}, {arc, {0, 0}}, 0, 1, times);
  times.push_back(1);
  std::vector<Break> breaks;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const Point u = arc(times[k]), middle = arc((times[k] + times[k + 1]) / 2);
    breaks.push_back({as_direction(u), limit_along(set, y, u), limit_along(set, y, middle)});
  }
  return breaks;
}

// No sample of C(y) comes nearer, in the directions of y, than those of the face. A direction between two arcs of its
// own limit is no break.
std::vector<UnstableEntry> list_of_edge(const PointSet& set, const StationaryPoint& y, const Places& face) {
  const std::vector<Point> contact = select(set.points, places_of(set, y.contact));
  const Directions directions = free_directions(contact, set.points[face[0]], set.points[face[1]]);
  std::vector<Break> breaks;
  for (const auto& [from, to] : directions.arcs) {
    const std::vector<Break> of_arc = breaks_of(set, y, face, {from, to});
    breaks.insert(breaks.end(), of_arc.begin(), of_arc.end());
  }
  const bool is_cyclic = y.is_critical();
  const Direction& end = directions.arcs.back().second;
  if (!is_cyclic) breaks.push_back({end, limit_along(set, y, end), std::nullopt});
  std::vector<Break> kept;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const bool is_end = !is_cyclic && (k == 0 || k + 1 == breaks.size());
    const Limit& before = breaks[(k + breaks.size() - 1) % breaks.size()].after;
    if (is_end || breaks[k].limit != before || breaks[k].limit != breaks[k].after) kept.push_back(breaks[k]);
  }
  if (kept.empty()) return {{true, std::nullopt, std::nullopt, breaks[0].limit}};
  const auto is_less = [](const Break& a, const Break& b) { return a.direction < b.direction; };
  if (is_cyclic) std::rotate(kept.begin(), std::min_element(kept.begin(), kept.end(), is_less), kept.end());
  std::vector<UnstableEntry> list;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    list.push_back({false, kept[k].direction, kept[k].direction, kept[k].limit});
    if (!is_cyclic && k + 1 == kept.size()) break;
    list.push_back({true, kept[k].direction, kept[(k + 1) % kept.size()].direction, kept[k].after});
  }
  return list;
}

}  // namespace

std::array<std::size_t, 2> obtuse_edge(const PointSet& set, const Places& polygon) {
  for (const std::size_t a : polygon) {
    for (const std::size_t b : polygon) {
      const auto is_outside = [&](std::size_t q) {  // of the ball with this edge as its diameter, or on its sphere
        const Point &x = set.points[q], &p = set.points[a], &r = set.points[b];
        return q != a && q != b && dot(minus(x, p), minus(x, r)) >= 0;
      };
      if (a < b && std::none_of(polygon.begin(), polygon.end(), is_outside)) return {a, b};
    }
  }
  throw std::logic_error("a polygon without its centre is obtuse at an edge");
}

// No affinely independent set with y in its relative interior has a point outside of that face, and each point of the
// face is in such a set.
Places face_of(const PointSet& set, const StationaryPoint& y) {
  const Places contact = places_of(set, y.contact);
  std::set<std::size_t> face;
  for_each_subset(contact.size(), 4, [&](const Places& subset) {
    const Places places = select(contact, subset);
    if (inner_circumcentre(select(set.points, places)) == y.center) face.insert(places.begin(), places.end());
  });
  return {face.begin(), face.end()};
}

std::vector<UnstableEntry> lambda_list(const PointSet& set, const StationaryPoint& y) {
  if (y.face_dimension == 0) throw std::invalid_argument("all directions lead away from a sample");
  if (y.face_dimension == 3) return {};
  const Places face = face_of(set, y);
  return y.face_dimension == 2 ? list_of_polygon(set, y, face) : list_of_edge(set, y, face);
}

}  // namespace oracle
