// Why the ways never leave {d > d(w)}: with each step the level grows, or it stays and the least power grows. The least
// power is never negative, so that d(x) is at least the level. At the level d(w) it is 0 at w alone.
//
// Vertices that wait are kept in a list, so that where ways of equal merit come together they go on as one.
#include "oracle/ball_ends.h"

#include <algorithm>
#include <stdexcept>

namespace oracle {

namespace {

// A vertex of the power diagram at the level: the centres of the balls with the least power span space.
struct Vertex {
  Places contacts;  // these balls, but hidden ones
  QuadraticPoint position;
  Quadratic level;

  friend bool operator==(const Vertex& one, const Vertex& other) {
    return one.contacts == other.contacts && one.level == other.level;
  }
};

// A facet of the convex hull of the contacts' centres.
struct Facet {
  Places corners;  // all contacts on it
  Point normal;    // outward
};

}  // namespace

Point normal_of(const std::vector<Point>& edges) {
  const std::vector<Point> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (edges.empty()) return axes[0];
  if (edges.size() == 2) return cross(edges[0], edges[1]);
  const Point first = cross(edges[0], axes[0]);
  return first == Point{0, 0, 0} ? axes[1] : first;
}

namespace {

class EndSearch {
 public:
  EndSearch(const std::vector<Ball>& balls, const std::vector<BallPoint>& all)
      : balls_(balls), all_(all), visible_(visible_balls(balls)) {}

  // From w in the direction, which is normal to the plane of its contacts.
  Ends ends(const BallPoint& w, const Point& direction) {
    go_to(slide(w.position, w.value, w.contacts[0], direction));
    return all_ends();
  }

  // The way along the line is the same from its foot, which is rational.
  std::optional<Ends> ends_from(const Start& start, const Rational& level) {
    vertices_.clear();
    ends_.clear();
    Vertex at{{}, moved(start.foot, Quadratic(), start.direction), level};
    std::set_intersection(start.contacts.begin(), start.contacts.end(), visible_.begin(), visible_.end(),
                          std::back_inserter(at.contacts));
    if (dimension(at) == 3) {
      at.position = moved(start.foot, start.height, start.direction);
      stop(at);
    } else {
      for (const std::size_t ball : at.contacts) {
        if (dot(minus(centre(ball), centre(at.contacts[0])), start.direction) != 0) return std::nullopt;
      }
      go_to(slide_into_space(at, start.direction));
    }
    all_ends();
    // One end is that of all ways.
    for (std::size_t k = 0; k < vertices_.size() && ends_.size() == 1; ++k) known_.emplace_back(vertices_[k], ends_);
    return ends_;
  }

 private:
  Ends all_ends() {
    for (std::size_t next = 0; next < vertices_.size(); ++next) rise(Vertex(vertices_[next]));
    return ends_;
  }

  // ---- The diagram ----

  const Point& centre(std::size_t ball) const { return balls_[ball].centre; }

  Vertex vertex(const QuadraticPoint& x, const Quadratic& level) const {
    Vertex result{{}, x, level};
    std::optional<Quadratic> least;
    for (const std::size_t ball : visible_) {
      const Quadratic here = power(balls_[ball], x, level);
      if (least && here > *least) continue;
      if (least && here < *least) result.contacts.clear();
      least = here;
      result.contacts.push_back(ball);
    }
    return result;
  }

  int dimension(const Vertex& at) const { return affine_dimension(centres(select(balls_, at.contacts))); }

  // Orthogonal to the contacts' hull, which has dimension 1 or 2. The place is rational.
  Point away_from_contacts(const Vertex& at) const {
    const std::vector<Point> edges = edges_of(spanning_subset(centres(select(balls_, at.contacts))));
    const Point& corner = centre(at.contacts[0]);
    const Point way = minus(Point{at.position[0].a, at.position[1].a, at.position[2].a}, corner);
    if (edges.size() == 2) {
      const Point normal = cross(edges[0], edges[1]);
      return dot(way, normal) < 0 ? scaled(normal, -1) : normal;
    }
    const Point away = moved(way, -dot(way, edges[0]) / dot(edges[0], edges[0]), edges[0]);
    return away != Point{0, 0, 0} ? away : normal_of(edges);
  }

