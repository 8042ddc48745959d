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
};
struct LinearPoint {
  Point at_0, at_1;
  Point operator()(const Rational& t) const { return moved(at_0, t, minus(at_1, at_0)); }
};

// The family's places, for t between two values.
struct Family {
  LinearPoint x;
  Linear w;
};

// What is found of a family: its single rays and its open parts, in the order of t. A single ray has from == to.
struct Part {
  Rational from, to;
  Limit limit;
};
using Parts = std::vector<Part>;

Limit limit_of(const PointSet& set, const Point& x) { return orbit(set, x).limit; }

Rational middle(const Rational& a, const Rational& b) { return (a + b) / 2; }

// Where a ray is that has not run to infinity.
Point place_of(const Family& family, const Rational& t) { return scaled(family.x(t), 1 / family.w(t)); }

// The limit of the ray t, which is at a Voronoi edge or vertex, or at infinity.
Limit limit_of_ray(const PointSet& set, const Family& family, const Rational& t) {
  return family.w(t) == 0 ? std::nullopt : limit_of(set, place_of(family, t));
}

// ---- A family on a Voronoi edge ----

Parts parts_of_fan(const PointSet& set, const std::array<std::size_t, 2>& samples, const Family& family,
                   const Rational& from, const Rational& to);

// The t between from and to at which the family is at z, which is on its line.
std::optional<Rational> time_at(const Family& family, const Point& z, const Rational& from, const Rational& to) {
  const auto way = [&](const Rational& t) { return minus(family.x(t), scaled(z, family.w(t))); };
  const Point first = way(from), last = way(to);
  // On the line these vectors are multiples of one vector, and z is between if they are opposite.
  const Point along = minus(last, first);
  const Rational a = dot(first, along), b = dot(last, along);
  if (!(a < 0 && b > 0)) return std::nullopt;
  return from + (to - from) * a / (a - b);
}

// The rays that have come to the Voronoi edge of a polygon. If the polygon contains its centre z, that is the driver
// of all of them but z itself: they run along the edge, away from z.
Parts parts_on_edge(const PointSet& set, const Places& polygon, const Family& family, const Rational& from,
                    const Rational& to) {
  const std::vector<Point> corners = select(set.points, polygon);
  const Point z = circumcentre(spanning_subset(corners))->center;
  if (!face_dimension(corners, z)) return parts_of_fan(set, obtuse_edge(set, polygon), family, from, to);
  const auto run = [&](const Rational& a, const Rational& b) {
    return Part{a, b, limit_of(set, place_of(family, middle(a, b)))};
  };
  const auto at_z = time_at(family, z, from, to);
  if (!at_z) return {run(from, to)};
  return {run(from, *at_z), {*at_z, *at_z, limit_of(set, z)}, run(*at_z, to)};
}

// ---- A family in a Voronoi facet ----

// L(q) of a sample, or 0 for infinity.
struct Exit {
  Linear length;
  friend bool operator==(const Exit& a, const Exit& b) {
    return a.length.at_0 == b.length.at_0 && a.length.at_1 == b.length.at_1;
  }
};

// The greatest of the exits just after t.
const Exit& greatest_after(const std::vector<Exit>& exits, const Rational& t) {
  const auto key = [&](const Exit& exit) {
    return std::pair(exit.length(t), Rational(exit.length.at_1 - exit.length.at_0));
  };
  return *std::max_element(exits.begin(), exits.end(), [&](const Exit& a, const Exit& b) { return key(a) < key(b); });
}

// The first time after t, and before `to`, at which another exit becomes greater; otherwise `to`.
Rational end_of_greatest(const std::vector<Exit>& exits, const Exit& greatest, const Rational& t, const Rational& to) {
  Rational end = to;
  for (const Exit& other : exits) {
    const Rational lead = greatest.length(t) - other.length(t), lead_at_end = greatest.length(end) - other.length(end);
    if (lead_at_end < 0) end = t + (end - t) * lead / (lead - lead_at_end);
  }
  return end;
}

