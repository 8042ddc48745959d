// Bounds of first order, as in filter_bounds.h, with doubled doubles. Vectors go from the first point to the others;
// they are exact. All bounds are computed in doubles, and are enlarged by far more than their rounding.
#include "geometry/bounded_sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/floating_point.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

namespace {

using DoubledVector = Vector3<DoubleDouble>;

constexpr double kU = DoubleDouble::kRoundoff;

// ---- Constants of the bounds, in units of kU (src/flow/cascades.md, "Coordinates in doubles") ----

constexpr double kSquareBound = 5;              // of the square of an offset: three squares and two sums
constexpr double kEdgeBound = 6;                // the same of an edge whose vector is rounded
constexpr double kCircleNumeratorBound = 24;    // 21, times |a|^2 |b|^2 (|a|+|b|)
constexpr double kCircleDenominatorBound = 36;  // 29, times |a|^2 |b|^2
constexpr double kSphereNumeratorBound = 16;    // 13.8, times |a||b||c| (|a|+|b|+|c|)
constexpr double kSphereDenominatorBound = 24;  // 19.6, times |a||b||c|

// Vectors are exact, so a square has an error of at most 4 u of itself. That makes 15 u of the numerator, |a|^2 |b|^2
// |b-a|^2, and three times as much of the quotient, because its denominator may be a third of what is computed. The
// denominator is twice that of the centre.
constexpr double kSquaredCircleBound = 48;
constexpr double kSquaredCircleDenominatorBound = 72;
// A relative error e of a numerator or a denominator makes one of less than kSquareShare e in the square, for errors
// below kLargestError. Two squares and a division add 9 u.
constexpr double kSquareShare = 2.001;
constexpr double kLargestError = 0x1p-20;
constexpr double kSquaredSphereBound = 16;

// Lengths between these have powers that are normal doubles, so that underflow is far below the bounds.
constexpr double kLeastLength = 1e-25, kGreatestLength = 1e25;

DoubledVector vector_from(const Point& from, const Point& to) {
  return {DoubleDouble::sum(to.x, -from.x), DoubleDouble::sum(to.y, -from.y), DoubleDouble::sum(to.z, -from.z)};
}

double length(const DoubledVector& v) { return std::sqrt(dot(v, v).high()); }

bool is_in_range(double length) { return length >= kLeastLength && length <= kGreatestLength; }

// The sphere whose centre is `first` + offset. The offset has an error of at most `error`.
BoundedSphere sphere_around(const Point& first, const DoubledVector& offset, double error) {
  const DoubleDouble square = dot(offset, offset);
  const double size = std::sqrt(square.high()) * kBoundedSlack;
  const auto coordinate = [&](double start, const DoubleDouble& step) {
    const DoubleDouble value = DoubleDouble(start) + step;
    return BoundedNumber{value, (error + kU * std::fabs(value.high())) * kBoundedSlack};
  };
  return {{coordinate(first.x, offset.x), coordinate(first.y, offset.y), coordinate(first.z, offset.z)},
          {square, (kSquareBound * kU * square.high() + error * (2 * size + error)) * kBoundedSlack}};
}

BoundedSphere sphere_of_point(const Point& p) { return {{{{p.x, 0}, {p.y, 0}, {p.z, 0}}}, {0, 0}}; }

// Half a coordinate is exact, unless it is subnormal.
BoundedSphere sphere_of_edge(const Point& p, const Point& q) {
  const auto middle = [](double a, double b) {
    const bool is_exact = a / 2 * 2 == a && b / 2 * 2 == b;
    return BoundedNumber{DoubleDouble::sum(a / 2, b / 2), is_exact ? 0 : std::numeric_limits<double>::denorm_min()};
  };
  BoundedSphere sphere{{middle(p.x, q.x), middle(p.y, q.y), middle(p.z, q.z)}, {}};
  const DoubledVector e = vector_from(p, q);
  if (is_in_range(length(e))) {
    const DoubleDouble quarter = DoubleDouble(0.25) * dot(e, e);
    sphere.squared_radius = {quarter, kEdgeBound * kU * quarter.high()};
  }
  return sphere;
}

// The centre is numerator / denominator. Both errors are absolute.
struct Quotient {
  DoubledVector numerator;
  double numerator_error;
  DoubleDouble denominator;
  double denominator_error;
};

// |N'/D' - N/D| <= (|N'-N| + |N'/D'| |D'-D|) / |D|, and a division adds one roundoff.
BoundedSphere sphere_of_quotient(const Point& first, const Quotient& center) {
  const double least = std::fabs(center.denominator.high()) * (1 - kBoundedShare) - center.denominator_error;
  if (!(least > center.denominator_error)) return {};
  const auto& n = center.numerator;
  const DoubledVector offset{n.x / center.denominator, n.y / center.denominator, n.z / center.denominator};
  const double size = length(offset) * kBoundedSlack;
  const double error = (center.numerator_error + size * center.denominator_error) / least + kU * size;
  return sphere_around(first, offset, error * kBoundedSlack);
}

// (|a|^2 b - |b|^2 a) x n / (2 |n|^2) with n = a x b.
BoundedSphere sphere_of_circle(const Point& p, const Point& q, const Point& r) {
  const DoubledVector a = vector_from(p, q), b = vector_from(p, r), n = cross(a, b);
  const double na = length(a), nb = length(b), square = na * na * nb * nb;
  if (!is_in_range(std::min(na, nb)) || !is_in_range(std::max(na, nb))) return {};
  const DoubledVector numerator = cross(DoubleDouble(dot(a, a)) * b - DoubleDouble(dot(b, b)) * a, n);
  return sphere_of_quotient(p, {numerator, kCircleNumeratorBound * kU * square * (na + nb), DoubleDouble(2) * dot(n, n),
                                kCircleDenominatorBound * kU * square});
}

BoundedSphere sphere_of_tetrahedron(const std::array<const Point*, 4>& p) {
  const DoubledVector a = vector_from(*p[0], *p[1]), b = vector_from(*p[0], *p[2]), c = vector_from(*p[0], *p[3]);
  const double na = length(a), nb = length(b), nc = length(c), product = na * nb * nc;
  if (!is_in_range(std::min({na, nb, nc})) || !is_in_range(std::max({na, nb, nc}))) return {};
  const Circumsphere<DoubleDouble> sphere = circumsphere(a, b, c);
  return sphere_of_quotient(*p[0], {sphere.numerator, kSphereNumeratorBound * kU * product * (na + nb + nc),
                                    DoubleDouble(2) * sphere.determinant, kSphereDenominatorBound * kU * product});
}

}  // namespace

