// Transformations of an input under which its answer is known: permutations of the rows, signed permutations
// of the axes, scalings by powers of two, translations and rotations by integers, the last three only where
// they are exact on every coordinate.
//
// Guarantees: no rounding. `scaled`, `translated` and `turned` give nothing where a coordinate of the result
// would have to be rounded; the generators make only exact ones, and shrink towards the identity.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <vector>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// Row k of the result is row order[k] of the input.
Input permuted(const Input& input, const std::vector<std::size_t>& order);
rc::Gen<std::vector<std::size_t>> row_orders(std::size_t rows);

// Coordinate k of a result is sign[k] times coordinate axis[k].
struct AxisMap {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
};
// As "+z -x +y".
std::ostream& operator<<(std::ostream& out, const AxisMap& map);
Input mapped(const Input& input, const AxisMap& map);
rc::Gen<AxisMap> axis_maps();

// Times 2^exponent.
std::optional<Input> scaled(const Input& input, int exponent);
rc::Gen<int> exact_scalings(const Input& input);

std::optional<Input> translated(const Input& input, const Row& offset);
// Integer offsets, or one that takes a point of the input to the origin; no offset where none of those tried
// is exact.
rc::Gen<Row> exact_translations(const Input& input);

// Turned, and enlarged by the rotation's norm. Only for integer coordinates, well below 2^53.
std::optional<Input> turned(const Input& input, const IntegerRotation& rotation);

}  // namespace flowcert::fuzz
