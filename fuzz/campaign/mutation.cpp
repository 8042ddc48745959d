// Points are placed in rational coordinates. A sphere has rational points everywhere: reflect one of its points in a
// plane through its centre that has an integer normal.
#include "fuzz/campaign/mutation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "flowcert/rational.h"
#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/transformations.h"
#include "geometry/rational_point.h"

namespace flowcert::fuzz {
namespace {

using namespace geometry;
// The generators have their own for integer points, which would hide these.
using geometry::cross, geometry::dot;

using MaybeMutant = std::optional<Mutant>;
using MaybePoint = std::optional<RationalPoint>;

// ---- Dice ----

std::size_t below(rc::Random& random, std::size_t count) { return random.next() % count; }

Integer between(rc::Random& random, Integer low, Integer high) {
  return low + static_cast<Integer>(below(random, static_cast<std::size_t>(high - low + 1)));
}

// So many different numbers of 0 to size - 1, in any order.
std::vector<std::size_t> choice(rc::Random& random, std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen(size);
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  for (std::size_t k = 0; k < count; ++k) std::swap(chosen[k], chosen[k + below(random, size - k)]);
  chosen.resize(count);
  return chosen;
}

// ---- Rational geometry ----

const Rational& one_half() {
  static const Rational half(1, 2);
  return half;
}

// A nonzero vector with entries of -3 to 3, and half of the time of -1 to 1.
RationalPoint small_vector(rc::Random& random) {
  const Integer reach = below(random, 2) == 0 ? 1 : 3;
  while (true) {
    RationalPoint vector;
    for (Rational& entry : vector) entry = between(random, -reach, reach);
    if (!is_zero(vector)) return vector;
  }
}

// x moved along v into the plane through `at` with normal v (t = 1), or to its mirror image in that plane (t = 2).
RationalPoint moved_along(const RationalPoint& x, const RationalPoint& v, const RationalPoint& at, int t) {
  return x - (t * dot(x - at, v) / dot(v, v)) * v;
}
RationalPoint image(const RationalPoint& x, const RationalPoint& at, const RationalPoint& normal) {
  return moved_along(x, normal, at, 2);
}

// The point at equal distances from p and all p + edges, by Cramer's rule: 2 <z - p, edge> = <edge, edge>. The last
// "edge" may be a normal; then z - p is orthogonal to it.
MaybePoint center(const RationalPoint& p, const std::array<RationalPoint, 3>& edges, bool last_is_normal) {
  const RationalPoint normal = cross(edges[0], edges[1]);
  const Rational volume = dot(normal, edges[2]);
  if (volume == 0) return std::nullopt;
  RationalPoint sum =
      dot(edges[0], edges[0]) * cross(edges[1], edges[2]) + dot(edges[1], edges[1]) * cross(edges[2], edges[0]);
  if (!last_is_normal) sum = sum + dot(edges[2], edges[2]) * normal;
  return p + (one_half() / volume) * sum;
}
MaybePoint circle_center(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  return center(p, {q - p, r - p, cross(q - p, r - p)}, true);
}

// ---- Places: where x goes, from the other points and where it was ----

using Points = std::vector<RationalPoint>;

// The image of any one of the points. No expression here draws twice, since compilers order operands differently.
RationalPoint image_through(const RationalPoint& at, const Points& points, const RationalPoint& normal,
                            rc::Random& random) {
  return image(points[below(random, points.size())], at, normal);
}

MaybePoint on_circumsphere(const Points& others, const RationalPoint&, rc::Random& random) {
  const auto z = center(others[0], {others[1] - others[0], others[2] - others[0], others[3] - others[0]},
                        /*last_is_normal=*/false);
  if (!z) return std::nullopt;
  const RationalPoint normal = small_vector(random);
  return image_through(*z, others, normal, random);
}

MaybePoint on_circumcircle(const Points& others, const RationalPoint&, rc::Random& random) {
  const auto z = circle_center(others[0], others[1], others[2]);
  if (!z) return std::nullopt;
  const Rational first = between(random, -2, 2);
  const Rational second = between(random, -2, 2);
  const RationalPoint normal = first * (others[1] - others[0]) + second * (others[2] - others[0]);
  if (is_zero(normal)) return std::nullopt;
  return image_through(*z, others, normal, random);
}

MaybePoint on_great_sphere(const Points& others, const RationalPoint&, rc::Random& random) {
  const auto z = circle_center(others[0], others[1], others[2]);
  if (!z) return std::nullopt;
  const RationalPoint normal = small_vector(random);
  return image_through(*z, others, normal, random);
}

MaybePoint on_diameter_sphere(const Points& others, const RationalPoint&, rc::Random& random) {
  return image(others[0], one_half() * (others[0] + others[1]), small_vector(random));
}

// The foot of q on a line through p, which half of the time is the line from p to x.
MaybePoint at_foot(const Points& others, const RationalPoint& x, rc::Random& random) {
  RationalPoint line = below(random, 2) == 0 ? x - others[0] : small_vector(random);
  if (is_zero(line)) return std::nullopt;
  return others[0] + (dot(others[1] - others[0], line) / dot(line, line)) * line;
}

// A point in the plane through `at` with this normal: the one nearest to x, or a step from `at` along the plane.
MaybePoint in_plane(const RationalPoint& at, const RationalPoint& normal, const RationalPoint& x, rc::Random& random) {
  if (is_zero(normal)) return std::nullopt;
  if (below(random, 2) == 0) return moved_along(x, normal, at, 1);
  return at + cross(normal, small_vector(random));
}

MaybePoint on_bisector(const Points& others, const RationalPoint& x, rc::Random& random) {
  return in_plane(one_half() * (others[0] + others[1]), others[1] - others[0], x, random);
}

MaybePoint on_leg(const Points& others, const RationalPoint& x, rc::Random& random) {
  return in_plane(others[0], others[1] - others[0], x, random);
}

MaybePoint in_mirror(const Points& others, const RationalPoint&, rc::Random&) {
  if (others[0] == others[1]) return std::nullopt;
  return image(others[2], one_half() * (others[0] + others[1]), others[1] - others[0]);
}

MaybePoint at_parallelogram(const Points& others, const RationalPoint&, rc::Random&) {
  return others[0] + others[1] - others[2];
}

MaybePoint on_line(const Points& others, const RationalPoint&, rc::Random& random) {
  const std::array<Rational, 3> factors{Rational(-1), one_half(), Rational(2)};
  return others[0] + factors[below(random, factors.size())] * (others[1] - others[0]);
}

// ---- Rationals to doubles, exactly or not at all ----

RationalPoint exactly(const Row& row) { return {Rational(row[0]), Rational(row[1]), Rational(row[2])}; }

std::optional<Row> exact_row(const RationalPoint& point) {
  Row row{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double> near = nearest_double(point[axis]);
    if (!near || Rational(*near) != point[axis]) return std::nullopt;
    row[axis] = *near;
  }
  return row;
}

// The factor that turns all coordinates into integers, the smallest possible ones.
Rational integer_factor(const Points& points) {
  using Whole = boost::multiprecision::mpz_int;
  Whole multiple = 1;
  Whole divisor = 0;
  for (const RationalPoint& point : points) {
    for (const Rational& value : point) {
      multiple = lcm(multiple, Whole(denominator(value)));
      divisor = gcd(divisor, Whole(numerator(value)));
    }
  }
  return divisor == 0 ? Rational(1) : Rational(multiple) / Rational(divisor);
}

// An input, and the factor by which all of it has been multiplied.
struct Placed {
  Input input;
  Rational factor;
};

// The input with a point in that row, which may be one past the last.
std::optional<Placed> with_point(const Input& input, std::size_t row, const RationalPoint& point) {
  static const Rational reach(Integer{1} << 40);
  Placed result{input, 1};
  result.input.rows.resize(std::max(row + 1, input.rows.size()));
  if (const auto exact = exact_row(point)) {
    result.input.rows[row] = *exact;
    return result;
  }
  Points points;
  for (const Row& other : result.input.rows) points.push_back(exactly(other));
  points[row] = point;
  result.factor = integer_factor(points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const RationalPoint scaled = result.factor * points[k];
    const bool fits = std::all_of(scaled.begin(), scaled.end(),
                                  [](const Rational& value) { return value < reach && value > -reach; });
    const auto exact = fits ? exact_row(scaled) : std::nullopt;
    if (!exact) return std::nullopt;
    result.input.rows[k] = *exact;
  }
  return result;
}

// ---- Moves of a point to a place ----

using Place = MaybePoint (*)(const Points& others, const RationalPoint& x, rc::Random& random);

constexpr int kTries = 8;
constexpr int kEnough = 3;  // the place with the least factor is chosen of these

struct Candidate {
  Mutant change;
  Rational factor;
};

// Moves or adds a point, placed by `count` others. Returns nothing if it does not move or falls on one of them.
std::optional<Candidate> candidate(const Input& parent, std::size_t count, Place place, rc::Random& random) {
  const std::size_t size = parent.rows.size();
  const bool is_new = size < kMostMutantRows && (size == count || below(random, 4) == 0);
  std::vector<std::size_t> rows = choice(random, size, std::min(size, count + 1));
  const std::size_t moved = is_new ? size : rows.back();
  const RationalPoint x = exactly(parent.rows[rows.back()]);
  rows.resize(count);
  Points others;
  for (const std::size_t row : rows) others.push_back(exactly(parent.rows[row]));
  const MaybePoint point = place(others, x, random);
  if (!point || *point == x || std::find(others.begin(), others.end(), *point) != others.end()) {
    return std::nullopt;
  }
  auto placed = with_point(parent, moved, *point);
  if (!placed) return std::nullopt;
  rows.insert(rows.begin(), moved);
  return Candidate{{std::move(placed->input), std::move(rows)}, std::move(placed->factor)};
}

MaybeMutant move_to(const Input& parent, std::size_t count, Place place, rc::Random& random) {
  const std::size_t size = parent.rows.size();
  if (size < count) return std::nullopt;
  std::optional<Candidate> best;
  int found = 0;
  for (int k = 0; k < kTries && found < kEnough; ++k) {
    auto next = candidate(parent, count, place, random);
    if (!next) continue;
    ++found;
    if (!best || next->factor < best->factor) best = std::move(next);
  }
  if (!best) return std::nullopt;
  return std::move(best->change);
}

// ---- Other changes ----

// All coordinates are below 2 to this power. Returns nothing if all are zero.
std::optional<int> top_exponent(const Input& input) {
  double largest = 0;
  for (const Row& row : input.rows) {
    for (const double x : row) largest = std::max(largest, std::abs(x));
  }
  if (largest == 0) return std::nullopt;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

// Snaps one row, or all of them, to a lattice. Its step is a power of two, and 1 to 32 steps reach the largest
// coordinate. A quotient that is rounded here lies below the smallest normal number, and becomes zero.
MaybeMutant snap(const Input& parent, rc::Random& random) {
  const auto top = top_exponent(parent);
  if (!top) return std::nullopt;
  const int exponent = *top - static_cast<int>(below(random, 6));
  std::vector<std::size_t> rows(parent.rows.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (below(random, 2) == 0) rows = {below(random, rows.size())};
  Mutant change{parent, rows};
  for (const std::size_t row : rows) {
    for (double& x : change.input.rows[row]) {
      // Adding zero turns a negative zero into a positive one.
      x = std::ldexp(std::round(std::ldexp(x, -exponent)), exponent) + 0.0;
    }
  }
  return change;
}

// Puts a copy of a row at the end, or in place of another row.
MaybeMutant duplicate(const Input& parent, rc::Random& random) {
  const std::size_t size = parent.rows.size();
  if (size == 0) return std::nullopt;
  const bool is_new = size < kMostMutantRows && (size == 1 || below(random, 2) == 0);
  if (!is_new && size == 1) return std::nullopt;
  const std::vector<std::size_t> rows = choice(random, size, is_new ? 1 : 2);
  const std::size_t copy = is_new ? size : rows[1];
  Mutant change{parent, {copy, rows[0]}};
  change.input.rows.resize(std::max(size, copy + 1));
  change.input.rows[copy] = parent.rows[rows[0]];
  return change;
}

MaybeMutant nudge_one(const Input& parent, rc::Random& random) {
  if (parent.rows.empty()) return std::nullopt;
  const std::size_t row = below(random, parent.rows.size());
  const std::size_t axis = below(random, 3);
  Mutant change{parent, {row}};
  double& x = change.input.rows[row][axis];
  x = nudged(x, below(random, 2) == 0 ? 1 : -1) + 0.0;
  return change;
}

// Copies a coordinate to another row, mostly of the same axis.
MaybeMutant copy_coordinate(const Input& parent, rc::Random& random) {
  if (parent.rows.size() < 2) return std::nullopt;
  const std::vector<std::size_t> rows = choice(random, parent.rows.size(), 2);
  const std::size_t axis = below(random, 3);
  const std::size_t from = below(random, 4) == 0 ? below(random, 3) : axis;
  Mutant change{parent, rows};
  change.input.rows[rows[0]][axis] = parent.rows[rows[1]][from];
  return change;
}

MaybeMutant remove_one(const Input& parent, rc::Random& random) {
  if (parent.rows.size() < 2) return std::nullopt;
  Mutant change{parent, {}};
  change.input.rows.erase(change.input.rows.begin() + static_cast<std::ptrdiff_t>(below(random, parent.rows.size())));
  return change;
}

// Adds a point at a small integer vector from another point, or from the origin if there is no point.
MaybeMutant add_one(const Input& parent, rc::Random& random) {
  const std::size_t size = parent.rows.size();
  if (size >= kMostMutantRows) return std::nullopt;
  RationalPoint point = small_vector(random);
  std::vector<std::size_t> rows{size};
  if (size > 0) {
    rows.push_back(below(random, size));
    point = exactly(parent.rows[rows[1]]) + point;
  }
  auto placed = with_point(parent, size, point);
  if (!placed) return std::nullopt;
  return Mutant{std::move(placed->input), std::move(rows)};
}

// Scales by a little, mostly. Otherwise it scales as far down or up as is exact, or anywhere between.
MaybeMutant scale(const Input& parent, rc::Random& random) {
  const bool is_far = below(random, 4) == 0;
  const int exponent = is_far ? exact_scalings(parent)(rc::Random(random.next()), 100).value()
                              : static_cast<int>(between(random, -8, 8));
  auto result = scaled(parent, exponent);
  if (!result) return std::nullopt;
  return Mutant{*std::move(result), {}};
}

MaybeMutant turn(const Input& parent, rc::Random& random) {
  constexpr double kReach = 1024.0 * 1024 * 1024 * 1024;
  std::array<Integer, 4> quaternion{};
  for (Integer& entry : quaternion) entry = between(random, -2, 2);
  auto result = turned(parent, rotation_of_quaternion(quaternion));
  if (!result) return std::nullopt;
  for (Row& row : result->rows) {
    for (double& x : row) {
      if (std::abs(x) >= kReach) return std::nullopt;
    }
  }
  return Mutant{*std::move(result), {}};
}

// ---- The list ----

bool is_allowed(const Input& mutant, const Input& parent) {
  const bool is_finite = std::all_of(mutant.rows.begin(), mutant.rows.end(), [](const Row& row) {
    return std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]);
  });
  return is_finite && mutant != parent;
}

template <typename Make>
Mutation mutation(const std::string& name, const std::string& description, const Make& make) {
  const auto apply = [name, make](const Input& parent, rc::Random& random) {
    MaybeMutant mutant = make(parent, random);
    if (mutant) mutant->by = name;
    return mutant && is_allowed(mutant->input, parent) ? std::move(mutant) : std::nullopt;
  };
  return {name, description, apply};
}

Mutation move(const std::string& name, const std::string& description, std::size_t count, Place place) {
  return mutation(name, description, [count, place](const Input& parent, rc::Random& random) {
    return move_to(parent, count, place, random);
  });
}

}  // namespace

const std::vector<Mutation>& mutations() {
  static const std::vector<Mutation> all = {
      move("onto-circumsphere", "x on the sphere through p, q, r, s", 4, on_circumsphere),
      move("onto-circumcircle", "x on the circle through p, q, r", 3, on_circumcircle),
      move("onto-great-sphere", "x on the smallest sphere through p, q, r: their circle is a great one", 3,
           on_great_sphere),
      move("onto-diameter-sphere", "x on the sphere with diameter pq: a right angle at x", 2, on_diameter_sphere),
      move("onto-foot", "x at the foot of the perpendicular from q to a line through p: a right angle at x", 2,
           at_foot),
      move("onto-leg", "x in the plane through p that is orthogonal to pq: a right angle at p", 2, on_leg),
      move("onto-bisector", "x as far from p as from q", 2, on_bisector),
      move("onto-mirror-image", "x the image of r in the bisector of p and q", 3, in_mirror),
      move("onto-parallelogram", "x = p + q - r", 3, at_parallelogram),
      move("onto-line", "x on the line through p and q: twice as far, between, or beyond", 2, on_line),
      mutation("snap", "x, or every row, goes to the nearest point of a lattice of a power of two", snap),
      mutation("duplicate", "x is a copy of p", duplicate),
      mutation("nudge", "a coordinate of x changes by one ulp", nudge_one),
      mutation("copy-coordinate", "x takes over a coordinate of p", copy_coordinate),
      mutation("remove", "a row goes", remove_one),
      mutation("add", "x comes, a small integer vector away from p, or from the origin", add_one),
      mutation("scale", "all are multiplied by a power of two", scale),
      mutation("turn", "all are turned by an integer rotation, and multiplied by its norm", turn),
  };
  return all;
}

Mutant mutated(const Input& parent, std::uint64_t seed) {
  rc::Random random(seed);
  // A mutation always applies: if there is at most one row, none can be removed, but one can be added or copied.
  for (const std::size_t k : choice(random, mutations().size(), mutations().size())) {
    if (auto mutant = mutations()[k].apply(parent, random)) return *std::move(mutant);
  }
  throw std::logic_error("no mutation applies");
}

}  // namespace flowcert::fuzz
