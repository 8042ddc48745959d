// By how much more a corner is away from one sample than from another is linear in homogeneous coordinates.
#include "oracle/corners.h"

#include <algorithm>

namespace oracle {

namespace {

// The corner at (1 - time) a + time b, in homogeneous coordinates.
Corner mixed(const Corner& a, const Corner& b, const Rational& time) {
  const Point sum = moved(a.position, time, minus(b.position, a.position));
  const Rational weight = (a.at_infinity ? Rational(0) : Rational(1 - time)) + (b.at_infinity ? Rational(0) : time);
  if (weight == 0) return {as_direction(sum), true};
  return {{sum[0] / weight, sum[1] / weight, sum[2] / weight}, false};
}

// By how much more a corner is away from q than from p, squared. At infinity, how fast that grows. This is linear in
// homogeneous coordinates.
Rational lead_of(const Corner& x, const Point& p, const Point& q) {
  if (x.at_infinity) return 2 * dot(x.position, minus(p, q));
  return squared_distance(x.position, q) - squared_distance(x.position, p);
}

}  // namespace

Point way_to(const Corner& corner, const Point& m) {
  return corner.at_infinity ? corner.position : minus(corner.position, m);
}

bool in_line(const Corner& a, const Point& m, const Corner& b) { return cross(way_to(a, m), way_to(b, m)) == Point{}; }

Point between(const Corner& a, const Corner& b) {
  if (b.at_infinity) return moved(a.position, 1, b.position);
  if (a.at_infinity) return moved(b.position, 1, a.position);
  return moved(a.position, Rational(1, 2), minus(b.position, a.position));
}

std::vector<Corner> clipped(const std::vector<Corner>& polygon, const Point& p, const Point& q) {
  std::vector<Corner> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const Rational at_a = lead_of(a, p, q), at_b = lead_of(b, p, q);
    if (at_a >= 0) result.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) result.push_back(mixed(a, b, at_a / (at_a - at_b)));
  }
  return result;
}

std::vector<Corner> canonical(std::vector<Corner> polygon) {
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if (polygon.back() < polygon[1]) std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

}  // namespace oracle
