// Bytes as inputs, for coverage-guided fuzzers: a header byte, then four bytes a row.
//
// Guarantees: every byte string is an input of finite coordinates; bytes that are left over are ignored. A row is a
// point of a small integer lattice, so ties are common. The lattice's unit is one of a few powers of two, and the
// lattice may be far from the origin. Each coordinate may be an ulp off, so near ties are common too. Changing a byte
// changes little: one coordinate, one row's ulps, or the lattice.
//
// Header: bits 0-2 are the lattice's half width, bits 3-5 its unit. Bit 6: it is far from the origin. Bit 7: ulps
// count. Row: x, y, z modulo the width, and a special byte. If bits 6-7 of that byte are 3, it has ulps: bits 0-1 for
// x, 2-3 for y, 4-5 for z (1: up, 2: down). If they are 2, the row is the image of the earlier row x by the cube's
// symmetry y. So wide lattices too have spheres of many rows, and repeated rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

using Bytes = std::span<const std::uint8_t>;

[[nodiscard]] Input input_of_bytes(Bytes bytes, std::size_t most_rows);

// Bytes that decode to this input, in the first lattice that has it. Returns nothing if no lattice has it.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_of_input(const Input& input);

}  // namespace flowcert::fuzz
