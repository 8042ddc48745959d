// Starts of orbits; see orbit_starts.h for what they guarantee.
#include "fuzz/properties/orbit_starts.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <ostream>
#include <utility>

#include "geometry/contract.h"

namespace flowcert::property {
namespace {

using oracle::cross, oracle::midpoint, oracle::moved;
using oracle::Point;
using oracle::PointSet;
using oracle::Rational;

constexpr int kAttempts = 12;

// Gives the numbers of a choice, one after the other. After the last it begins again with the first, and changes
// them. A choice without numbers is like a single 0.
class Numbers {
 public:
  explicit Numbers(const StartChoice& choice) : numbers_(choice.numbers) {
    if (numbers_.empty()) numbers_.push_back(0);
  }

  std::size_t below(std::size_t bound) {
    const std::size_t round = next_ / numbers_.size();
    const std::size_t number = numbers_[next_ % numbers_.size()] + round * 40503;
    ++next_;
    return number % bound;
  }
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::size_t>(high - low + 1)));
  }

 private:
  std::vector<std::uint32_t> numbers_;
  std::size_t next_ = 0;
};

Rational largest_coordinate(const Point& a) {
  return std::max({Rational(abs(a[0])), Rational(abs(a[1])), Rational(abs(a[2]))});
}

// A vector along `direction`, about as long as `other`; zero if either is zero.
Point of_the_size_of(const Point& other, const Point& direction) {
  const Rational size = largest_coordinate(direction);
  return size == 0 ? direction : moved(Point{}, largest_coordinate(other) / size, direction);
}

// The places of the points that are nearest to this one, which comes first.
std::vector<std::size_t> places_around(const PointSet& set, std::size_t place, std::size_t count) {
  std::vector<std::pair<Rational, std::size_t>> all;
  all.reserve(set.points.size());
  for (std::size_t other = 0; other < set.points.size(); ++other) {
    all.emplace_back(oracle::squared_distance(set.points[place], set.points[other]), other);
  }
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < std::min(count, all.size()); ++k) {
    places.push_back(all[k].second);
  }
  return places;
}

// Different points, as many as there are. Of many points it takes such that are near each other.
std::vector<Point> some_points(const PointSet& set, Numbers& numbers, std::size_t count) {
  constexpr std::size_t kFewPoints = 12;
  const std::size_t first = numbers.below(set.points.size());
  if (count == 1) {
    return {set.points[first]};
  }
  const std::vector<std::size_t> candidates = places_around(set, first, kFewPoints);
  std::vector<std::size_t> places = {first};
  while (places.size() < std::min(count, candidates.size())) {
    std::size_t k = numbers.below(candidates.size());
    while (std::find(places.begin(), places.end(), candidates[k]) != places.end()) {
      k = (k + 1) % candidates.size();
    }
    places.push_back(candidates[k]);
  }
  return oracle::select(set.points, places);
}

struct Box {
  Point low;
  Point high;
};

Box bounding_box(const PointSet& set) {
  Box box{set.points.front(), set.points.front()};
  for (const Point& p : set.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  }
  return box;
}

// The part of the line x + t u on which no point is nearer than p. The line is equally far from p and from all other
// points that p stands for.
struct Stretch {
  std::optional<Rational> from;
  std::optional<Rational> to;

  [[nodiscard]] bool is_point() const { return from && to && *from == *to; }
};

std::optional<Stretch> stretch_of(const PointSet& set, const Point& p, const Point& x, const Point& u) {
  Stretch stretch;
  const Rational nearest = oracle::squared_distance(x, p);
  for (const Point& q : set.points) {
    // |x + t u - q|^2 - |x + t u - p|^2 = lead - 2 t approach.
    const Rational approach = oracle::dot(u, oracle::minus(q, p));
    const Rational lead = oracle::squared_distance(x, q) - nearest;
    if (approach == 0 && lead < 0) {
      return std::nullopt;
    }
    if (approach == 0) {
      continue;
    }
    const Rational bound = lead / (2 * approach);
    std::optional<Rational>& side = approach > 0 ? stretch.to : stretch.from;
    if (!side || (approach > 0 ? bound < *side : bound > *side)) {
      side = bound;
    }
    if (stretch.from && stretch.to && *stretch.from > *stretch.to) {
      return std::nullopt;
    }
  }
  return stretch;
}