  // From x, to which no ball is nearer than `near`, to the first point where a ball that lies farther ahead is as near.
  // Nothing if there is none. At x + y n the power of q less that of p is less than at x by 2 y <q - p, n>.
  std::optional<Vertex> slide(const QuadraticPoint& x, const Quadratic& level, std::size_t near,
                              const Point& direction) const {
    std::optional<Quadratic> first;
    const Quadratic here = power(balls_[near], x, level);
    for (const std::size_t ball : visible_) {
      const Rational ahead = dot(minus(centre(ball), centre(near)), direction);
      if (ahead <= 0) continue;
      const Quadratic meeting = (power(balls_[ball], x, level) - here) / (2 * ahead);
      if (!first || meeting < *first) first = meeting;
    }
    if (!first) return std::nullopt;
    return vertex(moved(x, *first, direction), level);
  }

  std::optional<Vertex> slide_into_space(Vertex at, Point direction) const {
    while (const auto next = slide(at.position, at.level, at.contacts[0], direction)) {
      if (dimension(*next) == 3) return next;
      at = *next;
      direction = away_from_contacts(at);
    }
    return std::nullopt;
  }

  // ---- Rise: along edges of the diagram in four dimensions, to higher levels ----

  // By how much the power of another ball is greater than that of the four balls of an edge: at_0 + level * slope.
  struct Lead {
    Rational at_0, slope;

    Quadratic at(const Quadratic& level) const { return level * slope + at_0; }
  };
  static Lead lead(const EquallyFar& edge, const Ball& other) {
    const Ball& corner = edge.simplex[0];
    const Point way = minus(other.centre, corner.centre);
    return {dot(way, way) - 2 * dot(minus(edge.start, corner.centre), way) + corner.radius * corner.radius -
                other.radius * other.radius,
            2 * (corner.radius - other.radius) - 2 * dot(edge.velocity, way)};
  }

  // Whether no ball is nearer than the four, for all levels just above this one.
  bool leads_on(const EquallyFar& edge, const Quadratic& level) const {
    return std::all_of(visible_.begin(), visible_.end(), [&](std::size_t ball) {
      const Lead other = lead(edge, balls_[ball]);
      const int sign = other.at(level).sign();
      return sign > 0 || (sign == 0 && other.slope >= 0);
    });
  }

  // How fast the power grows along the edge: the derivative of |x(s) - p|^2 - (r + s)^2.
  static Quadratic rate(const EquallyFar& edge, const Quadratic& level) {
    const Ball& corner = edge.simplex[0];
    return (dot(minus(edge.at(level), corner.centre), edge.velocity) - level - corner.radius) * Rational(2);
  }

  // The edges from the vertex along which the power grows fastest.
  std::vector<EquallyFar> steepest_edges(const Vertex& from) const {
    std::vector<EquallyFar> best;
    for_each_subset(from.contacts.size(), 4, [&](const Places& subset) {
      if (subset.size() < 4) return;
      const auto edge = equally_far(select(balls_, select(from.contacts, subset)));
      if (!edge || !leads_on(*edge, from.level)) return;
      const auto order =
          best.empty() ? std::strong_ordering::greater : rate(*edge, from.level) <=> rate(best[0], from.level);
      if (order > 0) best.clear();
      if (order >= 0) best.push_back(*edge);
    });
    return best;
  }

  void rise(const Vertex& from) {
    const std::vector<EquallyFar> edges = steepest_edges(from);
    if (edges.empty()) throw std::logic_error("no edge leads on from a vertex of the power diagram");
    for (const EquallyFar& edge : edges) follow(edge, from.level);
  }

  // To the first level where the power is 0, or a further ball is as near. A ball with a negative slope is farther at
  // the level where the edge begins, as the edge leads on from there.
  void follow(const EquallyFar& edge, const Quadratic& level) {
    std::optional<Quadratic> zero, end;
    for (const Quadratic& each : edge.zeros()) {
      if (each > level && !zero) zero = each;
    }
    for (const std::size_t ball : visible_) {
      const Lead other = lead(edge, balls_[ball]);
      if (other.slope >= 0) continue;
      const Quadratic meeting = -other.at_0 / other.slope;
      if (!end || meeting < *end) end = meeting;
    }
    if (zero && (!end || *zero <= *end)) return stop(vertex(edge.at(*zero), *zero));
    go_to(end ? std::optional(vertex(edge.at(*end), *end)) : std::nullopt);
  }

  // ---- Stop: where the power is 0, the probe touches the contacts ----

