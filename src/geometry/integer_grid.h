// The numbers of the exact rungs: coordinates as integers on the coarsest power-of-two grid that carries the given
// points.
//
// Guarantees: exact for all finite doubles. All predicates are homogeneous in differences of points, so a common
// power of two does not change their signs. There are four integer types. SmallInteger and NarrowInteger are the
// machine's. NarrowInteger serves polynomials of degree 2 in points that span at most kNarrowBits bits on their grid,
// and so does SmallInteger for kSmallBits bits; then NarrowInteger serves up to degree 6. WideInteger has a fixed size
// and never allocates; it serves up to degree 6 and kWideBits bits. GMP's integers serve everything.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <cstdint>
#include <limits>
#include <span>

#include "flowcert/point_set.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

namespace mp = boost::multiprecision;

using BigInteger = mp::number<mp::gmp_int, mp::et_off>;
// Holds polynomials of degree 6 in differences of kWideBits + 1 bits, with 10 bits to spare for their many
// terms.
using WideInteger = mp::number<mp::cpp_int_backend<512, 512, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;
inline constexpr int kWideBits = 82;
// Sums of three products of differences of kNarrowBits + 1 bits stay below 2^126.
using NarrowInteger = __int128;
inline constexpr int kNarrowBits = 61;

// Points of a lattice or of a fine grid. Polynomials of degree 6 in differences of kSmallBits + 1 bits are a sum of at
// most 1,024 products, so that they stay below 2^124 in NarrowInteger. Those of degree 2 stay below 2^46.
using SmallInteger = std::int64_t;
inline constexpr int kSmallBits = 18;

template <>
struct Promoted<SmallInteger> {
  using Type = NarrowInteger;
};
template <>
struct Promoted<NarrowInteger> {
  using Type = WideInteger;
};

class IntegerGrid {
 public:
  // Takes the finest exponent that a coordinate of the points needs.
  explicit IntegerGrid(std::span<const Point* const> points);
  explicit IntegerGrid(std::span<const Point> points);

  // Whether every coordinate is below 2^kWideBits (2^kNarrowBits, 2^kSmallBits) in units of the grid.
  [[nodiscard]] bool fits_wide() const { return top_exponent_ - exponent_ <= kWideBits; }
  [[nodiscard]] bool fits_narrow() const { return top_exponent_ - exponent_ <= kNarrowBits; }
  [[nodiscard]] bool fits_small() const { return top_exponent_ - exponent_ <= kSmallBits; }

  [[nodiscard]] int exponent() const { return exponent_; }
  // kExactReach in units of the grid (filter_bounds.h), or 0 where that is no double.
  [[nodiscard]] double exact_reach() const;

  // to - from, in units of the grid. For WideInteger only where fits_wide(), and so on.
  template <class Integer>
  [[nodiscard]] Vector3<Integer> vector_between(const Point& from, const Point& to) const;

 private:
  template <class Integer>
  [[nodiscard]] Integer difference(double from, double to) const;

  void take(const Point& p);

  int exponent_ = std::numeric_limits<int>::max();      // the grid is 2^exponent_ Z
  int top_exponent_ = std::numeric_limits<int>::min();  // all coordinates are below 2^top_exponent_ in absolute value
};

}  // namespace flowcert::geometry