Rational inside(const Stretch& stretch, Numbers& numbers) {
  if (stretch.from && stretch.to) {
    return *stretch.from + (*stretch.to - *stretch.from) * Rational(numbers.between(1, 7), 8);
  }
  if (stretch.from || stretch.to) {
    const Rational beyond(numbers.between(1, 12), 4);
    return stretch.from ? Rational(*stretch.from + beyond) : Rational(*stretch.to - beyond);
  }
  return {numbers.between(-6, 6), 4};
}

Point input_point_start(const PointSet& set, Numbers& numbers) { return some_points(set, numbers, 1).front(); }

Point nearby_start(const PointSet& set, Numbers& numbers) {
  Point x = input_point_start(set, numbers);
  const auto [low, high] = bounding_box(set);
  Rational reach = largest_coordinate(oracle::minus(high, low));
  reach = reach == 0 ? Rational(1) : reach;
  const std::int64_t denominator = numbers.between(1, 6);
  for (Rational& coordinate : x) {
    coordinate += reach * Rational(numbers.between(-6, 6), 8 * denominator);
  }
  return x;
}

Point box_start(const PointSet& set, Numbers& numbers) {
  const auto [low, high] = bounding_box(set);
  Point x = low;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    x[axis] += (high[axis] - low[axis]) * Rational(numbers.between(0, 1 << 20), 1 << 20);
  }
  return x;
}

// Two directions at right angles to the line through two points.
std::array<Point, 2> across(const Point& edge, Numbers& numbers) {
  const std::size_t first = numbers.below(3);
  for (std::size_t k = 0; k < 3; ++k) {
    Point axis{};
    axis[(first + k) % 3] = 1;
    const Point one = cross(edge, axis);
    if (one != Point{}) {
      return {of_the_size_of(edge, one), of_the_size_of(edge, cross(edge, one))};
    }
  }
  return {};
}

// The midpoint of two points, plus a rational combination of directions across. It is inside of their Voronoi facet
// if one of a few lines in the bisecting plane meets that facet.
Point facet_start(const PointSet& set, Numbers& numbers) {
  if (set.points.size() < 2) {
    return nearby_start(set, numbers);
  }
  Point x;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto ends = some_points(set, numbers, 2);
    const auto [v, w] = across(oracle::minus(ends[1], ends[0]), numbers);
    const Point u = moved(moved(Point{}, numbers.between(1, 3), v), numbers.between(-3, 3), w);
    x = moved(midpoint(ends[0], ends[1]), Rational(numbers.between(-2, 2), 3), w);
    const auto stretch = stretch_of(set, ends[0], x, u);
    if (stretch && !stretch->is_point()) {
      return moved(x, inside(*stretch, numbers), u);
    }
    x = moved(x, 1, u);
  }
  return x;
}

// The line of equal distance from three points.
struct EdgeLine {
  Point centre;
  Point direction;
  Stretch stretch;
};

std::optional<EdgeLine> edge_line(const PointSet& set, Numbers& numbers) {
  if (set.points.size() < 3) {
    return std::nullopt;
  }
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto corners = some_points(set, numbers, 3);
    const auto circle = oracle::circumcentre(corners);
    if (!circle) {
      continue;
    }
    const Point edge = oracle::minus(corners[1], corners[0]);
    const Point u = of_the_size_of(edge, cross(edge, oracle::minus(corners[2], corners[0])));
    const auto stretch = stretch_of(set, corners[0], circle->center, u);
    if (stretch && !stretch->is_point()) {
      return EdgeLine{circle->center, u, *stretch};
    }
  }
  return std::nullopt;
}

Point edge_start(const PointSet& set, Numbers& numbers) {
  const auto line = edge_line(set, numbers);
  return line ? moved(line->centre, inside(line->stretch, numbers), line->direction) : facet_start(set, numbers);
}