// The rays that run away from the midpoint of two samples in their Voronoi facet, for from < t < to.
Parts parts_of_fan(const PointSet& set, const std::array<std::size_t, 2>& samples, const Family& family,
                   const Rational& from, const Rational& to) {
  const Point &p0 = set.points[samples[0]], &p1 = set.points[samples[1]];
  const Point m = midpoint(p0, p1);
  const LinearPoint v = {minus(family.x.at_0, scaled(m, family.w.at_0)),
                         minus(family.x.at_1, scaled(m, family.w.at_1))};
  std::vector<Exit> exits = {{{0, 0}}};
  for (const Point& q : set.points) {
    const Rational h = dot(minus(q, p0), minus(q, p1));
    const Point way = minus(q, m);
    if (h > 0) exits.push_back({{2 * dot(v.at_0, way) / h, 2 * dot(v.at_1, way) / h}});
  }
  Parts parts;
  for (Rational t = from; t < to;) {
    const Exit exit = greatest_after(exits, t);
    const Rational end = end_of_greatest(exits, exit, t, to);
    const Linear& length = exit.length;
    const Family beyond = {{moved(v.at_0, length.at_0, m), moved(v.at_1, length.at_1, m)}, length};
    if (t > from) parts.push_back({t, t, limit_of_ray(set, beyond, t)});
    if (exit == exits.front()) {
      parts.push_back({t, end, std::nullopt});
    } else {
      const Places polygon = set.nearest_places(place_of(beyond, middle(t, end)));
      const Parts further = parts_on_edge(set, polygon, beyond, t, end);
      parts.insert(parts.end(), further.begin(), further.end());
    }
    t = end;
  }
  return parts;
}

// ---- The directions of a stationary point ----

// The limit of y + e u for all small e > 0.
Limit limit_along(const PointSet& set, const StationaryPoint& y, const Point& u) {
  const Places crossed = crossed_places(set, places_of(set, y.contact), u);
  const auto meeting = set.first_meeting(crossed.front(), y.center, u);
  return limit_of(set, moved(y.center, meeting ? Rational(*meeting / 2) : Rational(1), u));
}

UnstableEntry single(const PointSet& set, const StationaryPoint& y, const Point& u) {
  const Direction direction = as_direction(u);
  return {false, direction, direction, limit_along(set, y, u)};
}

// y is inside a face of dimension 2. The directions are those of its normal, but not towards other points of C(y).
std::vector<UnstableEntry> list_of_polygon(const PointSet& set, const StationaryPoint& y, const Places& face) {
  const Point &a = set.points[face[0]], &b = set.points[face[1]], &c = set.points[face[2]];
  const Point normal = cross(minus(b, a), minus(c, a));
  std::vector<UnstableEntry> list;
  for (const int sign : {-1, 1}) {
    const Point u = scaled(normal, sign);
    if (crossed_places(set, places_of(set, y.contact), u) == face) list.push_back(single(set, y, u));
  }
  return list;
}

// The part of a quarter of the circle that leads into the closed Voronoi face: no sample of C(y) comes nearer than
// those of the face.
std::optional<std::pair<Rational, Rational>> allowed(const PointSet& set, const StationaryPoint& y,
                                                     const LinearPoint& u) {
  Rational from = 0, to = 1;
  for (const std::size_t place : places_of(set, y.contact)) {
    const Point way = minus(set.points[place], y.center);
    const Linear nearer = {dot(u.at_0, way), dot(u.at_1, way)};
    if (nearer.at_0 > 0 && nearer.at_1 > 0) return std::nullopt;
    if (nearer.at_0 > 0) from = std::max(from, Rational(nearer.at_0 / (nearer.at_0 - nearer.at_1)));
    if (nearer.at_1 > 0) to = std::min(to, Rational(nearer.at_0 / (nearer.at_0 - nearer.at_1)));
  }
  return from <= to ? std::optional(std::pair(from, to)) : std::nullopt;
}

// Adds an entry, unless it is the direction that the last one is already.
void add(std::vector<UnstableEntry>& list, const UnstableEntry& entry) {
  if (!list.empty() && !entry.is_arc && !list.back().is_arc && list.back().from == entry.from) return;
  list.push_back(entry);
}

void add_quarter(const PointSet& set, const StationaryPoint& y, const Places& face, const LinearPoint& u,
                 std::vector<UnstableEntry>& list) {
  const auto part = allowed(set, y, u);
  if (!part) return;
  const auto& [from, to] = *part;
  add(list, single(set, y, u(from)));
  for (const Part& found : parts_of_fan(set, {face[0], face[1]}, {u, {0, 0}}, from, to)) {
    add(list, {found.from != found.to, as_direction(u(found.from)), as_direction(u(found.to)), found.limit});
  }
  add(list, single(set, y, u(to)));
}

