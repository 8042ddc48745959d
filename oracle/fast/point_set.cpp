// How the header's promises are kept: scans evaluate one linear form, and simplices are solved without a division.
//
// Let P be a point p times scale_, lifted to (P, |P|^2). What a scan compares is linear in that:
//   - with D the common denominator of x, D |P|^2 - 2 scale_ <D x, P> is D scale_^2 (|p - x|^2 - |x|^2);
//   - with E that of the direction u, <E u, P> is E scale_ <u, p>.
#include "oracle/fast/point_set.h"

#include <algorithm>

namespace oracle::fast {

namespace {

using Vector = std::array<Integer, 3>;
using Form = std::array<Integer, 4>;

Integer common_denominator(const Point& x) {
  Integer common = 1;
  for (const Rational& coordinate : x) common = lcm(common, Integer(denominator(coordinate)));
  return common;
}

// `scale` is a multiple of the denominators of x.
Vector times(const Integer& scale, const Point& x) {
  Vector product;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    product[axis] = scale / denominator(x[axis]);
    product[axis] *= numerator(x[axis]);
  }
  return product;
}

// The inner product of N numbers each, without a temporary for each product.
template <std::size_t N>
Integer dot(const std::array<Integer, N>& a, const std::array<Integer, N>& b) {
  Integer sum;
  for (std::size_t k = 0; k < N; ++k) {
    mpz_addmul(sum.backend().data(), a[k].backend().data(), b[k].backend().data());
  }
  return sum;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The vectors f_i of the edges' span with <e_i, f_j> = 0 for i != j, and <e_i, f_i> = `factor` for all i. The factor
// is 0 iff the edges are dependent.
struct DualBasis {
  explicit DualBasis(const std::vector<Vector>& edges) {
    if (edges.size() == 1) vectors = edges;
    if (edges.size() == 2) {
      const Vector normal = cross(edges[0], edges[1]);
      vectors = {cross(edges[1], normal), cross(normal, edges[0])};
    }
    if (edges.size() == 3) {
      vectors = {cross(edges[1], edges[2]), cross(edges[2], edges[0]), cross(edges[0], edges[1])};
    }
    if (!vectors.empty()) factor = dot(edges[0], vectors[0]);
  }
  std::vector<Vector> vectors;
  Integer factor = 0;
};

}  // namespace

// The denominators are powers of two, so the greatest is a common one.
PointSet::PointSet(const std::vector<std::array<double, 3>>& rows) : oracle::PointSet(rows) {
  for (const Point& point : points) {
    for (const Rational& coordinate : point) scale_ = std::max(scale_, Integer(denominator(coordinate)));
  }
  for (const Point& point : points) {
    const Vector row = times(scale_, point);
    lifted_.push_back({row[0], row[1], row[2], dot(row, row)});
  }
}

Places PointSet::nearest_places(const Point& x) const {
  const Integer scale_of_x = common_denominator(x);
  const Vector scaled = times(-2 * scale_ * scale_of_x, x);
  const Form distance = {scaled[0], scaled[1], scaled[2], scale_of_x};
  Places nearest;
  Integer least;
  for (std::size_t place = 0; place < lifted_.size(); ++place) {
    const Integer there = dot(distance, lifted_[place]);
    if (nearest.empty() || there < least) {
      nearest.clear();
      least = there;
    }
    if (there == least) nearest.push_back(place);
  }
  return nearest;
}

// q meets p at t = N / 2 A, where N = |x - q|^2 - |x - p|^2 >= 0 and A = <u, q - p> > 0, here times their scales. The
// first meeting so far is kept as (N, A), infinity as (1, 0). q comes before it iff N_q A < N A_q. This holds iff the
// form A |x - .|^2 - N <u, .> is less at q than at p. If A_q <= 0, it is not less.
std::optional<Rational> PointSet::first_meeting(std::size_t p, const Point& x, const Point& direction) const {
  const Integer scale_of_x = common_denominator(x), scale_of_u = common_denominator(direction);
  const Vector scaled = times(-2 * scale_ * scale_of_x, x), u = times(scale_of_u, direction);
  const Form distance = {scaled[0], scaled[1], scaled[2], scale_of_x}, advance = {u[0], u[1], u[2], 0};
  Integer lead = 1, approach = 0;
  Form later;
  Integer later_of_p;
  const auto compare_with = [&](const Integer& n, const Integer& a) {
    const Integer common = gcd(n, a);
    lead = n / common;
    approach = a / common;
    for (std::size_t k = 0; k < 4; ++k) later[k] = approach * distance[k] - lead * advance[k];
    later_of_p = dot(later, lifted_[p]);
  };
  compare_with(1, 0);
  for (const Form& q : lifted_) {
    if (dot(later, q) >= later_of_p) continue;
    compare_with(dot(distance, q) - dot(distance, lifted_[p]), dot(advance, q) - dot(advance, lifted_[p]));
  }
  if (approach == 0) return std::nullopt;
  return Rational(lead * scale_of_u, 2 * approach * scale_ * scale_of_x);
}

// Works like oracle::circumcentre(), but z - p_0 = way / 2 factor. The weights are the inner products of the way with
// the dual basis, divided by 2 factor^2. That is positive, so it does not change their signs.
std::optional<Point> PointSet::inner_circumcentre(const Places& simplex) const {
  if (simplex.empty()) return std::nullopt;
  if (simplex.size() == 1) return points[simplex[0]];
  const Form& origin = lifted_[simplex[0]];
  std::vector<Vector> edges;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    const Form& end = lifted_[simplex[i]];
    edges.push_back({end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]});
  }
  const DualBasis dual(edges);
  if (dual.factor == 0) return std::nullopt;
  Vector way;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Integer square = dot(edges[i], edges[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) way[axis] += square * dual.vectors[i][axis];
  }
  Integer first_weight = 2 * dual.factor * dual.factor;
  for (const Vector& vector : dual.vectors) {
    const Integer weight = dot(way, vector);
    if (weight <= 0) return std::nullopt;
    first_weight -= weight;
  }
  if (first_weight <= 0) return std::nullopt;
  Point centre;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre[axis] = points[simplex[0]][axis] + Rational(way[axis], 2 * dual.factor * scale_);
  }
  return centre;
}

}  // namespace oracle::fast
