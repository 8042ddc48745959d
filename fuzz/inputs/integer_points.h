// Building blocks of the families: integers, integer points, integer rotations, and lists of them as
// generators; and all integer points of small spheres and circles.
//
// Guarantees: portable. The only randomness is rc::Random; no std distribution, whose results differ between
// standard libraries. Integers shrink towards zero, rotations towards the identity, lists element by element;
// rows are removed by `shrink_by_removing`, which every family ends with, so that no generator has to take
// care of that itself.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

using Integer = std::int64_t;
using IntegerPoint = std::array<Integer, 3>;
using IntegerPoints = std::vector<IntegerPoint>;

Integer dot(const IntegerPoint& a, const IntegerPoint& b);
IntegerPoint cross(const IntegerPoint& a, const IntegerPoint& b);
IntegerPoint plus(const IntegerPoint& a, const IntegerPoint& b);
IntegerPoint times(Integer factor, const IntegerPoint& a);

// numerator / denominator to the nearest integer, halves upwards. The denominator is positive.
Integer nearest_integer(Integer numerator, Integer denominator);

// Uniform in [low, high]; shrinks towards the integer of the range that is nearest to zero.
rc::Gen<Integer> whole(Integer low, Integer high);
rc::Gen<IntegerPoint> integer_point(Integer low, Integer high);

// One of the list's elements; shrinks towards the first. The list is copied once, since the generators are copied
// often.
template <typename List>
rc::Gen<typename List::value_type> one_of(const List& list) {
  return rc::gen::map(
      whole(0, static_cast<Integer>(list.size()) - 1),
      [kept = std::make_shared<const List>(list)](Integer place) { return (*kept)[static_cast<std::size_t>(place)]; });
}

// A number from least to most. Small ones come more often, and `most` only near size 100. It does not shrink.
rc::Gen<std::size_t> row_count(std::size_t least, std::size_t most);

// A list of row_count(least, most) elements; shrinks its elements, not its length.
template <typename T>
rc::Gen<std::vector<T>> list_of(std::size_t least, std::size_t most, const rc::Gen<T>& element) {
  return rc::gen::mapcat(row_count(least, most),
                         [element](std::size_t count) { return rc::gen::container<std::vector<T>>(count, element); });
}

// A rotation times the positive integer `norm`: the matrix of a quaternion of integers. Its rows are
// orthogonal and of length `norm`, so it keeps right angles and spheres exactly.
struct IntegerRotation {
  std::array<IntegerPoint, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Integer norm = 1;

  [[nodiscard]] IntegerPoint operator()(const IntegerPoint& point) const;
};
IntegerRotation rotation_of_quaternion(const std::array<Integer, 4>& quaternion);
// Every other one is the identity; the others have quaternions with entries up to `reach`.
rc::Gen<IntegerRotation> integer_rotation(Integer reach);

// Turned by an integer rotation and shifted by a little.
rc::Gen<IntegerPoints> placed(const rc::Gen<IntegerPoints>& points);

IntegerPoints joined(IntegerPoints points, const IntegerPoints& more);
// Without repeated points; the first of each stays.
IntegerPoints distinct(const IntegerPoints& points);
// Exact: all coordinates here are far below 2^53.
Input to_input(const IntegerPoints& points);

// The same inputs, but they shrink by losing rows before anything else.
rc::Gen<Input> shrink_by_removing(const rc::Gen<Input>& inputs);
// The points as inputs that shrink by losing rows; without repeated points; and placed as well.
rc::Gen<Input> input_of(const rc::Gen<IntegerPoints>& points);
rc::Gen<Input> distinct_input(const rc::Gen<IntegerPoints>& points);
rc::Gen<Input> placed_distinct(const rc::Gen<IntegerPoints>& points);

// ---- Points of spheres ----
// All integer points of small integer spheres and circles about the origin: x²+y²+z² = N is the cheapest way
// to many points that are cospherical exactly.
//
// Guarantees: complete, in lexicographic order.
constexpr Integer kLargestTabulatedNorm = 150;

// x² + y² + z² = norm, for norms up to kLargestTabulatedNorm.
const IntegerPoints& sphere_points(Integer norm);
// Those with z = 0.
const IntegerPoints& circle_points(Integer norm);

// A squared radius at which the circle z = 0 has at least 4 points: 1, 2, 5, ... 130.
rc::Gen<Integer> circle_norm();
// A squared radius at which the sphere has at least 24 points.
rc::Gen<Integer> sphere_norm();

// An index into a list whose length is not known yet: to be taken modulo the length.
rc::Gen<std::size_t> raw_index();
const IntegerPoint& at_raw_index(const IntegerPoints& list, std::size_t raw);
// One point for each raw index, and no point twice. There are fewer if the list has fewer.
IntegerPoints at_raw_indices(IntegerPoints list, const std::vector<std::size_t>& raw);

// The points of the list that lie on the positive side of a plane through the origin.
IntegerPoints on_positive_side(const IntegerPoints& list, const IntegerPoint& normal);
// The point must have z = 0.
IntegerPoint quarter_turn(const IntegerPoint& flat);
// Some points of the circle form a polygon that has the origin strictly inside: a square, or a triangle whose
// third corner lies strictly between the square's other two.
IntegerPoints polygon_around_origin(Integer norm, std::size_t first, std::size_t third, bool square);

}  // namespace flowcert::fuzz