// Takes out each direction between two arcs of its own limit. The entries go around a circle if `is_cyclic`.
std::vector<UnstableEntry> absorbed(std::vector<UnstableEntry> list, bool is_cyclic) {
  const auto is_inside = [&](std::size_t i) {
    if (list[i].is_arc || (!is_cyclic && (i == 0 || i + 1 == list.size()))) return false;
    return list[(i + list.size() - 1) % list.size()].limit == list[i].limit &&
           list[(i + 1) % list.size()].limit == list[i].limit;
  };
  for (std::size_t i = 0; i < list.size();) {
    if (!is_inside(i)) {
      ++i;
    } else if (list.size() == 2) {
      return {{true, std::nullopt, std::nullopt, list[i].limit}};
    } else {
      // The arc after it is put together with the arc before it.
      std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(i), list.end());
      list.back().to = list[1].to;
      list.erase(list.begin(), list.begin() + 2);
      std::rotate(list.begin(), list.end() - static_cast<std::ptrdiff_t>(is_cyclic ? 0 : i), list.end());
      i = 0;
    }
  }
  return list;
}

// The directions are taken by quarters of the circle. Those of a regular stationary point are an arc of at most half of
// it, which begins in a quarter whose predecessor has no part of it, or that it does not fill from its beginning.
std::vector<UnstableEntry> list_of_edge(const PointSet& set, const StationaryPoint& y, const Places& face) {
  const Point axis = minus(set.points[face[1]], set.points[face[0]]);
  // A vector across the axis: the cross product with a unit vector along which the axis does not go.
  const Point first = axis[0] != 0 || axis[1] != 0 ? cross(axis, {0, 0, 1}) : cross(axis, {1, 0, 0});
  const Point second = cross(axis, first);
  const std::array<Point, 4> ways = {first, second, scaled(first, -1), scaled(second, -1)};
  const auto quarter = [&](std::size_t k) { return LinearPoint{ways[k % 4], ways[(k + 1) % 4]}; };
  std::size_t begin = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto part = allowed(set, y, quarter(k));
    if (part && (part->first > 0 || !allowed(set, y, quarter(k + 3)))) begin = k;
  }
  std::vector<UnstableEntry> list;
  for (std::size_t k = begin; k < begin + 4; ++k) add_quarter(set, y, face, quarter(k), list);
  if (y.hull_dimension > 1) return absorbed(std::move(list), false);
  list.pop_back();  // the direction with which the circle began
  list = absorbed(std::move(list), true);
  const auto is_less = [](const UnstableEntry& a, const UnstableEntry& b) {
    return !a.is_arc && (b.is_arc || a.from < b.from);
  };
  std::rotate(list.begin(), std::min_element(list.begin(), list.end(), is_less), list.end());
  return list;
}

}  // namespace

std::array<std::size_t, 2> obtuse_edge(const PointSet& set, const Places& polygon) {
  for (const std::size_t a : polygon) {
    for (const std::size_t b : polygon) {
      const bool is_obtuse =
          a < b && std::all_of(
                       polygon.begin(), polygon.end(),
                       [&](std::size_t q) {
                         return q == a || q == b ||
                                dot(minus(set.points[q], set.points[a]), minus(set.points[q], set.points[b])) < 0;
                       });
      if (is_obtuse) return {a, b};
    }
  }
  throw std::logic_error("a polygon without its centre is obtuse at an edge");
}

// No affinely independent set with y in its relative interior has a point outside of that face, and each point of the
// face is in such a set.
Places face_of(const PointSet& set, const StationaryPoint& y) {
  const Places contact = places_of(set, y.contact);
  Places face;
  for_each_subset(contact.size(), 4, [&](const Places& subset) {
    const Places places = select(contact, subset);
    if (inner_circumcentre(select(set.points, places)) != std::optional(y.center)) return;
    face.insert(face.end(), places.begin(), places.end());
  });
  std::sort(face.begin(), face.end());
  face.erase(std::unique(face.begin(), face.end()), face.end());
  return face;
}

Direction as_direction(const Point& vector) {
  Rational largest = 0;
  for (const Rational& x : vector) largest = std::max(largest, Rational(abs(x)));
  return scaled(vector, 1 / largest);
}

std::vector<UnstableEntry> lambda_list(const PointSet& set, const StationaryPoint& y) {
  if (y.face_dimension == 0) throw std::invalid_argument("all directions lead away from a sample");
  if (y.face_dimension == 3) return {};
  const Places face = face_of(set, y);
  return y.face_dimension == 2 ? list_of_polygon(set, y, face) : list_of_edge(set, y, face);
}

}  // namespace oracle
