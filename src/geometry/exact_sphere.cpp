// exact_sphere() of the public interface: the smallest sphere through a cospherical set, in rationals.
//
// Guarantees: exact. Any affinely independent points of the set that span its affine hull give the same sphere, so
// the first such points in the given order are taken. All is computed in integers, on a grid that carries the points.
// A sum or a product of rationals costs a greatest common divisor, so only the four numbers that come out are
// reduced.
#include <stdexcept>
#include <utility>

#include "flowcert/sphere.h"
#include "geometry/floating_point.h"
#include "geometry/integer_grid.h"
#include "geometry/vector3.h"

namespace flowcert {

using namespace geometry;

namespace {

using Vector = Vector3<BigInteger>;

// Relative to the first point, in units of the grid: numerator / denominator.
struct Center {
  Vector numerator;
  BigInteger denominator;
};

bool is_zero(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// The centre of the circle through 0, a, b, in their plane: (|a|^2 b - |b|^2 a) x (a x b) / (2 |a x b|^2).
Center circle_center(const Vector& a, const Vector& b) {
  const Vector n = cross(a, b);
  return {cross(dot(a, a) * b - dot(b, b) * a, n), 2 * dot(n, n)};
}

Center sphere_center(const Vector& a, const Vector& b, const Vector& c) {
  auto sphere = circumsphere(a, b, c);
  if (sphere.determinant < 0) {
    sphere.determinant = -sphere.determinant;
    sphere.numerator = BigInteger(-1) * sphere.numerator;
  }
  return {std::move(sphere.numerator), 2 * sphere.determinant};
}

// Takes the vectors from the first point to the others.
Center center_of(const std::vector<Vector>& vectors) {
  const Vector* a = nullptr;
  const Vector* b = nullptr;
  for (const Vector& v : vectors) {
    if (a == nullptr) {
      a = &v;
    } else if (b == nullptr) {
      if (!is_zero(cross(*a, v))) b = &v;
    } else if (dot(cross(*a, *b), v) != 0) {
      return sphere_center(*a, *b, v);
    }
  }
  if (a == nullptr) return {{0, 0, 0}, 1};
  return b == nullptr ? Center{*a, 2} : circle_center(*a, *b);
}

// numerator / denominator * 2^exponent
Rational reduced(const BigInteger& numerator, const BigInteger& denominator, int exponent) {
  Rational value(numerator, denominator);
  mpq_t& raw = value.backend().data();
  if (exponent >= 0) {
    mpq_mul_2exp(raw, raw, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(raw, raw, static_cast<mp_bitcnt_t>(-exponent));
  }
  return value;
}

// On the grid.
struct PlacedCenter {
  Vector first;  // the first point
  Center center;
  int exponent;  // of the grid's unit
};

PlacedCenter placed_center(const PointSet& points, std::span<const PointId> contact) {
  if (contact.empty()) throw std::invalid_argument("exact_sphere: an empty set has no sphere");
  std::vector<const Point*> given;
  given.reserve(contact.size());
  for (const PointId id : contact) given.push_back(&points.at_row(id));
  const IntegerGrid grid(given);
  const Point& first = *given.front();
  std::vector<Vector> vectors;
  vectors.reserve(given.size() - 1);
  for (const Point* point : std::span(given).subspan(1)) {
    vectors.push_back(grid.vector_between<BigInteger>(first, *point));
  }
  return {grid.vector_between<BigInteger>({0, 0, 0}, first), center_of(vectors), grid.exponent()};
}

Rational squared_radius(const PlacedCenter& placed) {
  const auto& [numerator, d] = placed.center;
  return reduced(dot(numerator, numerator), d * d, 2 * placed.exponent);
}

}  // namespace

ExactSphere exact_sphere(const PointSet& points, std::span<const PointId> contact) {
  const geometry::IeeeDoubles ieee;
  const PlacedCenter placed = placed_center(points, contact);
  const BigInteger& d = placed.center.denominator;
  const Vector from_origin = d * placed.first + placed.center.numerator;
  const int e = placed.exponent;
  return {{reduced(from_origin.x, d, e), reduced(from_origin.y, d, e), reduced(from_origin.z, d, e)},
          squared_radius(placed)};
}

Rational exact_squared_radius(const PointSet& points, std::span<const PointId> contact) {
  const geometry::IeeeDoubles ieee;
  return squared_radius(placed_center(points, contact));
}

}  // namespace flowcert
