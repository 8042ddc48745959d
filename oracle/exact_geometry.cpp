// How the header's promises are kept: Gram systems, solved by elimination in integers.
//
// For a simplex p0 ... pk with edges e_i = p_i - p0, the point p0 + sum of l_i e_i has the inner products <.,
// e_j> that a right hand side prescribes iff G l = rhs, G the matrix of the <e_i, e_j>. The circumcentre and
// the barycentric coordinates of a point are two right hand sides of it. Points are multiplied by a common
// denominator first, so that a fraction is reduced only where it is a result.
#include "oracle/exact_geometry.h"

#include <algorithm>

namespace oracle {

namespace {

using IntegerPoint = std::array<Integer, 3>;
using IntegerRow = std::vector<Integer>;

Integer dot(const IntegerPoint& a, const IntegerPoint& b) {
  Integer sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += a[axis] * b[axis];
  return sum;
}

IntegerPoint minus(IntegerPoint a, const IntegerPoint& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) a[axis] -= b[axis];
  return a;
}

// The least common multiple of `scale` and the denominators of x.
Integer common_denominator(Integer scale, const Point& x) {
  for (const Rational& coordinate : x) scale = lcm(scale, Integer(denominator(coordinate)));
  return scale;
}

// `scale` is a multiple of the denominators of x.
IntegerPoint times(const Integer& scale, const Point& x) {
  IntegerPoint product;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    product[axis] = scale / denominator(x[axis]);
    product[axis] *= numerator(x[axis]);
  }
  return product;
}

// A simplex times a common denominator.
struct IntegerSimplex {
  explicit IntegerSimplex(const std::vector<Point>& simplex, const Integer& at_least = 1) : scale(at_least) {
    for (const Point& point : simplex) scale = common_denominator(scale, point);
    origin = times(scale, simplex[0]);
    for (std::size_t i = 1; i < simplex.size(); ++i) edges.push_back(minus(times(scale, simplex[i]), origin));
  }
  Integer scale;
  IntegerPoint origin;
  std::vector<IntegerPoint> edges;
};

// The l_i of <sum of l_i e_i, e_j> = rhs_j for all j, times `denominator`, which is not 0.
struct Coefficients {
  IntegerRow numerators;
  Integer denominator = 1;
};

// Nothing iff the edges are linearly dependent. No pivot has to be looked for: the leading minors of a Gram
// matrix are positive as long as the edges are independent, and the first pivot that is zero shows an edge
// that depends on those before it. The elimination is Bareiss's: after each step all entries are minors, and
// the division by the pivot before leaves no rest; in the end the matrix is its determinant times the
// identity.
std::optional<Coefficients> solve_gram(const std::vector<IntegerPoint>& edges, const IntegerRow& rhs) {
  const std::size_t size = edges.size();
  std::vector<IntegerRow> matrix(size);
  for (std::size_t j = 0; j < size; ++j) {
    for (const IntegerPoint& edge : edges) matrix[j].push_back(dot(edges[j], edge));
    matrix[j].push_back(rhs[j]);
  }
  Coefficients result;
  for (std::size_t step = 0; step < size; ++step) {
    const Integer pivot = matrix[step][step];
    if (pivot == 0) return std::nullopt;
    for (std::size_t row = 0; row < size; ++row) {
      if (row == step) continue;
      const Integer factor = matrix[row][step];
      for (std::size_t k = 0; k <= size; ++k) {
        Integer& entry = matrix[row][k];
        entry *= pivot;
        entry -= factor * matrix[step][k];
        entry /= result.denominator;
      }
    }
    result.denominator = pivot;
  }
  for (const IntegerRow& row : matrix) result.numerators.push_back(row[size]);
  return result;
}

// |z - p0| = |z - p_j| says 2 <z - p0, e_j> = <e_j, e_j>. The denominator is positive, as Gram determinants
// are.
std::optional<Coefficients> circumcentre_coefficients(const IntegerSimplex& simplex) {
  IntegerRow rhs;
  for (const IntegerPoint& edge : simplex.edges) rhs.push_back(dot(edge, edge));
  auto coefficients = solve_gram(simplex.edges, rhs);
  if (coefficients) coefficients->denominator *= 2;
  return coefficients;
}

// 1 - sum of l_i, times the denominator.
Integer first_weight(const Coefficients& l) {
  Integer first = l.denominator;
  for (const Integer& numerator : l.numerators) first -= numerator;
  return first;
}

