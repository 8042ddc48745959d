// Small inputs with several pockets: chambers with mouths between them, and cells of the face-centred lattice.
//
// Guarantees: the same input for the same seed, on every machine; few different distances, so that many are equal; at
// most 18 points.
#pragma once

#include <cstdint>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

// Triangles and squares around the z axis, of three sizes, some of them turned or moved, and often closed at the ends.
// Each chamber between them has a maximum or several.
std::vector<Row> chambers(std::uint64_t seed);

// A cell of the face-centred lattice with some corners left out or added. Its shallow holes lead to several others at
// once.
std::vector<Row> face_centred_cell(std::uint64_t seed);

// The one or the other.
Input input_with_pockets(std::uint64_t seed);

}  // namespace flowcert::fuzz
