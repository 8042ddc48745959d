// Doubles are taken apart by their bits, because frexp on every coordinate took most of the time of an exact
// predicate.
#include "geometry/integer_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/contract.h"
#include "geometry/filter_bounds.h"

namespace flowcert::geometry {

namespace {

// value = (negative ? -1 : 1) * mantissa * 2^exponent, with an odd mantissa or 0.
struct OddDouble {
  std::uint64_t mantissa;
  int exponent;
  bool negative;
};

OddDouble take_apart(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased != 0) mantissa |= std::uint64_t{1} << 52;
  if (mantissa == 0) return {0, 0, false};
  const int shift = std::countr_zero(mantissa);
  return {mantissa >> shift, std::max(biased, 1) - 1075 + shift, (bits >> 63) != 0};
}

template <class Integer>
Integer on_grid(double value, int grid_exponent) {
  const OddDouble odd = take_apart(value);
  if (odd.mantissa == 0) return Integer(0);
  auto result = static_cast<Integer>(odd.mantissa);
  result <<= static_cast<unsigned>(odd.exponent - grid_exponent);
  return odd.negative ? Integer(-result) : result;
}

}  // namespace

void IntegerGrid::take(const Point& p) {
  for (const double value : {p.x, p.y, p.z}) {
    const OddDouble odd = take_apart(value);
    if (odd.mantissa == 0) continue;
    exponent_ = std::min(exponent_, odd.exponent);
    top_exponent_ = std::max(top_exponent_, odd.exponent + static_cast<int>(std::bit_width(odd.mantissa)));
  }
}

IntegerGrid::IntegerGrid(std::span<const Point* const> points) {
  for (const Point* p : points) take(*p);
  if (exponent_ > top_exponent_) exponent_ = top_exponent_ = 0;
}

IntegerGrid::IntegerGrid(std::span<const Point> points) {
  for (const Point& p : points) take(p);
  if (exponent_ > top_exponent_) exponent_ = top_exponent_ = 0;
}

double IntegerGrid::exact_reach() const {
  const double reach = std::ldexp(kExactReach, exponent_);
  return std::isfinite(reach) ? reach : 0;
}

template <class Integer>
Integer IntegerGrid::difference(double from, double to) const {
  return on_grid<Integer>(to, exponent_) - on_grid<Integer>(from, exponent_);
}

// The difference of numbers that fit kWideBits fits the machine's integers. A shift and a subtraction there cost less
// than in the wide type.
template <>
WideInteger IntegerGrid::difference(double from, double to) const {
  return WideInteger(difference<NarrowInteger>(from, to));
}

template <class Integer>
Vector3<Integer> IntegerGrid::vector_between(const Point& from, const Point& to) const {
  FLOWCERT_REQUIRES(!std::is_same_v<Integer, WideInteger> || fits_wide());
  FLOWCERT_REQUIRES(!std::is_same_v<Integer, NarrowInteger> || fits_narrow());
  FLOWCERT_REQUIRES(!std::is_same_v<Integer, SmallInteger> || fits_small());
  return {difference<Integer>(from.x, to.x), difference<Integer>(from.y, to.y), difference<Integer>(from.z, to.z)};
}

template Vector3<BigInteger> IntegerGrid::vector_between(const Point&, const Point&) const;
template Vector3<SmallInteger> IntegerGrid::vector_between(const Point&, const Point&) const;
template Vector3<NarrowInteger> IntegerGrid::vector_between(const Point&, const Point&) const;
template Vector3<WideInteger> IntegerGrid::vector_between(const Point&, const Point&) const;

}  // namespace flowcert::geometry
