// Each predicate is one polynomial, a template over the number type; the rungs differ in that type alone, and in the
// error bound that double needs.
#include "geometry/predicates.h"

#include <array>
#include <cmath>

#include "geometry/contract.h"
#include "geometry/integer_grid.h"

namespace flowcert::geometry {

namespace {

// The points that a query is about.
std::array<const Point*, 3> points_of(const Angle& k) { return {&k.p, &k.q, &k.r}; }
std::array<const Point*, 4> points_of(const SideOfPlane& k) { return {&k.f0, &k.f1, &k.f2, &k.apex}; }
std::array<const Point*, 5> points_of(const OutsideSphere& k) { return {&k.p0, &k.p1, &k.p2, &k.p3, &k.q}; }
std::array<const Point*, 4> points_of(const Orientation& k) { return {&k.p0, &k.p1, &k.p2, &k.p3}; }
std::array<const Point*, 4> points_of(const OutsideCircle& k) { return {&k.p0, &k.p1, &k.q, &k.r}; }

template <class Number>
Number value_of(const Angle&, const std::array<Vector3<Number>, 2>& v) {
  return dot(v[0], v[1]);
}

// The circumcentre is numerator / (2 det). The apex lies at height det over ab, the centre at <ab, numerator> / (2
// det).
template <class Number>
typename Promoted<Number>::Type value_of(const SideOfPlane&, const std::array<Vector3<Number>, 3>& v) {
  const auto sphere = circumsphere(v[0], v[1], v[2]);
  return dot(sphere.ab, sphere.numerator);
}

template <class Number>
typename Promoted<Number>::Type value_of(const OutsideSphere&, const std::array<Vector3<Number>, 4>& v) {
  using Wide = typename Promoted<Number>::Type;
  const auto sphere = circumsphere(v[0], v[1], v[2]);
  return Wide(dot(v[3], v[3])) * sphere.determinant - dot(sphere.numerator, promote(v[3]));
}

template <class Number>
typename Promoted<Number>::Type value_of(const Orientation&, const std::array<Vector3<Number>, 3>& v) {
  return dot(promote(v[0]), promote(cross(v[1], v[2])));
}

// The sign is that of cot(q) + cot(r), over the common denominator. Both cross products are along the plane's normal,
// with opposite signs, so the same coordinate of both tells their lengths. v = p0-q, p1-q, p0-r, p1-r.
template <class Number>
typename Promoted<Number>::Type value_of(const OutsideCircle&, const std::array<Vector3<Number>, 4>& v) {
  using std::abs;
  using Wide = typename Promoted<Number>::Type;
  const Vector3<Wide> at_q = promote(cross(v[0], v[1]));
  const Vector3<Wide> at_r = promote(cross(v[2], v[3]));
  const Wide hq(dot(v[0], v[1]));
  const Wide hr(dot(v[2], v[3]));
  const Wide ax = abs(at_q.x), ay = abs(at_q.y), az = abs(at_q.z);
  if (ax >= ay && ax >= az) return hq * abs(at_r.x) + hr * ax;
  return ay >= az ? hq * abs(at_r.y) + hr * ay : hq * abs(at_r.z) + hr * az;
}

// The vectors of a query: ordered so that value_of() above reads well.
template <class Between>
auto vectors_of(const Angle& k, const Between& between) {
  return std::array{between(k.q, k.p), between(k.q, k.r)};
}
template <class Between>
auto vectors_of(const SideOfPlane& k, const Between& between) {
  return std::array{between(k.f0, k.f1), between(k.f0, k.f2), between(k.f0, k.apex)};
}
template <class Between>
auto vectors_of(const OutsideSphere& k, const Between& between) {
  return std::array{between(k.p0, k.p1), between(k.p0, k.p2), between(k.p0, k.p3), between(k.p0, k.q)};
}
template <class Between>
auto vectors_of(const Orientation& k, const Between& between) {
  return std::array{between(k.p0, k.p1), between(k.p0, k.p2), between(k.p0, k.p3)};
}
template <class Between>
auto vectors_of(const OutsideCircle& k, const Between& between) {
  return std::array{between(k.q, k.p0), between(k.q, k.p1), between(k.r, k.p0), between(k.r, k.p1)};
}

// n: the norms of the vectors.
double error_bound(const Angle&, const std::array<double, 2>& n) {
  return kAngleBound * kUnitRoundoff * n[0] * n[1];
}
double error_bound(const SideOfPlane&, const std::array<double, 3>& n) {
  const double ab = n[0] * n[1];
  return kSideOfPlaneBound * kUnitRoundoff * ab * (ab * n[2]) * (n[0] + n[1] + n[2]);
}
double error_bound(const OutsideSphere&, const std::array<double, 4>& n) {
  return kOutsideSphereBound * kUnitRoundoff * (n[0] * n[1] * n[2] * n[3]) * (n[0] + n[1] + n[2] + n[3]);
}
double error_bound(const Orientation&, const std::array<double, 3>& n) {
  return kOrientationBound * kUnitRoundoff * n[0] * n[1] * n[2];
}
double error_bound(const OutsideCircle&, const std::array<double, 4>& n) {
  return kOutsideCircleBound * kUnitRoundoff * (n[0] * n[1]) * (n[2] * n[3]);
}

template <class Query>
MaybeSign double_sign(const Query& query) {
  const auto vectors =
      vectors_of(query, [](const Point& from, const Point& to) { return vector_between(from, to); });
  std::array<double, vectors.size()> norms;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    norms[i] = std::sqrt(dot(vectors[i], vectors[i]));
    if (!(norms[i] >= kSmallestNorm && norms[i] <= kLargestNorm)) return std::nullopt;
  }
  return sign_beyond(value_of(query, vectors), error_bound(query, norms));
}

template <class Integer, class Query>
Sign integer_sign(const Query& query, const IntegerGrid& grid) {
  return sign_of(value_of(query, vectors_of(query, [&grid](const Point& from, const Point& to) {
                            return grid.vector_between<Integer>(from, to);
                          })));
}

}  // namespace

