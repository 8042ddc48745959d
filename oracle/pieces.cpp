// By how much more a corner is away from one sample than from another is linear in homogeneous coordinates.
#include "oracle/pieces.h"

#include <algorithm>

namespace oracle {

namespace {

// The corner at (1 - time) a + time b, in homogeneous coordinates.
Corner mixed(const Corner& a, const Corner& b, const Rational& time) {
  const Point sum = moved(a.position, time, minus(b.position, a.position));
  const Rational weight = (a.at_infinity ? Rational(0) : Rational(1 - time)) + (b.at_infinity ? Rational(0) : time);
  return weight == 0 ? Corner(as_direction(sum), true) : Corner(scaled(sum, 1 / weight));
}

// By how much more a corner is away from q than from p, squared. At infinity, how fast that grows. This is linear in
// homogeneous coordinates.
Rational lead_of(const Corner& x, const Point& p, const Point& q) {
  if (x.at_infinity) return 2 * dot(x.position, minus(p, q));
  return squared_distance(x.position, q) - squared_distance(x.position, p);
}

// The part of a convex region that is not nearer to q than to p.
std::vector<Corner> clipped(const std::vector<Corner>& region, const Point& p, const Point& q) {
  std::vector<Corner> result;
  for (const auto& [a, b] : sides_of(region)) {
    const Rational at_a = lead_of(a, p, q), at_b = lead_of(b, p, q);
    if (at_a >= 0) result.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) result.push_back(mixed(a, b, at_a / (at_a - at_b)));
  }
  return result;
}

}  // namespace

Direction as_direction(const Point& vector) {
  Rational largest = 0;
  for (const Rational& x : vector) largest = std::max(largest, Rational(abs(x)));
  return scaled(vector, 1 / largest);
}

bool is_unbounded(const Region& region) {
  return std::any_of(region.corners.begin(), region.corners.end(), [](const Corner& x) { return x.at_infinity; });
}

std::vector<std::pair<const Corner&, const Corner&>> sides_of(const std::vector<Corner>& corners) {
  std::vector<std::pair<const Corner&, const Corner&>> sides;
  sides.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) sides.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  return sides;
}

Point way_to(const Corner& corner, const Point& m) {
  return corner.at_infinity ? corner.position : minus(corner.position, m);
}

bool in_line(const Corner& a, const Point& m, const Corner& b) { return cross(way_to(a, m), way_to(b, m)) == Point{}; }

Point between(const Corner& a, const Corner& b) {
  if (b.at_infinity) return moved(a.position, 1, b.position);
  if (a.at_infinity) return moved(b.position, 1, a.position);
  return midpoint(a.position, b.position);
}

std::vector<Corner> in_cell(const PointSet& set, std::size_t place, std::vector<Corner> region) {
  for (const Point& q : set.points) region = clipped(region, set.points[place], q);
  return region;
}

std::vector<Corner> canonical(std::vector<Corner> region) {
  std::rotate(region.begin(), std::min_element(region.begin(), region.end()), region.end());
  if (region.back() < region[1]) std::reverse(region.begin() + 1, region.end());
  return region;
}

// Seen from a point inside, all sides turn the same way.
bool is_in_region(const std::vector<Corner>& corners, const Point& axis, const Point& x, bool sides_count) {
  std::size_t left = 0, right = 0;
  for (const auto& [a, b] : sides_of(corners)) {
    const int side = dot(axis, cross(way_to(a, x), way_to(b, x))).sign();
    if (side > 0 || (side == 0 && sides_count)) ++left;
    if (side < 0 || (side == 0 && sides_count)) ++right;
  }
  return left == corners.size() || right == corners.size();
}

// If these directions are not the whole circle, an end of them is orthogonal to some sample, too.
Directions free_directions(const std::vector<Point>& samples, const Point& p0, const Point& p1) {
  const Point axis = minus(p1, p0);
  const auto is_free = [&](const Point& u) {
    return std::all_of(samples.begin(), samples.end(), [&](const Point& q) { return dot(u, minus(q, p0)) <= 0; });
  };
  const auto turned = [&](const Point& u) { return as_direction(cross(axis, u)); };  // by a quarter of the circle
  std::vector<Direction> ends;
  bool is_circle = true;
  for (const Point& q : samples) {
    const Point across = cross(axis, minus(q, p0));
    if (across == Point{}) continue;
    is_circle = false;
    for (const Point& u : {as_direction(across), as_direction(scaled(across, -1))}) {
      if (is_free(u) && std::find(ends.begin(), ends.end(), u) == ends.end()) ends.push_back(u);
    }
  }
  if (is_circle) {
    // A vector across the axis: the cross product with a unit vector along which the axis does not go.
    const Point a = turned(axis[0] != 0 || axis[1] != 0 ? Point{0, 0, 1} : Point{1, 0, 0}), b = turned(a);
    const Point c = turned(b), d = turned(c);
    return {{a, b, c, d}, {{a, b}, {b, c}, {c, d}, {d, a}}};
  }
  for (std::size_t i = 0; i < ends.size() && ends.size() == 2; ++i) {
    const Point &a = ends[i], &b = ends[1 - i], middle = turned(a);
    if (dot(axis, cross(a, b)) > 0) return {ends, {{a, b}}};
    if (b == scaled(a, -1) && is_free(middle)) return {{a, middle, b}, {{a, middle}, {middle, b}}};
  }
  return {ends, {}};
}

}  // namespace oracle
