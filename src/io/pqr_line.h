// One line ATOM or HETATM of a PQR file, which is PDB with a charge and a radius, and blanks between all fields:
//
//   ATOM serial name residue [chain] number x y z charge radius
//
// Guarantees: a line with more or fewer fields is refused, and so is one whose numbers are none. Source: spec clause
// FC-FILE-54; the description of PDB2PQR.
#pragma once

#include <string_view>

#include "io/layer.h"
#include "io/line_reader.h"
#include "io/pdb_line.h"

namespace flowcert::io {

[[nodiscard]] PdbAtom pqr_atom(std::string_view line, const LinePlace& place);

// Whether the first atom's line is one of PQR, and too short for PDB.
[[nodiscard]] bool begins_as_pqr(std::string_view text);

}  // namespace flowcert::io