  // Here is a peak, or the way goes on across the farthest of the facets whose planes do not have x strictly inside.
  void stop(const Vertex& at) {
    std::vector<Facet> farthest;
    for (const Facet& facet : facets(at.contacts)) {
      if (beyond(at, facet).sign() < 0) continue;
      const auto order = farthest.empty() ? std::strong_ordering::greater
                                          : squared_distance_to(at, facet) <=> squared_distance_to(at, farthest[0]);
      if (order > 0) farthest.clear();
      if (order >= 0) farthest.push_back(facet);
    }
    if (farthest.empty()) ends_.insert(peak(at));
    for (const Facet& facet : farthest) go_to(slide(at.position, at.level, facet.corners[0], facet.normal));
  }

  // All triples whose plane has the other contacts on one side; each facet once.
  std::vector<Facet> facets(const Places& contacts) const {
    std::vector<Facet> found;
    for_each_subset(contacts.size(), 3, [&](const Places& subset) {
      if (subset.size() < 3) return;
      const auto [a, b, c] = std::array{contacts[subset[0]], contacts[subset[1]], contacts[subset[2]]};
      const Point normal = cross(minus(centre(b), centre(a)), minus(centre(c), centre(a)));
      if (normal == Point{0, 0, 0}) return;
      bool is_one_above = false, is_one_below = false;
      Facet facet{{}, normal};
      for (const std::size_t ball : contacts) {
        const Rational height = dot(minus(centre(ball), centre(a)), normal);
        is_one_above |= height > 0;
        is_one_below |= height < 0;
        if (height == 0) facet.corners.push_back(ball);
      }
      if (is_one_above && is_one_below) return;
      if (is_one_above) facet.normal = scaled(normal, -1);
      const auto is_same = [&](const Facet& other) { return other.corners == facet.corners; };
      if (std::none_of(found.begin(), found.end(), is_same)) found.push_back(facet);
    });
    return found;
  }

  // The distance from the facet's plane, times the length of its normal; positive outside of the hull.
  Quadratic beyond(const Vertex& at, const Facet& facet) const {
    return dot(minus(at.position, centre(facet.corners[0])), facet.normal);
  }

  Quadratic squared_distance_to(const Vertex& at, const Facet& facet) const {
    return beyond(at, facet) * beyond(at, facet) / dot(facet.normal, facet.normal);
  }

  // The index-3 point that has these contacts, hidden balls left out.
  std::size_t peak(const Vertex& at) const {
    for (std::size_t place = 0; place < all_.size(); ++place) {
      Places seen;
      std::set_intersection(all_[place].contacts.begin(), all_[place].contacts.end(), visible_.begin(), visible_.end(),
                            std::back_inserter(seen));
      if (all_[place].index == 3 && seen == at.contacts) return place;
    }
    throw std::logic_error("a way stops inside of its contacts where there is no index-3 point");
  }

  // ---- What waits ----

  // Without a vertex the way goes on without end.
  void go_to(const std::optional<Vertex>& next) {
    if (!next) ends_.insert(all_.size());
    const auto known = std::find_if(known_.begin(), known_.end(), [&](const auto& each) { return next == each.first; });
    if (known != known_.end()) {
      ends_.insert(known->second.begin(), known->second.end());
      return;
    }
    if (next && std::find(vertices_.begin(), vertices_.end(), *next) == vertices_.end()) vertices_.push_back(*next);
  }

  const std::vector<Ball>& balls_;
  const std::vector<BallPoint>& all_;
  Places visible_;
  std::vector<Vertex> vertices_;  // all that ways have come to, with positive power
  Ends ends_;
  std::vector<std::pair<Vertex, Ends>> known_;
};

}  // namespace

std::vector<std::optional<Ends>> ends_from(const std::vector<Ball>& balls, const std::vector<BallPoint>& all,
                                           const std::vector<Start>& starts, const Rational& s) {
  EndSearch search(balls, all);
  std::vector<std::optional<Ends>> ends;
  for (const Start& start : starts) ends.push_back(search.ends_from(start, s));
  return ends;
}

std::array<Ends, 2> ends_of(const std::vector<Ball>& balls, const std::vector<BallPoint>& all, const BallPoint& w) {
  const std::vector<Point> plane = spanning_subset(centres(select(balls, w.contacts)));
  const Point normal = cross(minus(plane[1], plane[0]), minus(plane[2], plane[0]));
  return {EndSearch(balls, all).ends(w, normal), EndSearch(balls, all).ends(w, scaled(normal, -1))};
}

}  // namespace oracle
