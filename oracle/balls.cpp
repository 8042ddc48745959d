// Where the powers of two balls p and q are equal, the terms |x|^2 and s^2 cancel: 2 <x - p, q - p> is |q - p|^2 +
// r_p^2 - r_q^2 + 2 (r_p - r_q) s. So a simplex of balls has its point of equal powers at a place that moves with
// constant velocity, and its power is 0 at the roots of a quadratic.
#include "oracle/balls.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace oracle {

namespace {

bool is_inside(const Ball& inner, const Ball& outer) {
  const Rational reach = outer.radius - inner.radius;
  return reach >= 0 && squared_distance(inner.centre, outer.centre) <= reach * reach;
}

// x is in the affine hull of the simplex, whose centres are affinely independent.
bool is_in_relative_interior(const std::vector<Point>& simplex, const QuadraticPoint& x) {
  const std::vector<Point> dual = dual_basis(edges_of(simplex)).value();
  Quadratic first_weight = Rational(1);
  for (const Point& vector : dual) {
    const Quadratic weight = dot(minus(x, simplex[0]), vector);
    if (weight.sign() <= 0) return false;
    first_weight = first_weight - weight;
  }
  return first_weight.sign() > 0;
}

// The balls that x touches when they have grown by s. Nothing iff x is inside of one.
std::optional<Places> contacts(const std::vector<Ball>& balls, const Touching& x) {
  Places contacts;
  for (std::size_t place = 0; place < balls.size(); ++place) {
    const int sign = power(balls[place], x.position, x.s).sign();
    if (sign < 0) return std::nullopt;
    if (sign == 0) contacts.push_back(place);
  }
  return contacts;
}

// A point with its contacts, and an affinely independent set of centres that spans all simplices of contacts around it.
struct Candidate {
  Touching touching;
  std::vector<Point> span;
};

// At most one point in the hull of its contacts has these contacts, for the reason at touching_inside(). The simplices
// that it is inside of span the face of the hull that it is inside of (face_dimension in exact_geometry.cpp). So it is
// in the relative interior iff they span as much as the contacts do. A critical point is inside of one simplex at
// least.
class Search {
 public:
  explicit Search(const std::vector<Ball>& balls) : balls_(balls) {}

  void see(const Places& subset) {
    const std::vector<Ball> simplex = select(balls_, subset);
    const auto touching = touching_inside(simplex);
    if (!touching || touching->s.sign() < 0) return;
    const auto contact = contacts(balls_, *touching);
    if (!contact) return;
    Candidate& candidate = candidates_.try_emplace(*contact, Candidate{*touching, {}}).first->second;
    for (const Ball& ball : simplex) candidate.span.push_back(ball.centre);
    candidate.span = spanning_subset(candidate.span);
  }

  std::vector<BallPoint> points() const {
    std::vector<BallPoint> points;
    for (const auto& [contact, candidate] : candidates_) {
      const int index = affine_dimension(centres(select(balls_, contact)));
      if (affine_dimension(candidate.span) != index) continue;
      points.push_back({index, contact, candidate.touching.s, candidate.touching.position});
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const BallPoint& one, const BallPoint& other) { return one.value > other.value; });
    return points;
  }

 private:
  const std::vector<Ball>& balls_;
  std::map<Places, Candidate> candidates_;
};

}  // namespace

// Two different balls are not inside of each other.
Places visible_balls(const std::vector<Ball>& balls) {
  Places visible;
  for (std::size_t one = 0; one < balls.size(); ++one) {
    bool is_hidden = false;
    for (std::size_t other = 0; other < balls.size(); ++other) {
      const bool are_equal = is_inside(balls[one], balls[other]) && is_inside(balls[other], balls[one]);
      is_hidden |= are_equal ? other < one : is_inside(balls[one], balls[other]);
    }
    if (!is_hidden) visible.push_back(one);
  }
  return visible;
}

std::vector<Point> centres(const std::vector<Ball>& balls) {
  std::vector<Point> result;
  for (const Ball& ball : balls) result.push_back(ball.centre);
  return result;
}

Quadratic power(const Ball& ball, const QuadraticPoint& x, const Quadratic& s) {
  const QuadraticPoint from_centre = minus(x, ball.centre);
  const Quadratic reach = s + ball.radius;
  return dot(from_centre, from_centre) - reach * reach;
}

std::optional<EquallyFar> equally_far(const std::vector<Ball>& simplex) {
  if (simplex.empty()) return std::nullopt;
  const std::vector<Point> edges = edges_of(centres(simplex));
  const auto dual = dual_basis(edges);
  if (!dual) return std::nullopt;
  const Rational& first = simplex[0].radius;
  EquallyFar result{simplex, simplex[0].centre, {}};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Rational& radius = simplex[i + 1].radius;
    const Rational at_0 = (dot(edges[i], edges[i]) + first * first - radius * radius) / 2;
    result.start = moved(result.start, at_0, (*dual)[i]);
    result.velocity = moved(result.velocity, first - radius, (*dual)[i]);
  }
  return result;
}

// |start + s * velocity - p|^2 = (r + s)^2
std::vector<Quadratic> EquallyFar::zeros() const {
  const Point way = minus(start, simplex[0].centre);
  const Rational& radius = simplex[0].radius;
  return roots(dot(velocity, velocity) - 1, dot(way, velocity) - radius, dot(way, way) - radius * radius);
}

// There is at most one. The largest |x - p| - r of these balls is a convex function of x. Where x is such a point,
// x - p are the directions in which the terms grow, and they balance. So x is where the function is least, and that is
// one point: the function does not stay the same on a segment, as no |x - p| does.
std::optional<Touching> touching_inside(const std::vector<Ball>& simplex) {
  const auto line = equally_far(simplex);
  if (!line) return std::nullopt;
  for (const Quadratic& s : line->zeros()) {
    const bool has_grown =
        std::all_of(simplex.begin(), simplex.end(), [&](const Ball& ball) { return (s + ball.radius).sign() >= 0; });
    if (has_grown && is_in_relative_interior(centres(simplex), line->at(s))) return Touching{line->at(s), s};
  }
  return std::nullopt;
}

std::vector<BallPoint> critical_points(const std::vector<Ball>& balls) {
  Search search(balls);
  for_each_subset(balls.size(), 4, [&](const Places& subset) { search.see(subset); });
  return search.points();
}

std::vector<BallPoint> critical_points(const std::vector<Ball>& balls, const std::set<Places>& subsets) {
  Search search(balls);
  for (const Places& subset : subsets) search.see(subset);
  return search.points();
}

}  // namespace oracle