BoundedSphere bounded_sphere(std::span<const Point* const> points) {
  switch (points.size()) {
    case 1:
      return sphere_of_point(*points[0]);
    case 2:
      return sphere_of_edge(*points[0], *points[1]);
    case 3:
      return sphere_of_circle(*points[0], *points[1], *points[2]);
    case 4:
      return sphere_of_tetrahedron({points[0], points[1], points[2], points[3]});
    default:
      return {};
  }
}

// ---- The squared radius alone ----

namespace {

// |a|^2 |b|^2 |b-a|^2 / (4 |n|^2) with n = a x b. If the denominator is D' instead of D, the quotient changes by
// |D'-D|/|D| of itself. D' is at most 3 D.
BoundedNumber squared_radius_of_circle(const Point& p, const Point& q, const Point& r) {
  const DoubledVector a = vector_from(p, q), b = vector_from(p, r), n = cross(a, b);
  const DoubleDouble aa = dot(a, a), bb = dot(b, b);
  const double na = std::sqrt(aa.high()), nb = std::sqrt(bb.high());
  if (!is_in_range(std::min(na, nb)) || !is_in_range(std::max(na, nb))) return {};
  const DoubledVector c = vector_from(q, r);
  const DoubleDouble denominator = DoubleDouble(4) * dot(n, n);
  const double denominator_error = kSquaredCircleDenominatorBound * kU * aa.high() * bb.high() * kBoundedSlack;
  const double least = denominator.high() * (1 - kBoundedShare) - denominator_error;
  if (!(least > denominator_error)) return {};
  const DoubleDouble value = aa * bb * dot(c, c) / denominator;
  return {value, value.high() * (kSquaredCircleBound * kU + denominator_error / least) * kBoundedSlack};
}

// |N|^2 / (2 D)^2.
BoundedNumber squared_radius_of_tetrahedron(const std::array<const Point*, 4>& p) {
  const DoubledVector a = vector_from(*p[0], *p[1]), b = vector_from(*p[0], *p[2]), c = vector_from(*p[0], *p[3]);
  const double na = length(a), nb = length(b), nc = length(c), product = na * nb * nc;
  if (!is_in_range(std::min({na, nb, nc})) || !is_in_range(std::max({na, nb, nc}))) return {};
  const Circumsphere<DoubleDouble> sphere = circumsphere(a, b, c);
  const DoubleDouble square = dot(sphere.numerator, sphere.numerator), twice = DoubleDouble(2) * sphere.determinant;
  const double size = std::sqrt(square.high());
  const double error = kSphereNumeratorBound * kU * product * (na + nb + nc) / size +
                       kSphereDenominatorBound * kU * product / std::fabs(twice.high());
  if (!(error < kLargestError)) return {};
  const DoubleDouble value = square / (twice * twice);
  return {value, value.high() * (kSquareShare * error + kSquaredSphereBound * kU) * kBoundedSlack};
}

// The points of the contact set that determine its sphere, as many as there are; nothing where it has too few.
template <typename Result>
Result of_contact(const PointSet& points, std::span<const PointId> contact, std::size_t hull_dimension,
                  Result (*use)(std::span<const Point* const>)) {
  std::array<const Point*, 4> given{};
  const std::size_t count = std::min(hull_dimension + 1, given.size());
  if (contact.size() < count) return {};
  for (std::size_t k = 0; k < count; ++k) given[k] = &points.at_row(contact[k]);
  return use(std::span(given).first(count));
}

}  // namespace

