// The predicates that decide everything. Each has several rungs: a double filter with a proven error bound, integers
// of a fixed size, and GMP's integers.
//
// Guarantees: exact for all finite doubles. A rung may leave the sign open, but if it answers, the next one would
// answer the same (spec clause FC-NUM-01; tests/unit/predicates_test.cpp compares each rung with the next). There is
// no division and no square root. The filters' bounds are in filter_bounds.h.
#pragma once

#include <array>
#include <cmath>

#include "flowcert/filter_tally.h"
#include "flowcert/point_set.h"
#include "geometry/filter_bounds.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

// Every predicate below has these rungs. kBig always answers; the three before it answer where the points fit them.
// kSmall computes in the machine's integers. kNarrow computes degree 2 there, and the rest in wide ones.
enum class Rung { kDouble, kSmall, kNarrow, kWide, kBig };

// A query has a polynomial, `value`, over any number type, in the `vectors` between its points. They are in an order
// that makes the polynomial read well. `error_bound` is how far `value` is off in doubles, made of the norms of these
// vectors. spec/proofs/filters/ proves it of what these templates compute.

// The sign of <p - q, r - q>: positive where the angle at q is acute (FC-SIGN-01).
struct Angle {
  static constexpr Predicate kPredicate = Predicate::kAngle;
  const Point &p, &q, &r;

  [[nodiscard]] auto vectors(const auto& between) const { return std::array{between(q, p), between(q, r)}; }
  template <class Number>
  [[nodiscard]] static Number value(const std::array<Vector3<Number>, 2>& v) {
    return dot(v[0], v[1]);
  }
  template <class Number>
  [[nodiscard]] static Number error_bound(const std::array<Number, 2>& n) {
    return Number(kAngleBound * kUnitRoundoff) * n[0] * n[1];
  }
};

// The side of the plane of f0 f1 f2 on which the circumcentre of f0 f1 f2 apex lies; the apex's side is positive
// (FC-SIGN-03). The tetrahedron must not be flat.
struct SideOfPlane {
  static constexpr Predicate kPredicate = Predicate::kSideOfPlane;
  const Point &f0, &f1, &f2, &apex;

  [[nodiscard]] auto vectors(const auto& between) const {
    return std::array{between(f0, f1), between(f0, f2), between(f0, apex)};
  }
  // The circumcentre is numerator / (2 det). The apex lies at height det over ab, the centre at <ab, numerator> / (2
  // det).
  template <class Number>
  [[nodiscard]] static typename Promoted<Number>::Type value(const std::array<Vector3<Number>, 3>& v) {
    const auto sphere = circumsphere(v[0], v[1], v[2]);
    return dot(sphere.ab, sphere.numerator);
  }
  template <class Number>
  [[nodiscard]] static Number error_bound(const std::array<Number, 3>& n) {
    const Number ab = n[0] * n[1];
    return Number(kSideOfPlaneBound * kUnitRoundoff) * ab * (ab * n[2]) * (n[0] + n[1] + n[2]);
  }
};

// Zero iff q lies on the circumsphere of p0 p1 p2 p3. If p0 p1 p2 p3 is positively oriented, the sign is positive
// where q lies outside.
struct OutsideSphere {
  static constexpr Predicate kPredicate = Predicate::kCospherical;
  const Point &p0, &p1, &p2, &p3, &q;

  [[nodiscard]] auto vectors(const auto& between) const {
    return std::array{between(p0, p1), between(p0, p2), between(p0, p3), between(p0, q)};
  }
  template <class Number>
  [[nodiscard]] static typename Promoted<Number>::Type value(const std::array<Vector3<Number>, 4>& v) {
    const auto sphere = circumsphere(v[0], v[1], v[2]);
    return value(sphere.numerator, sphere.determinant, v[3]);
  }
  // This is the same for a known circumsphere. The bound of its error takes the product and the sum of the norms of
  // the three vectors that made the sphere, and the norm of v.
  template <class Number, class Wide>
  [[nodiscard]] static Wide value(const Vector3<Wide>& numerator, const Wide& determinant, const Vector3<Number>& v) {
    return Wide(dot(v, v)) * determinant - dot(numerator, promote(v));
  }
  template <class Number>
  [[nodiscard]] static Number error_bound(const Number& product, const Number& sum, const Number& norm) {
    return Number(kOutsideSphereBound * kUnitRoundoff) * product * norm * (sum + norm);
  }
  template <class Number>
  [[nodiscard]] static Number error_bound(const std::array<Number, 4>& n) {
    return error_bound(n[0] * n[1] * n[2], n[0] + n[1] + n[2], n[3]);
  }
};

