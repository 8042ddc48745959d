#include "morse/ball_ascents.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "geometry/keep_unique.h"

namespace flowcert::morse {

namespace {

using Ids = std::vector<std::uint32_t>;
using Three = std::array<std::uint32_t, 3>;

// A plane through three centres.
template <class Number>
struct Plane {
  Vector3<Number> through, normal;
};
template <class Number>
Plane<Number> plane_of(const BallSet& balls, const Three& corners) {
  const Vector3<Number> a = number_ball<Number>(balls, corners[0]).center;
  return {a,
          cross(number_ball<Number>(balls, corners[1]).center - a, number_ball<Number>(balls, corners[2]).center - a)};
}
// Times the length of the normal.
template <class Number>
Number height(const BallSet& balls, const Plane<Number>& plane, std::uint32_t id) {
  return dot(number_ball<Number>(balls, id).center - plane.through, plane.normal);
}
int side_of(const BallSet& balls, const Three& corners, std::uint32_t id) {
  const int sign = height(balls, plane_of<BoundedDouble>(balls, corners), id).certain_sign();
  if (sign != 0) return sign;
  return height(balls, plane_of<Rational>(balls, corners), id).compare(0);
}

bool contains(const Ids& ascending, std::uint32_t id) { return std::ranges::binary_search(ascending, id); }

void merge(BallEnds& ends, const BallEnds& others) {
  ends.insert(ends.end(), others.begin(), others.end());
  geometry::keep_unique(ends);
}

template <class Number, class Level>
Level at(const std::pair<Number, Number>& linear, const Level& s) {
  return Level(linear.first) + Level(linear.second) * s;
}

}  // namespace

BallAscents::BallAscents(const BallDiagram& diagram, const std::vector<BallCriticalPoint>& points)
    : diagram_(diagram), balls_(diagram.balls()), simple_(diagram.cells().size()), seen_(balls_.size()) {
  for (std::uint32_t number = 0; number < points.size(); ++number) {
    if (points[number].index == 3) peak_of_.emplace(points[number].contacts, number);
  }
}

// `linear` makes a number that depends on s, first + second s, in the type that it is asked for.
template <class Linear>
int BallAscents::sign_at(const BallLevel& level, const Linear& linear) const {
  const int sign = at(linear.template operator()<BoundedDouble>(), level.near()).certain_sign();
  if (sign != 0) return sign;
  return at(linear.template operator()<Rational>(), level.exact(balls_)).sign();
}

template <class Number>
const Touching<Number>& BallAscents::touching_of(const BallEdge& edge) const {
  if constexpr (std::is_same_v<Number, BoundedDouble>) {
    static const Touching<BoundedDouble> unknown = [] {
      const BoundedDouble any(0, HUGE_VAL);
      return Touching<BoundedDouble>{{any, any, any}, {any, any, any}, {}, {}, any, any, any};
    }();
    return edge.near ? *edge.near : unknown;
  } else {
    if (!edge.exact) edge.exact = touching<Rational>(balls_, edge.balls);
    return *edge.exact;
  }
}
template <class Number>
std::pair<Number, Number> BallAscents::lead_of(const BallEdge& edge, std::uint32_t id) const {
  return lead(touching_of<Number>(edge), number_ball<Number>(balls_, edge.balls[0]), number_ball<Number>(balls_, id));
}

// ---- The way ----

std::array<BallEnds, 2> BallAscents::ends(const BallCriticalPoint& point) {
  // A hidden ball is between the point and another contact.
  Ids plane = point.contacts;
  std::erase_if(plane, [&](std::uint32_t id) { return diagram_.star(id).empty(); });
  Three corners{point.carrier[0], point.carrier[1], point.carrier[2]};
  // On an edge, any contact beside it.
  for (std::size_t k = 0; point.corners < 3; ++k) {
    corners[2] = plane[k];
    const Vector3<Rational> n = plane_of<Rational>(balls_, corners).normal;
    if (n.x != 0 || n.y != 0 || n.z != 0) break;
  }
  const std::uint32_t cell = plane.size() == 3 ? cell_with(corners) : BallDiagram::kNone;
  return {slide(corners, plane, plane, point.value, cell),
          slide({corners[0], corners[2], corners[1]}, plane, plane, point.value, cell)};
}

// Along the edge of the power diagram that is orthogonal to the plane, to the next vertex of it. If the plane has three
// contacts alone, `cell` is a cell with them, or kNone.
BallEnds BallAscents::slide(const Three& facet, Ids plane, const Ids& contacts, const BallLevel& level,
                            std::uint32_t cell) {
  if (const auto edge = edge_ahead(facet, level, cell)) return follow(*edge, level);
  const Ids nearest = first_hit(facet, contacts, level);
  if (nearest.empty()) return {kOutside};
  plane.insert(plane.end(), nearest.begin(), nearest.end());
  if (plane.size() > 4) {
    // They are not all neighbours of one ball, where more than four are equally far.
    BallEdge edge;
    edge.balls = {facet[0], facet[1], facet[2], nearest[0]};
    edge.near = touching<BoundedDouble>(balls_, edge.balls);
    plane = contacts_at(edge, level);
  }
  std::ranges::sort(plane);
  return rise(plane, level);
}

std::uint32_t BallAscents::cell_with(const Three& facet) const {
  const auto has_all = [&](std::uint32_t cell) {
    const BallDiagram::Corners& corners = diagram_.cells()[cell];
    return std::ranges::all_of(facet,
                               [&](std::uint32_t id) { return std::ranges::find(corners, id) != corners.end(); });
  };
  const auto star =
      diagram_.star(*std::ranges::min_element(facet, {}, [&](std::uint32_t id) { return diagram_.star(id).size(); }));
  const auto found = std::ranges::find_if(star, has_all);
  return found == star.end() ? BallDiagram::kNone : *found;
}

// The edge of the diagram that the way along the facet's normal comes to, where doubles tell it, and that it has no
// other contacts there. Among the first balls that are as near is one that has a cell with the facet's balls: these
// cells are a ring, or a part of one.
std::optional<BallEdge> BallAscents::edge_ahead(const Three& facet, const BallLevel& level, std::uint32_t cell) {
  if (cell == BallDiagram::kNone || diagram_.dimension() < 4) return std::nullopt;
  const auto near = touching<BoundedDouble>(balls_, std::span<const std::uint32_t>(facet));
  if (!near) return std::nullopt;
  const Plane<BoundedDouble> plane = plane_of<BoundedDouble>(balls_, facet);
  const NumberBall<BoundedDouble> first = number_ball<BoundedDouble>(balls_, facet[0]);
  BoundedDouble best_ahead, best_above;
  std::uint32_t nearest = BallDiagram::kNone;
  std::optional<std::pair<std::uint32_t, std::size_t>> best;  // the cell, and its corner that is not of the edge
  bool is_certain = true;
  // Takes the corner k of a cell, where `other` is the second one beside the facet.
  const auto see = [&](std::uint32_t at_cell, std::size_t k, std::size_t other) {
    const std::uint32_t id = diagram_.cells()[at_cell][k];
    if (id == nearest) return;
    const BoundedDouble above = height(balls_, plane, id);
    const int side = above.certain_sign();
    if (side == 0) is_certain = false;
    if (side <= 0) return;
    const BoundedDouble ahead = at(lead(*near, first, number_ball<BoundedDouble>(balls_, id)), level.near());
    const int order = best ? (ahead * best_above - best_ahead * above).certain_sign() : -1;
    if (order == 0) is_certain = false;
    if (order >= 0) return;
    best = {at_cell, other};
    nearest = id;
    best_ahead = ahead;
    best_above = above;
  };
  const auto others_of = [&](std::uint32_t at_cell) {
    std::array<std::size_t, 2> others{};
    for (std::size_t k = 0, place = 0; k < 5; ++k) {
      if (std::ranges::find(facet, diagram_.cells()[at_cell][k]) == facet.end()) others[place++] = k;
    }
    return others;
  };
  const auto [one, two] = others_of(cell);
  see(cell, one, two);
  see(cell, two, one);
  // Leaves each cell across the corner that it did not come across.
  const auto walk = [&](std::size_t leaving, std::size_t staying) {
    std::uint32_t at_cell = cell;
    while (true) {
      const std::uint32_t stays = diagram_.cells()[at_cell][staying];
      at_cell = diagram_.adjacent()[at_cell][leaving];
      if (at_cell == BallDiagram::kNone || at_cell == cell) return at_cell;
      const auto [i, j] = others_of(at_cell);
      leaving = diagram_.cells()[at_cell][i] == stays ? i : j;
      staying = leaving == i ? j : i;
      see(at_cell, staying, leaving);
    }
  };
  if (walk(one, two) == BallDiagram::kNone) walk(two, one);
  if (!best || !is_certain) return std::nullopt;
  BallEdge edge = edge_of(best->first, best->second);
  if (!edge.near || !has_four_contacts(edge, level)) return std::nullopt;
  return edge;
}

// The balls that are as near first, on the ray from the plane along its normal; none where no ball ever is.
Ids BallAscents::first_hit(const Three& facet, const Ids& contacts, const BallLevel& level) const {
  struct Hit {
    std::uint32_t id;
    BoundedDouble ahead, above;  // how much less near it is at the plane, and its height: their quotient is compared
  };
  const Plane<BoundedDouble> plane = plane_of<BoundedDouble>(balls_, facet);
  const NumberBall<BoundedDouble> first = number_ball<BoundedDouble>(balls_, facet[0]);
  const auto near = touching<BoundedDouble>(balls_, std::span<const std::uint32_t>(facet));
  std::optional<Touching<Rational>> made;
  const auto exact_ahead = [&](std::uint32_t id) {
    if (!made) made = touching<Rational>(balls_, std::span<const std::uint32_t>(facet));
    return at(lead(*made, number_ball<Rational>(balls_, facet[0]), number_ball<Rational>(balls_, id)),
              level.exact(balls_));
  };
  std::optional<Plane<Rational>> exact_plane;
  const auto exact_above = [&](std::uint32_t id) {
    if (!exact_plane) exact_plane = plane_of<Rational>(balls_, facet);
    return QuadraticNumber(height(balls_, *exact_plane, id));
  };
  std::optional<Hit> best;
  Ids nearest;
  for (const std::uint32_t id : diagram_.neighbours(facet[0])) {
    const BoundedDouble above = height(balls_, plane, id);
    const int side = above.certain_sign();
    if (side < 0 || contains(contacts, id) || (side == 0 && exact_above(id).sign() <= 0)) continue;
    const BoundedDouble ahead = near ? at(lead(*near, first, number_ball<BoundedDouble>(balls_, id)), level.near())
                                     : BoundedDouble(0, HUGE_VAL);
    int order = -1;
    if (best) {
      order = (ahead * best->above - best->ahead * above).certain_sign();
      if (order == 0) {
        order = (exact_ahead(id) * exact_above(best->id) - exact_ahead(best->id) * exact_above(id)).sign();
      }
    }
    if (order > 0) continue;
    if (order < 0) {
      best = Hit{id, ahead, above};
      nearest.clear();
    }
    nearest.push_back(id);
  }
  return nearest;
}

// From a vertex of the power diagram, as the probe grows.
BallEnds BallAscents::rise(const Ids& contacts, const BallLevel& level) {
  const auto found = rises_.find(contacts);
  if (found != rises_.end()) return rise_along(found->second, level);
  std::vector<BallEdge> above;
  for (BallEdge& edge : edges_among(contacts)) {
    if (reaches(edge, level, Side::kAbove)) above.push_back(std::move(edge));
  }
  if (contacts.size() == 4) return rise_along(above, level);
  // Contacts that span space are those of one level, or of all levels of an edge of the diagram.
  above = steepest(above, level);
  return rise_along(rises_.emplace(contacts, std::move(above)).first->second, level);
}

// From a vertex of the diagram where five balls alone are equally far.
BallEnds BallAscents::rise_from_cell(std::uint32_t cell, const BallLevel& level) {
  std::vector<BallEdge> above;
  for (std::size_t corner = 0; corner < 5; ++corner) {
    BallEdge edge = edge_of(cell, corner);
    if (!is_in_space(edge)) continue;
    // The fifth ball falls behind above the level, or below it.
    const auto slope = [&]<class Number>() {
      return std::pair<Number, Number>(lead_of<Number>(edge, diagram_.cells()[cell][corner]).second, Number(0));
    };
    if (sign_at(level, slope) > 0) above.push_back(std::move(edge));
  }
  return rise_along(above, level);
}

BallEnds BallAscents::rise_along(const std::vector<BallEdge>& above, const BallLevel& level) {
  if (above.empty()) throw std::logic_error("no edge of the diagram leads on");
  if (above.size() == 1) return follow(above[0], level);
  BallEnds ends;
  for (const BallEdge& edge : steepest(above, level)) merge(ends, follow(edge, level));
  return ends;
}

BallEnds BallAscents::follow(const BallEdge& edge, const BallLevel& level) {
  const std::optional<BallLevel> zero = zero_above(edge, level);
  const std::optional<End> end = end_above(edge);
  if (!zero && !end) return {kOutside};
  const bool is_zero = zero && (!end || compare(balls_, *zero, end->level) <= 0);
  const auto found = known_.find({edge.balls, is_zero});
  if (found != known_.end()) return found->second;
  BallEnds ends;
  if (is_zero) {
    ends = stop(edge, *zero);
  } else if (is_simple(end->cell)) {
    ends = rise_from_cell(end->cell, end->level);
  } else {
    ends = rise(contacts_at(edge, end->level), end->level);
  }
  known_.emplace(std::pair(edge.balls, is_zero), ends);
  return ends;
}

// Where the probe touches all of the contacts: at a peak, or it goes on across the farthest facet of their hull.
BallEnds BallAscents::stop(const BallEdge& edge, const BallLevel& level) {
  const Ids contacts = contacts_at(edge, level);
  if (contacts.size() == 4) return stop_among(contacts, edge, level);
  for (const auto& [known, ends] : stops_[contacts]) {
    if (compare(balls_, known, level) == 0) return ends;
  }
  const BallEnds ends = stop_among(contacts, edge, level);
  stops_[contacts].emplace_back(level, ends);
  return ends;
}

BallEnds BallAscents::stop_among(const Ids& contacts, const BallEdge& edge, const BallLevel& level) {
  const std::vector<Beyond> beyond = farthest(edge, hull(edge, contacts, level), level);
  if (beyond.empty()) return {peak(edge, contacts, level)};
  const std::uint32_t cell = contacts.size() == 4 ? edge.cells[0] : BallDiagram::kNone;
  std::set<Ids> planes;
  BallEnds ends;
  for (const Beyond& one : beyond) {
    Ids plane;
    for (const std::uint32_t id : contacts) {
      const bool is_corner = std::ranges::find(one.facet, id) != one.facet.end();
      if (is_corner || (contacts.size() > 4 && side_of(balls_, one.facet, id) == 0)) plane.push_back(id);
    }
    if (planes.insert(plane).second) merge(ends, slide(one.facet, plane, contacts, level, cell));
  }
  return ends;
}

std::uint32_t BallAscents::peak(const BallEdge& edge, const Ids& contacts, const BallLevel& level) const {
  const auto is_as_near = [&](std::uint32_t id) {
    return at(lead_of<Rational>(edge, id), level.exact(balls_)).sign() == 0;
  };
  return peak_of_.at(with_hidden(balls_, contacts, is_as_near));
}

// Of the facets beyond which the edge's point is, or in whose planes, those that it is farthest beyond.
std::vector<BallAscents::Beyond> BallAscents::farthest(const BallEdge& edge, const std::vector<Three>& facets,
                                                       const BallLevel& level) const {
  const auto far_of = [&]<class Number>(const Three& facet) {
    const Touching<Number> made = touching_of<Number>(edge);
    const Plane<Number> plane = plane_of<Number>(balls_, facet);
    const Vector3<Number> from = number_ball<Number>(balls_, edge.balls[0]).center - plane.through;
    return std::pair<Number, Number>(dot(from + made.a, plane.normal), dot(made.b, plane.normal));
  };
  const auto compare_squares = [&](const Beyond& one, const Beyond& two) {
    const int sign = (one.far * one.far * two.squared_size - two.far * two.far * one.squared_size).certain_sign();
    if (sign != 0) return sign;
    const auto square = [&](const Three& facet) {
      const QuadraticNumber far = at(far_of.template operator()<Rational>(facet), level.exact(balls_));
      const Vector3<Rational> n = plane_of<Rational>(balls_, facet).normal;
      return far * far / QuadraticNumber(dot(n, n));
    };
    return (square(one.facet) - square(two.facet)).sign();
  };
  std::vector<Beyond> farthest;
  for (const Three& facet : facets) {
    if (sign_at(level, [&]<class Number>() { return far_of.template operator()<Number>(facet); }) < 0) continue;
    const Vector3<BoundedDouble> n = plane_of<BoundedDouble>(balls_, facet).normal;
    const Beyond one { facet, at(far_of.template operator()<BoundedDouble>(facet), level.near()), dot(n, n) };
    const int order = farthest.empty() ? 1 : compare_squares(one, farthest[0]);
    if (order > 0) farthest.clear();
    if (order >= 0) farthest.push_back(one);
  }
  return farthest;
}

// The edges along which the room grows fastest: d/ds of |x-p|^2 - (r+s)^2 is 2 (c1 + c2 s). All of them begin in one
// point: where two have the same direction b, they are the same way, and one is taken.
std::vector<BallEdge> BallAscents::steepest(const std::vector<BallEdge>& above, const BallLevel& level) const {
  std::vector<BallEdge> best;
  const auto is_known = [&](const BallEdge& edge) {
    const Vector3<Rational>& b = touching_of<Rational>(edge).b;
    return std::ranges::any_of(best, [&](const BallEdge& other) {
      const Vector3<Rational>& c = touching_of<Rational>(other).b;
      return b.x == c.x && b.y == c.y && b.z == c.z;
    });
  };
  for (const BallEdge& edge : above) {
    const auto more = [&]<class Number>() {
      const Touching<Number>&one = touching_of<Number>(edge), &two = touching_of<Number>(best[0]);
      return std::pair<Number, Number>(one.c1 - two.c1, one.c2 - two.c2);
    };
    const int order = best.empty() ? 1 : sign_at(level, more);
    if (order > 0) best.clear();
    if (order > 0 || (order == 0 && !is_known(edge))) best.push_back(edge);
  }
  return best;
}

// ---- The diagram ----

BallEdge BallAscents::edge_of(std::uint32_t cell, std::size_t corner) const {
  const BallDiagram::Corners& corners = diagram_.cells()[cell];
  BallEdge edge;
  for (std::size_t k = 0, place = 0; k < 5; ++k) {
    if (k != corner) edge.balls[place++] = corners[k];
  }
  edge.near = touching<BoundedDouble>(balls_, edge.balls);
  edge.cells[0] = cell;
  edge.opposite[0] = corners[corner];
  const std::uint32_t other =
      corners[corner] == BallDiagram::kNone ? BallDiagram::kNone : diagram_.adjacent()[cell][corner];
  if (other == BallDiagram::kNone) return edge;
  edge.cells[1] = other;
  for (const std::uint32_t id : diagram_.cells()[other]) {
    if (std::ranges::find(edge.balls, id) == edge.balls.end()) edge.opposite[1] = id;
  }
  return edge;
}

bool BallAscents::is_in_space(const BallEdge& edge) const {
  return edge.near || side_of(balls_, {edge.balls[0], edge.balls[1], edge.balls[2]}, edge.balls[3]) != 0;
}

// The edges of the diagram whose balls are all among these.
std::vector<BallEdge> BallAscents::edges_among(const Ids& contacts) const {
  std::vector<BallEdge> found;
  const auto see_cell = [&](std::uint32_t cell) {
    const BallDiagram::Corners& corners = diagram_.cells()[cell];
    std::size_t count = 0, outer = 4;
    for (std::size_t k = 0; k < 5; ++k) {
      if (contains(contacts, corners[k])) {
        ++count;
      } else {
        outer = k;
      }
    }
    if (count < 4) return;
    for (std::size_t k = 0; k < 5; ++k) {
      if (count == 4 && k != outer) continue;
      // The cell behind has the edge, too, and is seen as well. No cell has the greatest number.
      if (corners[k] != BallDiagram::kNone && diagram_.adjacent()[cell][k] < cell) continue;
      BallEdge edge = edge_of(cell, k);
      if (is_in_space(edge)) found.push_back(std::move(edge));
    }
  };
  if (contacts.size() == 4) {
    const std::uint32_t rarest =
        *std::ranges::min_element(contacts, {}, [&](std::uint32_t id) { return diagram_.star(id).size(); });
    for (const std::uint32_t cell : diagram_.star(rarest)) {
      see_cell(cell);
      if (!found.empty()) break;
    }
    return found;
  }
  std::set<std::uint32_t> cells;
  for (const std::uint32_t id : contacts) cells.insert(diagram_.star(id).begin(), diagram_.star(id).end());
  for (const std::uint32_t cell : cells) see_cell(cell);
  return found;
}

// Whether the edge has points just above the level, or just below it. It has one at the level.
bool BallAscents::reaches(const BallEdge& edge, const BallLevel& level, Side side) const {
  return std::ranges::all_of(edge.opposite, [&](std::uint32_t id) {
    if (id == BallDiagram::kNone) return true;
    if (at(lead_of<BoundedDouble>(edge, id), level.near()).certain_sign() > 0) return true;
    const auto exact = lead_of<Rational>(edge, id);
    if (at(exact, level.exact(balls_)).sign() > 0) return true;
    return side == Side::kAbove ? exact.second >= 0 : exact.second <= 0;
  });
}

// Whether the cell's vertex has no other contacts than its five balls, where doubles tell it: then no cell behind it
// has the same vertex.
bool BallAscents::is_simple(std::uint32_t cell) const {
  std::int8_t& answer = simple_[cell];
  if (answer != 0) return answer > 0;
  answer = -1;
  const BallDiagram::Corners& corners = diagram_.cells()[cell];
  BallEdge edge;
  BoundedDouble s(0, HUGE_VAL);
  for (std::size_t k = 0; k < 5 && !(s.error < HUGE_VAL); ++k) {
    edge = edge_of(cell, k);
    const auto [first, second] = lead_of<BoundedDouble>(edge, corners[k]);
    if (second.certain_sign() != 0) s = -first / second;
  }
  for (const std::uint32_t other : diagram_.adjacent()[cell]) {
    if (other == BallDiagram::kNone) continue;
    for (const std::uint32_t id : diagram_.cells()[other]) {
      if (std::ranges::find(corners, id) != corners.end()) continue;
      if (at(lead_of<BoundedDouble>(edge, id), s).certain_sign() <= 0) return false;
    }
  }
  answer = 1;
  return true;
}

// Whether doubles tell that the four balls alone are contacts. Between its ends an edge has the same contacts
// everywhere, and each end has these, too.
bool BallAscents::has_four_contacts(const BallEdge& edge, const BallLevel& level) const {
  const auto is_behind = [&](std::uint32_t id) {
    return id == BallDiagram::kNone || at(lead_of<BoundedDouble>(edge, id), level.near()).certain_sign() > 0;
  };
  if (diagram_.dimension() < 4 || !std::ranges::all_of(edge.opposite, is_behind)) return false;
  return std::ranges::any_of(edge.cells,
                             [&](std::uint32_t cell) { return cell != BallDiagram::kNone && is_simple(cell); });
}

std::optional<BallAscents::End> BallAscents::end_above(const BallEdge& edge) const {
  std::optional<End> end;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t id = edge.opposite[k];
    if (id == BallDiagram::kNone) continue;
    const auto [near_first, near_second] = lead_of<BoundedDouble>(edge, id);
    const int sign = near_second.certain_sign();
    if (sign > 0) continue;
    std::optional<BallLevel> found;
    if (sign < 0) {
      found = BallLevel(edge.balls, id, -near_first / near_second);
    } else {
      const auto [first, second] = lead_of<Rational>(edge, id);
      if (second >= 0) continue;
      found = BallLevel(edge.balls, id, bounded(Rational(-first / second)));
    }
    if (!end || compare(balls_, *found, end->level) < 0) end = End{edge.cells[k], *found};
  }
  return end;
}

