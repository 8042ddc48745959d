// The predicates that decide everything. Each has several rungs: a double filter with a proven error bound, integers
// of a fixed size, and GMP's integers.
//
// Guarantees: exact for all finite doubles. A rung may leave the sign open, but if it answers, the next one would
// answer the same (spec clause FC-NUM-01; tests/unit/predicates_test.cpp compares each rung with the next). There is
// no division and no square root. The filters' bounds are in filter_bounds.h.
#pragma once

#include "flowcert/filter_tally.h"
#include "flowcert/point_set.h"
#include "geometry/filter_bounds.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

// Every predicate below has these rungs. kBig always answers; kNarrow and kWide answer where the points fit them.
// kNarrow computes degree 2 in the machine's integers, and the rest in wide ones.
enum class Rung { kDouble, kNarrow, kWide, kBig };

// The sign of <p - q, r - q>: positive where the angle at q is acute (FC-SIGN-01).
struct Angle {
  static constexpr Predicate kPredicate = Predicate::kAngle;
  const Point &p, &q, &r;
};

// The side of the plane of f0 f1 f2 on which the circumcentre of f0 f1 f2 apex lies; the apex's side is positive
// (FC-SIGN-03). The tetrahedron must not be flat.
struct SideOfPlane {
  static constexpr Predicate kPredicate = Predicate::kSideOfPlane;
  const Point &f0, &f1, &f2, &apex;
};

// Zero iff q lies on the circumsphere of p0 p1 p2 p3. If p0 p1 p2 p3 is positively oriented, the sign is positive
// where q lies outside.
struct OutsideSphere {
  static constexpr Predicate kPredicate = Predicate::kCospherical;
  const Point &p0, &p1, &p2, &p3, &q;
};

// The sign of det(p1 - p0, p2 - p0, p3 - p0).
struct Orientation {
  static constexpr Predicate kPredicate = Predicate::kCoplanar;
  const Point &p0, &p1, &p2, &p3;
};

// The four points are coplanar, and q and r lie strictly on different sides of p0p1. The sign is positive iff r lies
// outside the circle through p0, p1 and q, and zero iff r lies on it. (The angles at q and r then sum to less than
// half a turn, or to exactly that.)
struct OutsideCircle {
  static constexpr Predicate kPredicate = Predicate::kCocircular;
  const Point &p0, &p1, &q, &r;
};

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
