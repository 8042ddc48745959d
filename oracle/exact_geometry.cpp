// How the header's promises are kept: by dual bases.
//
// Let e_1 ... e_k be the edges p_i - p_0 of a simplex p_0 ... p_k. Its dual basis are the vectors f_1 ... f_k of
// the edges' span with <e_i, f_j> = 1 for i = j and 0 otherwise. It gives circumcentres and barycentric coordinates:
//   - the vector of the span with inner products b_i with the e_i is the sum of the b_i f_i. For the centre z,
//     |z - p_0| = |z - p_i| says <z - p_0, e_i> = |e_i|^2 / 2;
//   - where x = p_0 + sum of l_i e_i, l_i = <x - p_0, f_i>. For another x, these are the coordinates of its
//     orthogonal projection to the affine hull.
#include "oracle/exact_geometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace oracle {

namespace {

bool independent(const std::vector<Point>& points) { return dual_basis(edges_of(points)).has_value(); }

// The barycentric coordinates of p_0 + way. The way must be in the span of the edges.
std::vector<Rational> weights_of(const Point& way, const std::vector<Point>& dual) {
  std::vector<Rational> weights = {1};
  for (const Point& vector : dual) {
    weights.push_back(dot(way, vector));
    weights[0] -= weights.back();
  }
  return weights;
}

bool all_positive(const std::vector<Rational>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](const Rational& weight) { return weight > 0; });
}

}  // namespace

Point exact(const std::array<double, 3>& row) {
  assert(std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]));
  // GMP's conversion from a double is exact, for subnormals too.
  return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
}

Point minus(Point a, const Point& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) a[axis] -= b[axis];
  return a;
}

Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point moved(const Point& x, const Rational& time, const Point& direction) {
  return {x[0] + time * direction[0], x[1] + time * direction[1], x[2] + time * direction[2]};
}

Point scaled(const Point& x, const Rational& by) { return {x[0] * by, x[1] * by, x[2] * by}; }

Point midpoint(const Point& a, const Point& b) { return moved(a, Rational(1, 2), minus(b, a)); }

Rational squared_distance(const Point& a, const Point& b) {
  const Point difference = minus(a, b);
  return dot(difference, difference);
}

std::vector<Point> edges_of(const std::vector<Point>& simplex) {
  std::vector<Point> edges;
  for (std::size_t i = 1; i < simplex.size(); ++i) edges.push_back(minus(simplex[i], simplex[0]));
  return edges;
}

// Up to a factor the vectors are cross products: each is perpendicular to the other edges, and to the normal of a
// single plane. The factor is the same for all, as the determinant stays the same when its rows are turned:
// <a, b x c> = <b, c x a> = <c, a x b>.
std::optional<std::vector<Point>> dual_basis(const std::vector<Point>& edges) {
  if (edges.empty()) return edges;
  std::vector<Point> dual;
  if (edges.size() == 1) dual = edges;
  if (edges.size() == 2) {
    const Point normal = cross(edges[0], edges[1]);
    dual = {cross(edges[1], normal), cross(normal, edges[0])};
  }
  if (edges.size() == 3) {
    dual = {cross(edges[1], edges[2]), cross(edges[2], edges[0]), cross(edges[0], edges[1])};
  }
  if (dual.empty()) return std::nullopt;  // four vectors
  const Rational factor = dot(edges[0], dual[0]);
  if (factor == 0) return std::nullopt;
  for (Point& vector : dual) {
    for (Rational& coordinate : vector) coordinate /= factor;
  }
  return dual;
}

std::optional<Circumcentre> circumcentre(const std::vector<Point>& simplex) {
  const std::vector<Point> edges = edges_of(simplex);
  const auto dual = dual_basis(edges);
  if (simplex.empty() || !dual) return std::nullopt;
  Point way;  // z - p_0
  for (std::size_t i = 0; i < edges.size(); ++i) way = moved(way, dot(edges[i], edges[i]) / 2, (*dual)[i]);
  return Circumcentre{moved(simplex[0], 1, way), weights_of(way, *dual)};
}

std::optional<Point> inner_circumcentre(const std::vector<Point>& simplex) {
  const auto sphere = circumcentre(simplex);
  return sphere && all_positive(sphere->weights) ? std::optional(sphere->center) : std::nullopt;
}

std::optional<std::vector<Rational>> barycentric(const std::vector<Point>& simplex, const Point& x) {
  const std::vector<Point> edges = edges_of(simplex);
  const auto dual = dual_basis(edges);
  if (simplex.empty() || !dual) return std::nullopt;
  const std::vector<Rational> weights = weights_of(minus(x, simplex[0]), *dual);
  Point projection = simplex[0];
  for (std::size_t i = 0; i < edges.size(); ++i) projection = moved(projection, weights[i + 1], edges[i]);
  return projection == x ? std::optional(weights) : std::nullopt;
}

std::vector<Point> spanning_subset(const std::vector<Point>& points) {
  std::vector<Point> chosen;
  for (const Point& point : points) {
    chosen.push_back(point);
    if (!independent(chosen)) chosen.pop_back();
  }
  return chosen;
}

int affine_dimension(const std::vector<Point>& points) { return static_cast<int>(spanning_subset(points).size()) - 1; }

// Let F be the face of conv(points) that has x in its relative interior. It is the smallest face that contains x.
// Call an affinely independent subset T of the points a carrier if x has positive barycentric coordinates in T.
//   - A carrier lies in F: a face that contains a point in the relative interior of conv T contains T.
//   - Each vertex v of F is in a carrier: the segment from v to x goes on inside F beyond x, so x is a convex
//     combination of points in F with a positive weight at v. The convex combinations that give x form a
//     polytope in the space of weights, and its vertices are those with affinely independent support: the
//     weight at v cannot be 0 at all of them.
// So the carriers together span aff F, and there is none iff x is outside. Four points suffice in R^3.
std::optional<int> face_dimension(const std::vector<Point>& points, const Point& x) {
  const std::size_t hull_size = spanning_subset(points).size();
  std::vector<Point> span;  // affinely independent, with the affine hull of the carriers so far
  for_each_subset(points.size(), hull_size, [&](const std::vector<std::size_t>& subset) {
    if (span.size() == hull_size) return;  // F is the whole hull already
    const std::vector<Point> simplex = select(points, subset);
    const auto weights = barycentric(simplex, x);
    if (!weights || !all_positive(*weights)) return;
    span.insert(span.end(), simplex.begin(), simplex.end());
    span = spanning_subset(span);
  });
  if (span.empty()) return std::nullopt;
  return static_cast<int>(span.size()) - 1;
}

}  // namespace oracle