// The point p0 + sum of l_i e_i, and its barycentric coordinates (1 - sum of l_i, l_1, ..., l_k).
Circumcentre combine(const IntegerSimplex& simplex, const Coefficients& l) {
  Circumcentre result;
  result.weights.emplace_back(first_weight(l), l.denominator);
  for (const Integer& numerator : l.numerators) result.weights.emplace_back(numerator, l.denominator);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Integer sum = l.denominator * simplex.origin[axis];
    for (std::size_t i = 0; i < simplex.edges.size(); ++i) sum += l.numerators[i] * simplex.edges[i][axis];
    result.center[axis] = Rational(sum, l.denominator * simplex.scale);
  }
  return result;
}

}  // namespace

Point exact(const std::array<double, 3>& row) {
  // GMP's conversion from a double is exact, for subnormals too.
  Point x;
  for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = Rational(row[axis]);
  return x;
}

Point minus(Point a, const Point& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) a[axis] -= b[axis];
  return a;
}

Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  Point product;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
    product[axis] = a[next] * b[last];
    product[axis] -= a[last] * b[next];
  }
  return product;
}

Point moved(const Point& x, const Rational& time, const Point& direction) {
  Point end = x;
  for (std::size_t axis = 0; axis < 3; ++axis) end[axis] += time * direction[axis];
  return end;
}

Rational squared_distance(const Point& a, const Point& b) {
  const Point difference = minus(a, b);
  return dot(difference, difference);
}

std::optional<Circumcentre> circumcentre(const std::vector<Point>& points) {
  if (points.empty() || points.size() > 4) return std::nullopt;
  const IntegerSimplex simplex(points);
  const auto coefficients = circumcentre_coefficients(simplex);
  if (!coefficients) return std::nullopt;
  return combine(simplex, *coefficients);
}

std::optional<Point> inner_circumcentre(const std::vector<Point>& points) {
  if (points.empty() || points.size() > 4) return std::nullopt;
  const IntegerSimplex simplex(points);
  const auto coefficients = circumcentre_coefficients(simplex);
  if (!coefficients || first_weight(*coefficients) <= 0) return std::nullopt;
  for (const Integer& weight : coefficients->numerators) {
    if (weight <= 0) return std::nullopt;
  }
  return combine(simplex, *coefficients).center;
}

std::optional<std::vector<Rational>> barycentric(const std::vector<Point>& points, const Point& x) {
  if (points.empty() || points.size() > 4) return std::nullopt;
  const IntegerSimplex simplex(points, common_denominator(1, x));
  const IntegerPoint way = minus(times(simplex.scale, x), simplex.origin);
  IntegerRow rhs;
  for (const IntegerPoint& edge : simplex.edges) rhs.push_back(dot(way, edge));
  const auto coefficients = solve_gram(simplex.edges, rhs);
  if (!coefficients) return std::nullopt;
  // What was found is the orthogonal projection of x to the affine hull: x itself iff x lies there.
  const Circumcentre projection = combine(simplex, *coefficients);
  if (projection.center != x) return std::nullopt;
  return projection.weights;
}

std::vector<Point> spanning_subset(const std::vector<Point>& points) {
  std::vector<Point> chosen;
  for (const Point& point : points) {
    chosen.push_back(point);
    if (!circumcentre(chosen)) chosen.pop_back();
  }
  return chosen;
}

int affine_dimension(const std::vector<Point>& points) {
  return static_cast<int>(spanning_subset(points).size()) - 1;
}

// Let F be the smallest face of conv(points) that contains x, that is, the one with x in its relative
// interior. Call an affinely independent subset T of the points a carrier if x has positive barycentric
// coordinates in T.
//   - A carrier lies in F: a face that contains a point in the relative interior of conv T contains T.
//   - Each vertex v of F is in a carrier: the segment from v to x goes on inside F beyond x, so x is a convex
//     combination of points in F with a positive weight at v. The convex combinations that give x form a
//     polytope in the space of weights, and its vertices are those with affinely independent support: the
//     weight at v cannot be 0 at all of them.
// So the carriers together span aff F, and there is none iff x is outside. Four points suffice in R^3.
std::optional<int> face_dimension(const std::vector<Point>& points, const Point& x) {
  const std::size_t hull_size = spanning_subset(points).size();
  std::vector<Point>
      span;  // an affinely independent subset of the carriers so far, with the same affine hull
  for_each_subset(points.size(), hull_size, [&](const std::vector<std::size_t>& subset) {
    if (span.size() == hull_size) return;  // F is the whole hull already
    const std::vector<Point> simplex = select(points, subset);
    const auto weights = barycentric(simplex, x);
    if (!weights || !std::all_of(weights->begin(), weights->end(), [](const Rational& w) { return w > 0; })) {
      return;
    }
    span.insert(span.end(), simplex.begin(), simplex.end());
    span = spanning_subset(span);
  });
  if (span.empty()) return std::nullopt;
  return static_cast<int>(span.size()) - 1;
}

}  // namespace oracle
