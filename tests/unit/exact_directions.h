// A direction in floating point beside the same one in integers.
//
// Guarantees: the comparison is made in rationals, so nothing is rounded in it.
#pragma once

#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>

#include "flow/kernels/direction.h"
#include "flow/kernels/exact_direction.h"
#include "flowcert/rational.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

inline std::ostream& operator<<(std::ostream& out, const DoubleDouble& x) {
  return out << x.high() << " + " << x.low();
}

}  // namespace flowcert::geometry

namespace flowcert_tests {

using flowcert::Point;
using flowcert::Rational;
using flowcert::flow::Direction;
using flowcert::flow::Extended;
using flowcert::flow::FacetEdge;
using flowcert::flow::IntegerDirection;
using flowcert::flow::Precision;
using flowcert::geometry::DoubleDouble;
using RationalVector = flowcert::geometry::Vector3<Rational>;

// ---- Numbers, exactly ----

inline Rational exact_number(double value) { return Rational(value); }
inline Rational exact_number(const DoubleDouble& value) { return Rational(value.high()) + Rational(value.low()); }
inline Rational exact_number(const Extended& value) {
  int exponent = 0;
  const Extended mantissa = frexp(value, &exponent);
  const flowcert::geometry::BigInteger whole(ldexp(mantissa, 256));
  flowcert::geometry::BigInteger power(1);
  power <<= std::abs(exponent - 256);
  return exponent < 256 ? Rational(whole, power) : Rational(whole) * Rational(power);
}
template <class Number>
RationalVector exact_vector(const flowcert::geometry::Vector3<Number>& v) {
  return {exact_number(v.x), exact_number(v.y), exact_number(v.z)};
}
inline RationalVector exact_vector(const Point& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
inline RationalVector exact_vector(const IntegerDirection& u) { return {Rational(u.x), Rational(u.y), Rational(u.z)}; }

// The nearest number, up to a few roundoffs.
template <class Number>
Number rounded_number(const Rational& value) {
  if constexpr (std::is_same_v<Number, double>) {
    return static_cast<double>(value);
  } else if constexpr (std::is_same_v<Number, DoubleDouble>) {
    const auto high = static_cast<double>(value);
    return Number::sum(high, static_cast<double>(Rational(value - Rational(high))));
  } else {
    return Extended(flowcert::geometry::BigInteger(numerator(value))) /
           Extended(flowcert::geometry::BigInteger(denominator(value)));
  }
}

inline Rational squared(const RationalVector& v) { return dot(v, v); }
inline bool is_zero(const RationalVector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// ---- The comparison ----

// Empty if the known direction keeps its promise: its length, what leaves the facet's plane, and its angle with the
// true direction in the plane. Within a cell there is no plane.
template <class Number>
std::string broken_bound(const Direction<Number>& x, const IntegerDirection& truth, FacetEdge facet) {
  const Rational roundoff = exact_number(Number(Precision<Number>::kRoundoff));
  const RationalVector u = exact_vector(x.u), t = exact_vector(truth);
  const RationalVector e = exact_vector(*facet.p1) - exact_vector(*facet.p0);
  const Rational error = exact_number(x.error), longest = 1 + 16 * roundoff, ee = squared(e);
  std::ostringstream text;
  if (error < 0 || error > Rational(1) / 8) text << "the error is " << x.error << "; ";
  if (squared(u) > longest * longest) text << "it is longer than 1; ";
  RationalVector in_plane = u;
  if (ee > 0) {
    const Rational along = dot(u, e);
    if (along * along > 144 * roundoff * roundoff * squared(u) * ee) text << "it leaves the plane; ";
    in_plane = u - Rational(along / ee) * e;
  }
  const Rational forth = dot(in_plane, t);
  if (forth <= 0) {
    text << "it points back; ";
  } else if (squared(cross(in_plane, t)) > error * error * forth * forth) {
    text << "its angle is beyond " << x.error << "; ";
  }
  return text.str();
}

}  // namespace flowcert_tests
