// All constants of the double filters, with their derivations.
//
// Guarantees: a filter that answers is right while the arithmetic is IEEE 754's, rounds to nearest, keeps subnormals
// and fuses nothing (floating_point.h checks that). tests/unit/filter_bounds_test.cpp holds every bound against exact
// errors.
//
// u = 2^-53. A difference of coordinates, a product and a sum each add one relative error of at most u. With a, b, …
// the computed vectors and |a| their norms, these errors add up to the bounds below. The constants are rounded up,
// which covers the terms of second order and the rounding of the norms:
//   <a,b>                     5.1 u |a||b|
//   a x b (norm)              5.7 u |a||b|       (sum of the absolute products is at most sqrt(2) |a||b|)
//   <a, b x c>                9.8 u |a||b||c|
//   numerator of the centre  13.8 u T,           T = |a||b||c| (|a|+|b|+|c|)
// They hold while nothing overflows and underflow is negligible. That is checked once for each set of vectors: if a
// norm lies outside [kSmallestNorm, kLargestNorm], the filter answers nothing.
#pragma once

namespace flowcert::geometry {

inline constexpr double kUnitRoundoff = 0x1p-53;

// Terms of degree 6 in lengths of this range are normal doubles, also times 2^-53. What underflow can take away (less
// than 2^-1074 times a few lengths) is far below one u of any bound.
inline constexpr double kSmallestNorm = 1e-42;
inline constexpr double kLargestNorm = 1e42;

// ---- Single predicates (predicates.h), in units of u ----

inline constexpr double kAngleBound = 6;           // times |a||b|: a dot product
inline constexpr double kOrientationBound = 10;    // times |a||b||c|
inline constexpr double kSideOfPlaneBound = 24;    // times |a||b| T: <a x b, numerator>, 13.8 + 5.7 + 3
inline constexpr double kOutsideSphereBound = 20;  // times |a||b||c||d| (|a|+|b|+|c|+|d|)
// It covers two products of a dot product (5.1) and one coordinate of a cross product (5.7), and their sum. It is
// times the product of all four norms.
inline constexpr double kOutsideCircleBound = 27;

// ---- All signs of a cell at once (tetrahedron_signs.h), in units of u ----
// a, b, c are seen from vertex 0, and L = max(|a|,|b|,|c|).

// An angle is a sum of at most four dot products (5.1 L^2 each) and three additions (9 L^2). Times L^2.
inline constexpr double kCellAngleBound = 32;
// The s of a facet at vertex 0 is <a x b, numerator>: 13.8 + 5.7 + 3 = 22.5. Times |a||b| T.
inline constexpr double kCellSideBound = 32;
// The s of the facet opposite vertex 0 is 2 det^2 minus the other three, because the barycentric coordinates of the
// centre, times 2 det^2, sum to that. With Q = |a||b|+|b||c|+|c||a| and (|a||b||c|)^2 <= T Q / 9 its error is
// (22.5 + 3 + (41.2 + 6) / 9) T Q. Times T Q.
inline constexpr double kFarCellSideBound = 64;

// On a grid of a power of two, doubles are exact for cells that are small on it: while |a|, |b| and |c| are at most
// this many units, every intermediate result is an integer below 2^53 in units of its degree. The largest one is the s
// of the facet opposite vertex 0: 2 det^2 <= 6 |.|^6, and three times a sum of three products of |.|^2 and 3 |.|^4.
inline constexpr double kExactReach = 250;  // 33 * 250^6 < 2^53

// ---- The samples nearest to a position, in units of u but for the two lengths ----

// A computed distance (three differences, squares, sums, a root) has a relative error of at most 8 u. The filter adds
// four times that to the least distance.
inline constexpr double kDistanceBound = 32;
// Rounding a position x moves a distance by less than 2 u max|x|.
inline constexpr double kPositionBound = 8;
// What underflow takes away from a distance is less than 1e-150.
inline constexpr double kDistanceUnderflow = 1e-149;
// Squares of distances up to this one, and their sums, are far below the largest double (1.8e308). Where the filter's
// bound on the least distance is larger, squares may overflow, and the filter answers nothing.
inline constexpr double kLargestDistance = 1e150;

}  // namespace flowcert::geometry