BoundedNumber bounded_squared_radius(std::span<const Point* const> points) {
  switch (points.size()) {
    case 3:
      return squared_radius_of_circle(*points[0], *points[1], *points[2]);
    case 4:
      return squared_radius_of_tetrahedron({points[0], points[1], points[2], points[3]});
    default:
      return bounded_sphere(points).squared_radius;
  }
}

BoundedSphere bounded_sphere(const PointSet& points, std::span<const PointId> contact, std::size_t hull_dimension) {
  return of_contact<BoundedSphere>(points, contact, hull_dimension, &bounded_sphere);
}
BoundedNumber bounded_squared_radius(const PointSet& points, std::span<const PointId> contact,
                                     std::size_t hull_dimension) {
  return of_contact<BoundedNumber>(points, contact, hull_dimension, &bounded_squared_radius);
}

std::optional<RoundedSphere> decided_sphere(const BoundedSphere& sphere) {
  const auto x = decided_double(sphere.center[0]), y = decided_double(sphere.center[1]),
             z = decided_double(sphere.center[2]), square = decided_double(sphere.squared_radius);
  if (!x || !y || !z || !square) return std::nullopt;
  return RoundedSphere{{*x, *y, *z}, *square};
}

}  // namespace flowcert::geometry

namespace flowcert {

double nearest_or_infinity(const Rational& value) {
  const geometry::IeeeDoubles ieee;
  return nearest_double(value).value_or(value < 0 ? -HUGE_VAL : HUGE_VAL);
}

Point rounded_point(const RationalPoint& x) {
  const geometry::IeeeDoubles ieee;
  return {nearest_or_infinity(x[0]), nearest_or_infinity(x[1]), nearest_or_infinity(x[2])};
}

RoundedSphere rounded_sphere(const ExactSphere& sphere) {
  const geometry::IeeeDoubles ieee;
  return {rounded_point(sphere.center), nearest_or_infinity(sphere.squared_radius)};
}

RoundedSphere rounded_sphere(const PointSet& points, std::span<const PointId> contact, std::size_t hull_dimension) {
  const geometry::IeeeDoubles ieee;
  if (const auto sphere = decided_sphere(geometry::bounded_sphere(points, contact, hull_dimension))) return *sphere;
  return rounded_sphere(exact_sphere(points, contact));
}

double rounded_squared_radius(const PointSet& points, std::span<const PointId> contact, std::size_t hull_dimension) {
  if (hull_dimension == 0) return 0;
  const geometry::IeeeDoubles ieee;
  const auto square = geometry::bounded_squared_radius(points, contact, hull_dimension);
  if (const auto nearest = geometry::decided_double(square)) return *nearest;
  return nearest_or_infinity(exact_squared_radius(points, contact));
}

}  // namespace flowcert
