// The constants of all bounds on directions, and what the bounds need to know of a floating-point type
// (src/flow/cascades.md).
//
// Guarantees: a bound that is made with them holds for doubles and for every longer floating-point type that rounds to
// nearest.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>

#include "flow/kernels/layer.h"
#include "geometry/condition.h"
#include "geometry/double_double.h"
#include "geometry/vector3.h"

namespace flowcert::flow {

using geometry::absolute;
using geometry::condition;
using geometry::Condition;
using geometry::DoubleDouble;
using geometry::least;
using geometry::most;
using geometry::select;

// The longest floating-point type. Its exponents have 32 bits, so that no power of doubles leaves its range.
using Extended = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

// ---- Constants of the bounds (src/flow/cascades.md derives them), in units of the roundoff ----

inline constexpr double kVertexStartBound = 22;  // times |a||b||c| (|a|+|b|+|c|+W)
inline constexpr double kCircleStartBound = 24;  // times |a|^2 |b|^2 (|a|+|b|+W)
inline constexpr double kSideStartBound = 24;    // times |e|^2 |c-p0|
inline constexpr double kGivenStartBound = 4;    // of a direction that is rounded
inline constexpr double kCrossingBound = 37;     // times L^2
inline constexpr double kAngleFormBound = 2;     // an angle h at q, times G^2
inline constexpr double kHeightBound = 6;        // an angle at the corner that is left behind, times L^2
inline constexpr double kExitBound = 20;         // <U,g>, times G
inline constexpr double kOrderBound = 7;         // h_j <U,g_i> - h_i <U,g_j>, times G_i G_j (G_i + G_j)
inline constexpr double kNormalBound = 23;       // <U,n>, times |b-a||c-a|
inline constexpr double kAreaBound = 5;          // |a x b|, times |a||b|

// ---- Constants of the bounds that are numbers ----

// The square of a length in doubles lies between these. Then all terms of degree 10 in such lengths are normal doubles,
// and so are their errors.
inline constexpr double kSmallestSquare = 1e-50;
inline constexpr double kLargestSquare = 1e50;
// An error that is this large is not known to be small. The two rules below need no more than this.
inline constexpr double kLargestError = 0.0625;
// The tangent of an angle with the sine s is at most s (1 + 2 s): s (1 + 0.54 s^2) for s up to kLargestError.
inline constexpr double kTangentOfSine = 2;
// The tangent behind a crossing is at most (kappa t + r) (1 + 5 eta). The rest is for the rounding of the bound.
inline constexpr double kTangentBehind = 8;
// |h| <= G^2 / 4, so that an angle t changes the form of kOrderBound by t / 4.
inline constexpr double kOrderTurn = 0.25;
inline constexpr double kCrossingSlack = 1.0625;  // on the error of a position, for terms of higher order

// What the bounds need to know of a floating-point type.
template <class Number>
struct Precision;

// Doubles, or what is computed as they are.
template <class Number>
struct DoublePrecision {
  static constexpr double kRoundoff = 0x1p-53;
  static auto is_in_range(const Number& square) {
    return condition(square >= kSmallestSquare) & condition(square <= kLargestSquare);
  }
};

template <>
struct Precision<double> : DoublePrecision<double> {};

template <>
struct Precision<DoubleDouble> {
  static constexpr double kRoundoff = DoubleDouble::kRoundoff;
  static int is_in_range(const DoubleDouble& square) { return Precision<double>::is_in_range(square.high()); }
};

template <>
struct Precision<Extended> {
  static constexpr double kRoundoff = 0x1p-256;
  static int is_in_range(const Extended& square) { return condition(square > 0); }
};

}  // namespace flowcert::flow