// The first level above this one where the probe touches all four. At the level it does not touch them.
std::optional<BallLevel> BallAscents::zero_above(const BallEdge& edge, const BallLevel& level) const {
  const Touching<BoundedDouble> near = touching_of<BoundedDouble>(edge);
  const int opening = near.c2.certain_sign();
  const auto [discriminant, roots_near] = bounded_roots(near);
  if (opening > 0 && discriminant < 0) return std::nullopt;
  if (roots_near) {
    // (-c1 - root) / c2. The other root is not above the level, or is not the first one.
    const BoundedDouble zero = (*roots_near)[0];
    const int order = (zero - level.near()).certain_sign();
    if (order > 0) return BallLevel(edge.balls, 4, 0, zero);
    if (order < 0 && opening > 0) return std::nullopt;
  }
  const auto made = touching_of<Rational>(edge);
  const std::vector<QuadraticNumber> roots = roots_of({made.c2, made.c1, made.c0});
  std::optional<std::size_t> least;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (roots[k] > level.exact(balls_) && (!least || roots[k] < roots[*least])) least = k;
  }
  if (!least) return std::nullopt;
  return BallLevel(edge.balls, 4, *least, bounded(roots[*least]));
}

// The visible balls that are equally far, in power, as the edge's. They are neighbours of each other.
Ids BallAscents::contacts_at(const BallEdge& edge, const BallLevel& level) const {
  Ids contacts(edge.balls.begin(), edge.balls.end());
  if (has_four_contacts(edge, level)) return contacts;
  ++searches_;
  for (const std::uint32_t id : contacts) seen_[id] = searches_;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    for (const std::uint32_t id : diagram_.neighbours(contacts[k])) {
      if (std::exchange(seen_[id], searches_) == searches_) continue;
      if (sign_at(level, [&]<class Number>() { return lead_of<Number>(edge, id); }) == 0) contacts.push_back(id);
    }
  }
  std::ranges::sort(contacts);
  return contacts;
}

// The triangles of the hull of the contacts' centres, with normals that point outwards.
std::vector<Three> BallAscents::hull(const BallEdge& edge, const Ids& contacts, const BallLevel& level) const {
  std::map<Three, std::pair<int, std::uint32_t>> triangles;  // how often, and what is opposite
  const auto add = [&](const BallEdge& one) {
    for (std::size_t out = 0; out < 4; ++out) {
      Three three{};
      for (std::size_t k = 0, place = 0; k < 4; ++k) {
        if (k != out) three[place++] = one.balls[k];
      }
      auto& [count, opposite] = triangles[three];
      ++count;
      opposite = one.balls[out];
    }
  };
  if (contacts.size() == 4) {
    add(edge);
  } else {
    for (const BallEdge& one : edges_among(contacts)) {
      if (reaches(one, level, Side::kBelow)) add(one);
    }
  }
  std::vector<Three> facets;
  for (const auto& [three, inside] : triangles) {
    if (inside.first != 1) continue;
    const auto& [a, b, c] = three;
    facets.push_back(side_of(balls_, three, inside.second) < 0 ? three : Three{a, c, b});
  }
  return facets;
}

}  // namespace flowcert::morse
