// Bytes as inputs, for coverage-guided fuzzers: a header byte, then four bytes a row.
//
// Guarantees: total; every byte string is an input of finite coordinates, and bytes that are left over are
// not looked at. A row is a point of a small integer lattice, so that ties are common, in one of a few powers
// of two as a unit, perhaps far from the origin; and each of its coordinates may be an ulp off, so that what
// is nearly a tie is common too. Changing a byte changes one coordinate, one row's ulps, or the lattice.
//
// Header: bits 0-2 the lattice's half width, 3-5 its unit, bit 6: far from the origin, bit 7: ulps count.
// Row: x, y, z modulo the width, and a byte for what is special. Bits 6 and 7 of that, 3: ulps, bits 0-1 of
// x, 2-3 of y, 4-5 of z (1: up, 2: down). 2: an image of the earlier row x, by the cube's symmetry y; so
// there are spheres of many rows in wide lattices too, and repeated rows.
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

// Bytes that mean this input, in the smallest of the lattices; nothing if none do.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_of_input(const Input& input);

}  // namespace flowcert::fuzz
