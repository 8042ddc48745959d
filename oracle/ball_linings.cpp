// The places with d = s on the sphere of a ball are what is left of it where others' balls cut it, along circles. Each
// connected part of them is the whole sphere, or has a whole circle, or a place where two circles meet. So the places
// of each three spheres, and any of each two and of each one, are enough. A part lies in one component of {d >= s}.
#include "oracle/ball_linings.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "oracle/pore_rooms.h"

namespace oracle {

namespace {

// The components of {d >= s}, by leaf.
Components components_of(const Pores& found, const Rational& s) {
  Components components(found.points.size() + 1);
  for (std::size_t leaf = 0; leaf < components.size(); ++leaf) components[leaf] = leaf;
  for (const auto& links : links_by_value(found)) {
    if (found.points[links[0].point].value < s) break;
    for (const Link& link : links) join(components, link.ends);
  }
  return components;
}

Rational rational_power(const Ball& ball, const Point& x, const Rational& s) {
  return squared_distance(x, ball.centre) - (ball.radius + s) * (ball.radius + s);
}

}  // namespace

std::vector<Places> cavity_linings(const std::vector<Ball>& balls, const Pores& found, const Rational& probe) {
  const Components components = components_of(found, probe);
  std::vector<Start> starts;
  for_each_subset(balls.size(), 3, [&](const Places& subset) {
    const auto simplex = equally_far(select(balls, subset));
    if (!simplex) return;
    const Point foot = moved(simplex->start, probe, simplex->velocity);
    const Rational low = rational_power(simplex->simplex[0], foot, probe);
    if (low > 0) return;
    const Point normal = normal_of(edges_of(centres(simplex->simplex)));
    const Rational squared_height = -low / dot(normal, normal);
    std::vector<Quadratic> powers;  // |foot + h n - p|^2 - (r + s)^2, where |h n|^2 is -low
    for (const Ball& ball : balls) {
      const Rational along = 2 * dot(minus(foot, ball.centre), normal);
      powers.emplace_back(rational_power(ball, foot, probe) - low, along, squared_height);
    }
    for (const int side : {1, -1}) {
      Start start{foot, Quadratic(0, 1, squared_height), scaled(normal, side), {}};
      bool is_free = true;
      for (std::size_t ball = 0; ball < balls.size() && is_free; ++ball) {
        const int sign = Quadratic(powers[ball].a, side * powers[ball].b, squared_height).sign();
        is_free = sign >= 0;
        if (sign == 0) start.contacts.push_back(ball);
      }
      if (is_free) starts.push_back(start);
    }
  });
  const std::vector<std::optional<Ends>> ends = ends_from(balls, found.points, starts, probe);
  std::map<std::size_t, std::set<std::size_t>> linings;  // by component
  for (std::size_t k = 0; k < starts.size(); ++k) {
    if (!ends[k]) continue;
    const Places at = components_at(components, *ends[k]);
    if (at.size() != 1) throw std::logic_error("ends of one place in several components");
    linings[at[0]].insert(starts[k].contacts.begin(), starts[k].contacts.end());
  }
  linings.erase(components.back());
  std::vector<Places> result;
  for (const auto& [component, lining] : linings) result.emplace_back(lining.begin(), lining.end());
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace oracle
