// All constants of the double filters. Each is what its proof needs, rounded up to a number of few bits. What that is
// stands after a colon, and spec/proofs/filters/Proved.v computes it.
//
// Guarantees: a filter that answers is right while the arithmetic is IEEE 754's, rounds to nearest, keeps subnormals
// and fuses nothing (floating_point.h checks that). spec/proofs/ proves it of all inputs, and
// tests/unit/filter_bounds_test.cpp holds every bound against exact errors.
//
// u = 2^-53. A difference of coordinates, a product and a sum each add one relative error of at most u. With a, b, …
// the computed vectors and |a| their norms, a dot product is wrong by 5 u |a||b| at most, and a cross product by
// (2 + 2.4143) u |a||b|, because the sum of its absolute products is at most sqrt(2) |a||b|.
// That holds while nothing overflows and underflow is negligible. It is checked once for each set of vectors: if a
// norm lies outside [kSmallestNorm, kLargestNorm], the filter answers nothing.
#pragma once

namespace flowcert::geometry {

inline constexpr double kUnitRoundoff = 0x1p-53;

// Terms of degree 6 in lengths of this range are normal doubles, also times 2^-53. What underflow can take away (less
// than 2^-1074 times a few lengths) is far below one u of any bound.
inline constexpr double kSmallestNorm = 1e-42;
inline constexpr double kLargestNorm = 1e42;

// ---- Single predicates (predicates.h), in units of u ----

inline constexpr double kAngleBound = 6;           // times |a||b|: 5.001
inline constexpr double kOrientationBound = 9;     // times |a||b||c|: 8.415
inline constexpr double kSideOfPlaneBound = 20;    // times (|a||b|)^2 |c| (|a|+|b|+|c|): 19.829
inline constexpr double kOutsideSphereBound = 18;  // times |a||b||c||d| (|a|+|b|+|c|+|d|): 17.415
inline constexpr double kOutsideCircleBound = 23;  // times |a||b||c||d|: 22.829

// ---- All signs of a cell at once (tetrahedron_signs.h), in units of u ----
// a, b, c are seen from vertex 0. L = max(|a|,|b|,|c|) and T = |a||b||c| (|a|+|b|+|c|).

// An angle is a sum of at most four dot products. Times L^2: 28.001.
inline constexpr double kCellAngleBound = 29;
// The s of a facet at vertex 0 is <a x b, numerator>. Times |a||b| T: 19.829.
inline constexpr double kCellSideBound = 20;
// The s of the facet opposite vertex 0 is 2 det^2 minus the other three, because the barycentric coordinates of the
// centre, times 2 det^2, sum to that. (|a||b||c|)^2 is at most T Q / 9 for Q = |a||b|+|b||c|+|c||a|. Times T Q: 27.902.
inline constexpr double kFarCellSideBound = 28;

// On a grid of a power of two, doubles are exact for cells that are small on it: while |a|, |b| and |c| are at most
// this many units, every intermediate result is an integer below 2^53 in units of its degree. The largest one is the s
// of the facet opposite vertex 0: 2 det^2 is at most 2 |.|^6, and the other three are 3 |.|^6 each.
inline constexpr double kExactReach = 305;  // 11 * 305^6 < 2^53

// ---- The samples nearest to a position, in units of u but for the two lengths ----

// A computed distance (three differences, squares, sums, a root) has a relative error of at most 3.51 u. The filter
// compares two of them, with three more roundings: 10.04. 1 + 12 u is a double.
inline constexpr double kDistanceBound = 12;
// Rounding a position x moves each of two distances by sqrt(3) u max|x|: 3.465.
inline constexpr double kPositionBound = 4;
// What underflow takes away from a distance is less than 1e-150. Four times that is needed.
inline constexpr double kDistanceUnderflow = 1e-149;
// Squares of distances up to this one, and their sums, are far below the largest double (1.8e308). Where the filter's
// bound on the least distance is larger, squares may overflow, and the filter answers nothing.
inline constexpr double kLargestDistance = 1e150;

}  // namespace flowcert::geometry
