// Named point sets that the recipes place by hand.
//
// Guarantees: exact, the same on every machine; all coordinates are doubles without rounding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oracle::vectors {

using Row = std::array<double, 3>;
using Rows = std::vector<Row>;

inline const Rows kAcuteTriangle = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}};
inline const Rows kRightTriangle = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
inline const Rows kTetrahedron = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
// Each has one regular stationary point, of kind 2-3 and 1-3.
inline const Rows kKind23 = {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}};
inline const Rows kKind13 = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const Rows kUnmergedFaces = {{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}};
inline const Rows kSquareAndPoint = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}};
inline const Rows kPentagonPyramid = {{5, 0, 0}, {3, 4, 0}, {-4, 3, 0}, {-4, -3, 0}, {0, -5, 0}, {0, 0, 7}};
inline const Rows kPrism = {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {5, 0, 6}, {-3, 4, 6}, {-3, -4, 6}};
// The orbit from {0,1,2} ends at {0,3,4}, whose stable set has the volume 50 of the hull's 140. The boundary of the
// maximum's boundary is zero for some ways of breaking its ties, and not for others.
inline const Rows kTieInTheComplex = {{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}};

// The points {0..a-1} x {0..b-1} x {0..c-1}, in lexicographic order.
Rows grid(int a, int b, int c);
// The first so many integer points with x² + y² + z² = norm in lexicographic order; all of them if there are
// not so many. Norm 1 is the octahedron, 2 the cuboctahedron, 3 the cube.
Rows sphere(int norm, std::size_t most = 1000);
// x² + y² = norm, at a height.
Rows circle(int norm, double height);
// So many different points of {0..width-1}^3.
Rows scattered(std::size_t count, std::uint64_t width, std::uint64_t seed);
// So many points with 53-bit coordinates in [0, 1).
Rows general(std::size_t count, std::uint64_t seed);

Rows joined(Rows some, const Rows& others);
Rows shifted(Rows rows, const Row& offset);
// The rows times 2^exponent.
Rows scaled(Rows rows, int exponent);
// One coordinate replaced by the neighbouring double, upwards (1) or downwards (-1).
Rows nudged(Rows rows, std::size_t row, std::size_t axis, int steps);
// The first so many rows.
Rows first_of(Rows rows, std::size_t count);

}  // namespace oracle::vectors
