// Exact geometry of a handful of points in R^3: circumcentres, affine hulls, faces of convex hulls.
//
// Everything here is computed in rational numbers, so every answer is the true one. Nothing is filtered, rounded or
// compared up to a tolerance. All of it rests on one operation, the dual basis of at most three edges. The affine hull of
// the points may have any dimension, 0 to 3, and no position is excluded.
#pragma once

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <optional>
#include <vector>

namespace oracle {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using Point = std::array<Rational, 3>;

// The same point in rationals (FC-IN-02). Every finite double is a rational. The doubles have to be finite.
Point exact(const std::array<double, 3>& row);

Point minus(Point a, const Point& b);
Rational dot(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
Point moved(const Point& x, const Rational& time, const Point& direction);  // x + time * direction
Point scaled(const Point& x, const Rational& by);
Point midpoint(const Point& a, const Point& b);
Rational squared_distance(const Point& a, const Point& b);

// From the first point to each other one, in order.
std::vector<Point> edges_of(const std::vector<Point>& simplex);

// Vectors in the span of e_1 ... e_k: the i-th has the inner product 1 with e_i, and 0 with the others. Nothing iff the
// edges are linearly dependent.
std::optional<std::vector<Point>> dual_basis(const std::vector<Point>& edges);

// The point of the affine hull of `simplex` at equal distance from all its points, and its barycentric coordinates.
// Nothing iff the points are affinely dependent (five points and more always are), or `simplex` is empty.
struct Circumcentre {
  Point center;
  std::vector<Rational> weights;
};
std::optional<Circumcentre> circumcentre(const std::vector<Point>& simplex);

// The circumcentre if all its barycentric coordinates are positive, so that it is in the simplex's relative interior.
std::optional<Point> inner_circumcentre(const std::vector<Point>& simplex);

// The barycentric coordinates of x. Nothing iff the points are affinely dependent, or `simplex` is empty, or x is not
// in their affine hull.
std::optional<std::vector<Rational>> barycentric(const std::vector<Point>& simplex, const Point& x);

// An affinely independent subset with the same affine hull. It has each point that the points before do not span.
std::vector<Point> spanning_subset(const std::vector<Point>& points);

// Dimension of the affine hull: 0 to 3, and -1 for no point.
int affine_dimension(const std::vector<Point>& points);

// The dimension of the face of conv(points) that has x in its relative interior; nothing iff x is not in
// conv(points).
std::optional<int> face_dimension(const std::vector<Point>& points, const Point& x);

// Calls visit(subset) for every non-empty subset of {0, ..., count - 1} of at most max_size members,
// ascending.
template <typename Visit>
void for_each_subset(std::size_t count, std::size_t max_size, const Visit& visit,
                     std::vector<std::size_t> chosen = {}) {
  for (std::size_t next = chosen.empty() ? 0 : chosen.back() + 1; next < count; ++next) {
    chosen.push_back(next);
    visit(chosen);
    if (chosen.size() < max_size) for_each_subset(count, max_size, visit, chosen);
    chosen.pop_back();
  }
}

// The members of `all` at the given places.
template <typename T>
std::vector<T> select(const std::vector<T>& all, const std::vector<std::size_t>& places) {
  std::vector<T> result;
  result.reserve(places.size());
  for (const std::size_t place : places) result.push_back(all[place]);
  return result;
}

}  // namespace oracle