// The centre of four points if no point is nearer, which is tried a few times. Else an end of a Voronoi edge.
Point vertex_start(const PointSet& set, Numbers& numbers) {
  for (int attempt = 0; attempt < kAttempts && set.points.size() >= 4; ++attempt) {
    const auto corners = some_points(set, numbers, 4);
    const auto sphere = oracle::circumcentre(corners);
    if (sphere && oracle::squared_distance(sphere->center, corners[0]) ==
                      oracle::squared_distance(sphere->center, set.points[set.nearest_places(sphere->center)[0]])) {
      return sphere->center;
    }
  }
  const auto line = edge_line(set, numbers);
  if (!line || (!line->stretch.from && !line->stretch.to)) {
    return edge_start(set, numbers);
  }
  return moved(line->centre, line->stretch.from ? *line->stretch.from : *line->stretch.to, line->direction);
}

Point driver_start(const PointSet& set, Numbers& numbers) {
  const auto points = some_points(set, numbers, 2 + numbers.below(2));
  return oracle::circumcentre(oracle::spanning_subset(points))->center;
}

Point plane_start(const PointSet& set, Numbers& numbers) {
  const auto corners = some_points(set, numbers, 3);
  if (corners.size() < 3) {
    return facet_start(set, numbers);
  }
  const Point one = oracle::minus(corners[1], corners[0]);
  const Point two = oracle::minus(corners[2], corners[0]);
  const Point x =
      moved(moved(corners[0], Rational(numbers.between(-4, 8), 4), one), Rational(numbers.between(-4, 8), 4), two);
  const Rational height(std::max(0L, numbers.between(-3, 3)), 2);  // zero in four of seven
  return moved(x, height, of_the_size_of(one, cross(one, two)));
}

Point segment_start(const PointSet& set, Numbers& numbers) {
  const auto points = some_points(set, numbers, 2 + numbers.below(2));
  const Point end = midpoint(points[points.size() / 2], points.back());
  return moved(points[0], Rational(numbers.between(1, 5), 6), oracle::minus(end, points[0]));
}

// A start on a way that ends in a Voronoi vertex y. The way leads from the midpoint of two points of y's contact set
// through their facet, or from one of the points through its cell. If the midpoint is outside of the facet, the start
// is where the way enters the facet.
Point aimed_start(const PointSet& set, Numbers& numbers) {
  const Point y = vertex_start(set, numbers);
  const auto contact = oracle::select(set.points, set.nearest_places(y));
  const Point& p = contact[numbers.below(contact.size())];
  const Point& q = contact[numbers.below(contact.size())];
  const Point back = oracle::minus(midpoint(p, q), y);
  const auto stretch = stretch_of(set, p, y, back);
  if (!stretch || stretch->is_point() || stretch->to == Rational(0)) {
    return moved(y, Rational(numbers.between(1, 5), 6), oracle::minus(p, y));
  }
  const bool comes_in = stretch->to && *stretch->to < 1;
  return moved(y, comes_in ? *stretch->to : Rational(numbers.between(1, 5), 6), back);
}

// In the order of StartKind.
constexpr std::array<Point (*)(const PointSet&, Numbers&), kStartKindCount> kStarts = {
    nearby_start, box_start,         vertex_start, edge_start,    facet_start,
    driver_start, input_point_start, plane_start,  segment_start, aimed_start};

}  // namespace

std::ostream& operator<<(std::ostream& out, const StartChoice& choice) {
  out << kStartKindNames[static_cast<std::size_t>(choice.kind)];
  for (const std::uint32_t number : choice.numbers) {
    out << ' ' << number;
  }
  return out;
}

oracle::Point start_of(const PointSet& set, const StartChoice& choice) {
  FLOWCERT_REQUIRES(!set.points.empty());
  Numbers numbers(choice);
  return kStarts.at(static_cast<std::size_t>(choice.kind))(set, numbers);
}

}  // namespace flowcert::property
