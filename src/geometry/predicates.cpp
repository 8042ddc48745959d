// The rungs of a predicate differ in the number type of its polynomial alone, and in double's error bound.
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

template <class Query>
MaybeSign double_sign(const Query& query) {
  return filtered_sign<Query>(
      query.vectors([](const Point& from, const Point& to) { return vector_between(from, to); }));
}

template <class Integer, class Query>
Sign integer_sign(const Query& query, const IntegerGrid& grid) {
  return sign_of(Query::value(
      query.vectors([&grid](const Point& from, const Point& to) { return grid.vector_between<Integer>(from, to); })));
}

}  // namespace

template <class Query>
MaybeSign sign_on_rung(const Query& query, Rung rung) {
  if (rung == Rung::kDouble) return double_sign(query);
  const IntegerGrid grid(points_of(query));
  if (rung == Rung::kBig) return integer_sign<BigInteger>(query, grid);
  if (rung == Rung::kSmall) {
    if (!grid.fits_small()) return std::nullopt;
    return integer_sign<SmallInteger>(query, grid);
  }
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
  if (grid.fits_small()) return integer_sign<SmallInteger>(query, grid);
  if (grid.fits_narrow()) return integer_sign<NarrowInteger>(query, grid);
  return grid.fits_wide() ? integer_sign<WideInteger>(query, grid) : integer_sign<BigInteger>(query, grid);
}

namespace {

// What the header requires of the points.
bool is_allowed(const auto&) { return true; }
bool is_allowed(const SideOfPlane& k) { return unfiltered_sign(Orientation{k.f0, k.f1, k.f2, k.apex}) != Sign::kZero; }
bool is_allowed(const OutsideCircle& k) { return unfiltered_sign(Orientation{k.p0, k.p1, k.q, k.r}) == Sign::kZero; }

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
