// All integer points of small integer spheres and circles about the origin: x²+y²+z² = N is the cheapest way
// to many points that are cospherical exactly.
//
// Guarantees: complete, in lexicographic order.
#pragma once

#include <cstddef>
#include <vector>

#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

constexpr Integer kLargestTabulatedNorm = 150;

// x² + y² + z² = norm, for norms up to kLargestTabulatedNorm.
const IntegerPoints& sphere_points(Integer norm);
// Those with z = 0.
const IntegerPoints& circle_points(Integer norm);

// A squared radius at which the circle z = 0 has at least 4 points: 1, 2, 5, ... 130.
rc::Gen<Integer> circle_norm();
// One at which the sphere has at least 24 points.
rc::Gen<Integer> sphere_norm();

// An index into a list whose length is not known yet: to be taken modulo the length.
rc::Gen<std::size_t> raw_index();
const IntegerPoint& at_raw_index(const IntegerPoints& list, std::size_t raw);
// One a raw index, none of them twice; fewer where the list has fewer.
IntegerPoints at_raw_indices(IntegerPoints list, const std::vector<std::size_t>& raw);

// Those of the list on the positive side of a plane through the origin.
IntegerPoints on_positive_side(const IntegerPoints& list, const IntegerPoint& normal);
// Of a point with z = 0.
IntegerPoint quarter_turn(const IntegerPoint& flat);
// Of the circle's points: some polygon that has the origin strictly inside. Either a square, or a triangle
// whose third corner lies strictly between the square's other two.
IntegerPoints polygon_around_origin(Integer norm, std::size_t first, std::size_t third, bool square);

}  // namespace flowcert::fuzz
