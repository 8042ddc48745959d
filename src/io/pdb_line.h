// One line ATOM or HETATM of a PDB file: its fields, where they can be read in one way alone.
//
// Guarantees: fields stand in fixed columns, but a long serial moves the rest of a line, and numbers that are too long
// run into each other. So the coordinates are read by columns, in the usual place and in the moved one, and by blanks.
// Where blanks part all fields, columns and blanks must agree. Where no blank parts two numbers, each ends in three
// decimals. A line that can be read in two ways, or in none, is refused with its columns.
// Source: spec clause FC-FILE-41; the format's own description, version 3.3.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "io/elements.h"
#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert::io {

struct PdbAtom {
  std::string_view residue, chain, location, element;
  std::string_view name, number;  // of the atom; of the residue, with its insertion code
  // Name; chain, number and insertion code, as the line has them: what alternate locations have in common.
  std::string_view place_name, place_residue;
  bool is_hetatm = false;
  std::array<std::string_view, 3> position;
  ElementText said_element;   // columns 77 and 78, or else the name
  std::string_view radius{};  // of PQR
};

// The columns that an atom's line has at the least.
inline constexpr std::size_t kShortestPdbAtom = 54;

// What a line of a PDB file is. Throws InvalidInput for a line that looks like an atom and is none.
enum class PdbRecord { kAtom, kModel, kEnd, kOther };
[[nodiscard]] PdbRecord pdb_record(std::string_view line, const LinePlace& place);

// The fields of a line that is an atom.
[[nodiscard]] PdbAtom pdb_atom(std::string_view line, const LinePlace& place);

}  // namespace flowcert::io