// The sign of det(p1 - p0, p2 - p0, p3 - p0).
struct Orientation {
  static constexpr Predicate kPredicate = Predicate::kCoplanar;
  const Point &p0, &p1, &p2, &p3;

  [[nodiscard]] auto vectors(const auto& between) const {
    return std::array{between(p0, p1), between(p0, p2), between(p0, p3)};
  }
  template <class Number>
  [[nodiscard]] static typename Promoted<Number>::Type value(const std::array<Vector3<Number>, 3>& v) {
    return dot(promote(v[0]), promote(cross(v[1], v[2])));
  }
  template <class Number>
  [[nodiscard]] static Number error_bound(const std::array<Number, 3>& n) {
    return Number(kOrientationBound * kUnitRoundoff) * n[0] * n[1] * n[2];
  }
};

// The four points are coplanar, and q and r lie strictly on different sides of p0p1. The sign is positive iff r lies
// outside the circle through p0, p1 and q, and zero iff r lies on it. (The angles at q and r then sum to less than
// half a turn, or to exactly that.)
struct OutsideCircle {
  static constexpr Predicate kPredicate = Predicate::kCocircular;
  const Point &p0, &p1, &q, &r;

  [[nodiscard]] auto vectors(const auto& between) const {
    return std::array{between(q, p0), between(q, p1), between(r, p0), between(r, p1)};
  }
  // The sign is that of cot(q) + cot(r), over the common denominator. Both cross products are along the plane's
  // normal, with opposite signs, so the same coordinate of both gives their lengths.
  template <class Number>
  [[nodiscard]] static typename Promoted<Number>::Type value(const std::array<Vector3<Number>, 4>& v) {
    using Wide = typename Promoted<Number>::Type;
    const Vector3<Wide> at_q = promote(cross(v[0], v[1]));
    const Vector3<Wide> at_r = promote(cross(v[2], v[3]));
    const Wide hq(dot(v[0], v[1]));
    const Wide hr(dot(v[2], v[3]));
    const Wide ax = absolute(at_q.x), ay = absolute(at_q.y), az = absolute(at_q.z);
    if (ax >= ay && ax >= az) return hq * absolute(at_r.x) + hr * ax;
    if (ay >= az) return hq * absolute(at_r.y) + hr * ay;
    return hq * absolute(at_r.z) + hr * az;
  }
  template <class Number>
  [[nodiscard]] static Number error_bound(const std::array<Number, 4>& n) {
    return Number(kOutsideCircleBound * kUnitRoundoff) * (n[0] * n[1]) * (n[2] * n[3]);
  }
};

// The double filter of a query, of the vectors between its points in floating point. It answers nothing where a norm is
// out of range.
template <class Query, class Number, std::size_t kVectors>
[[nodiscard, gnu::always_inline]] inline MaybeSign filtered_sign(const std::array<Vector3<Number>, kVectors>& vectors) {
  using std::sqrt;
  std::array<Number, kVectors> norms{};
  for (std::size_t i = 0; i < kVectors; ++i) {
    norms[i] = sqrt(dot(vectors[i], vectors[i]));
    if (!(norms[i] >= kSmallestNorm && norms[i] <= kLargestNorm)) return std::nullopt;
  }
  return sign_beyond(Query::value(vectors), Query::error_bound(norms));
}

// The sign of points on a grid of a power of two, from doubles that nothing was rounded in. It answers where no vector
// is longer than `reach`, which is IntegerGrid::exact_reach(), or 0 for any points.
template <class Query, class Number, std::size_t kVectors>
[[nodiscard]] MaybeSign unrounded_sign(const std::array<Vector3<Number>, kVectors>& vectors, const Number& reach) {
  using std::sqrt;
  for (const Vector3<Number>& v : vectors) {
    const Number norm = sqrt(dot(v, v));
    if (!(norm >= kSmallestNorm && norm <= kLargestNorm && norm <= reach)) return std::nullopt;
  }
  return sign_of(Query::value(vectors));
}

// One rung alone, for the tests and for callers that have a filter of their own.
template <class Query>
[[nodiscard]] MaybeSign sign_on_rung(const Query& query, Rung rung);

// The sign, from the first rung that knows it.
template <class Query>
[[nodiscard]] Sign exact_sign(const Query& query, FilterTally& tally);

// The sign, from the exact rungs alone: for callers whose own double filter has just failed.
template <class Query>
[[nodiscard]] Sign unfiltered_sign(const Query& query);

}  // namespace flowcert::geometry