template <class Query>
MaybeSign sign_on_rung(const Query& query, Rung rung) {
  if (rung == Rung::kDouble) return double_sign(query);
  const IntegerGrid grid(points_of(query));
  if (rung == Rung::kBig) return integer_sign<BigInteger>(query, grid);
  if (rung == Rung::kNarrow) {
    if (!grid.fits_narrow()) return std::nullopt;
    return integer_sign<NarrowInteger>(query, grid);
  }
  if (!grid.fits_wide()) return std::nullopt;
  return integer_sign<WideInteger>(query, grid);
}

template <class Query>
Sign unfiltered_sign(const Query& query) {
  const IntegerGrid grid(points_of(query));
  if (grid.fits_narrow()) return integer_sign<NarrowInteger>(query, grid);
  return grid.fits_wide() ? integer_sign<WideInteger>(query, grid) : integer_sign<BigInteger>(query, grid);
}

namespace {

// What the header requires of the points.
template <class Query>
bool is_allowed(const Query&) {
  return true;
}
bool is_allowed(const SideOfPlane& k) {
  return unfiltered_sign(Orientation{k.f0, k.f1, k.f2, k.apex}) != Sign::kZero;
}
bool is_allowed(const OutsideCircle& k) {
  return unfiltered_sign(Orientation{k.p0, k.p1, k.q, k.r}) == Sign::kZero;
}

}  // namespace

template <class Query>
Sign exact_sign(const Query& query, FilterTally& tally) {
  FLOWCERT_REQUIRES(is_allowed(query));
  FilterCount& count = tally[Query::kPredicate];
  ++count.calls;
  if (const MaybeSign sign = double_sign(query)) return *sign;
  ++count.failures;
  return unfiltered_sign(query);
}

template MaybeSign sign_on_rung(const Angle&, Rung);
template MaybeSign sign_on_rung(const SideOfPlane&, Rung);
template MaybeSign sign_on_rung(const OutsideSphere&, Rung);
template MaybeSign sign_on_rung(const Orientation&, Rung);
template MaybeSign sign_on_rung(const OutsideCircle&, Rung);
template Sign unfiltered_sign(const Angle&);
template Sign unfiltered_sign(const SideOfPlane&);
template Sign unfiltered_sign(const OutsideSphere&);
template Sign unfiltered_sign(const Orientation&);
template Sign unfiltered_sign(const OutsideCircle&);
template Sign exact_sign(const Angle&, FilterTally&);
template Sign exact_sign(const SideOfPlane&, FilterTally&);
template Sign exact_sign(const OutsideSphere&, FilterTally&);
template Sign exact_sign(const Orientation&, FilterTally&);
template Sign exact_sign(const OutsideCircle&, FilterTally&);

}  // namespace flowcert::geometry
