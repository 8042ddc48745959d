// Transformations of an input under which its answer is known: scalings by powers of two and rotations by integers,
// only where they are exact on every coordinate.
//
// Guarantees: no rounding. Both give nothing where a coordinate of the result would have to be rounded; the generator
// makes only exact scalings, and shrinks towards the identity.
#pragma once

#include <rapidcheck.h>

#include <optional>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// Times 2^exponent.
std::optional<Input> scaled(const Input& input, int exponent);
rc::Gen<int> exact_scalings(const Input& input);

// Turned, and enlarged by the rotation's norm. Only for integer coordinates, well below 2^53.
std::optional<Input> turned(const Input& input, const IntegerRotation& rotation);

}  // namespace flowcert::fuzz
