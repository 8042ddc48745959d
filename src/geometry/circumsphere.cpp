// exact_sphere() of the public interface: the smallest sphere through a cospherical set, in rationals.
//
// Guarantees: exact. Any affinely independent points of the set that span its affine hull give the same
// sphere, so the first such points in the given order are taken.
#include <stdexcept>

#include "flowcert/stationary_points.h"
#include "geometry/integer_grid.h"
#include "geometry/vector3.h"

namespace flowcert {

namespace {

using Vector = Vector3<Rational>;

bool is_zero(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Vector rational_vector(const Point& from, const Point& to) {
  return {Rational(to.x) - Rational(from.x), Rational(to.y) - Rational(from.y),
          Rational(to.z) - Rational(from.z)};
}

// The centre of the circle through 0, a, b, in their plane: (|a|^2 b - |b|^2 a) x (a x b) / (2 |a x b|^2).
Vector circle_center(const Vector& a, const Vector& b) {
  const Vector n = cross(a, b);
  const Vector numerator = cross(dot(a, a) * b - dot(b, b) * a, n);
  return Rational(1) / (2 * dot(n, n)) * numerator;
}

Vector sphere_center(const Vector& a, const Vector& b, const Vector& c) {
  const auto sphere = circumsphere(a, b, c);
  return Rational(1) / (2 * sphere.determinant) * sphere.numerator;
}

// The centre relative to the first point, from the vectors of the other points to it.
Vector center_of(const std::vector<Vector>& vectors) {
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
  if (a == nullptr) return {0, 0, 0};
  return b == nullptr ? Rational(1, 2) * *a : circle_center(*a, *b);
}

}  // namespace

ExactSphere exact_sphere(const PointSet& points, std::span<const PointId> contact) {
  if (contact.empty()) throw std::invalid_argument("exact_sphere: an empty set has no sphere");
  const auto point = [&points](PointId id) -> const Point& { return points[points.position_of_row(id)]; };
  const Point& origin = point(contact.front());
  std::vector<Vector> vectors;
  for (const PointId id : contact.subspan(1)) vectors.push_back(rational_vector(origin, point(id)));
  const Vector center = center_of(vectors);
  return {{center.x + Rational(origin.x), center.y + Rational(origin.y), center.z + Rational(origin.z)},
          dot(center, center)};
}

}  // namespace flowcert
