// How the header's promises are kept: Gram systems, solved by elimination in rationals.
//
// For a simplex p0 ... pk with edges e_i = p_i - p0, the point p0 + sum of l_i e_i has the inner products <.,
// e_j> that a right hand side prescribes iff G l = rhs, G the matrix of the <e_i, e_j>. The circumcentre and
// the barycentric coordinates of a point are two right hand sides of it.
#include "oracle/exact_geometry.h"

#include <algorithm>

namespace oracle {

namespace {

using Row = std::vector<Rational>;

std::vector<Point> edges_from_first(const std::vector<Point>& simplex) {
  std::vector<Point> edges;
  for (std::size_t i = 1; i < simplex.size(); ++i) edges.push_back(minus(simplex[i], simplex[0]));
  return edges;
}

// Solves <sum of l_i e_i, e_j> = rhs_j for all j; nothing iff the edges are linearly dependent. No pivot has
// to be looked for: the leading minors of a Gram matrix are positive as long as the edges are independent,
// and the first pivot that is zero shows an edge that depends on those before it.
std::optional<Row> solve_gram(const std::vector<Point>& edges, const Row& rhs) {
  const std::size_t size = edges.size();
  std::vector<Row> matrix(size);
  for (std::size_t j = 0; j < size; ++j) {
    for (const Point& edge : edges) matrix[j].push_back(dot(edges[j], edge));
    matrix[j].push_back(rhs[j]);
  }
  for (std::size_t pivot = 0; pivot < size; ++pivot) {
    if (matrix[pivot][pivot] == 0) return std::nullopt;
    for (std::size_t row = 0; row < size; ++row) {
      if (row == pivot) continue;
      const Rational factor = matrix[row][pivot] / matrix[pivot][pivot];
      for (std::size_t k = pivot; k <= size; ++k) matrix[row][k] -= factor * matrix[pivot][k];
    }
  }
  Row solution;
  for (std::size_t j = 0; j < size; ++j) solution.push_back(matrix[j][size] / matrix[j][j]);
  return solution;
}

// The point p0 + sum of l_i e_i, and its barycentric coordinates (1 - sum of l_i, l_1, ..., l_k).
Circumcentre combine(const Point& origin, const std::vector<Point>& edges, const Row& coefficients) {
  Circumcentre result{origin, {Rational(1)}};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) result.center[axis] += coefficients[i] * edges[i][axis];
    result.weights[0] -= coefficients[i];
    result.weights.push_back(coefficients[i]);
  }
  return result;
}

}  // namespace

Point exact(const std::array<double, 3>& row) {
  // GMP's conversion from a double is exact, for subnormals too.
  return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point moved(const Point& x, const Rational& time, const Point& direction) {
  return {x[0] + time * direction[0], x[1] + time * direction[1], x[2] + time * direction[2]};
}

Rational squared_distance(const Point& a, const Point& b) {
  const Point difference = minus(a, b);
  return dot(difference, difference);
}

std::optional<Circumcentre> circumcentre(const std::vector<Point>& simplex) {
  if (simplex.empty() || simplex.size() > 4) return std::nullopt;
  // |z - p0| = |z - p_j| says 2 <z - p0, e_j> = <e_j, e_j>.
  const std::vector<Point> edges = edges_from_first(simplex);
  Row rhs;
  for (const Point& edge : edges) rhs.push_back(dot(edge, edge) / 2);
  const auto coefficients = solve_gram(edges, rhs);
  if (!coefficients) return std::nullopt;
  return combine(simplex[0], edges, *coefficients);
}

std::optional<Row> barycentric(const std::vector<Point>& simplex, const Point& x) {
  if (simplex.empty() || simplex.size() > 4) return std::nullopt;
  const std::vector<Point> edges = edges_from_first(simplex);
  Row rhs;
  for (const Point& edge : edges) rhs.push_back(dot(minus(x, simplex[0]), edge));
  const auto coefficients = solve_gram(edges, rhs);
  if (!coefficients) return std::nullopt;
  // What was found is the orthogonal projection of x to the affine hull: x itself iff x lies there.
  const Circumcentre projection = combine(simplex[0], edges, *coefficients);
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
