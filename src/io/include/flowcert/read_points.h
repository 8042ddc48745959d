// Reads point files: XYZ/text, OFF, PLY (ascii and both binaries), OBJ, and molecules as PDB or mmCIF, each also
// gzip-compressed.
//
// Guarantees: all or nothing. Either every row of the file comes back, in order, or InvalidInput names file and line.
// Coordinates are finite, and are the doubles that the file means: nearest to a decimal (ties to even), exact for
// hexadecimal and binary floats. Nothing is merged or skipped, but for what a molecule's fields below count. No number in a header can make it allocate more than a
// small multiple of the file's (decompressed) size. The locale has no influence. Source: spec clauses FC-IN-01,
// FC-IN-02, FC-IN-05; spec/formats/points.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flowcert/point_set.h"

namespace flowcert {

struct PointFile {
  std::vector<Point> rows;
  // The file stores the coordinates as 32-bit floats (binary PLY). The rows are doubles of the same values.
  bool single_precision = false;
  // The file declares 32-bit floats but holds decimals (ascii PLY). The rows are still the doubles nearest to the
  // decimals.
  bool declares_single_precision = false;
  // The first line of an XYZ file with more than three numbers, and the first with a comma between two of its numbers
  // and blanks alone between others, as in "0,1 2 3". 0: there is none.
  std::size_t line_of_further_columns = 0;
  std::size_t line_of_mixed_separators = 0;
  // Of a molecule: models after the first one, and further places of atoms that have several. They are not read.
  std::size_t other_models = 0;
  std::size_t other_locations = 0;
  // The format that the file was read as: "xyz", "off", "ply", "obj", "pdb" or "mmcif".
  std::string format;
};

// Reads the file at `path`. The ending of its name (before .gz) says the format; an unknown ending means xyz. "-" is
// standard input, whose format is recognised by content. Throws InvalidInput with one line, "FILE:LINE: reason" or
// "FILE: reason".
// chains: of a molecule, only the atoms of these chains are points. They must exist. None: those of all chains. Other
// formats have no chains, and naming one is an error.
[[nodiscard]] PointFile read_points(const std::string& path, const std::vector<std::string>& chains = {});

// The same from memory. `name` is for messages, and its ending says the format. For "-", the content does.
[[nodiscard]] PointFile read_points_from(std::string_view bytes, const std::string& name,
                                         const std::vector<std::string>& chains = {});

}  // namespace flowcert
