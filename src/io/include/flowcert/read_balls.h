// Reads the files of read_points.h as balls: atoms with their radii, exactly.
//
// Guarantees: as those of read_points.h; and a centre is what the file says, not a double near it. Decimals of text
// are taken as they are written, floats of binary files as the doubles that they are. Fractional coordinates are exact
// where the cell has right angles; otherwise they are the doubles of read_points.h, and a note says so. Nothing is
// merged. These are errors, with file and line where there is one: an atom whose radius is not known (the message names
// the atom and the override to give), a radius of 0 or below, a number that would take far more room than a double
// does, and the periodic cell of chemical XYZ or of a crystal's CIF, unless ReadingOptions::finite says that the atoms
// are a finite set. Source: spec clauses FC-FILE-54 and FC-FILE-55.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flowcert/atom_radii.h"
#include "flowcert/ball_set.h"
#include "flowcert/read_points.h"

namespace flowcert {

struct BallFile {
  // The same rows as doubles, with names and notes: what read_points returns.
  PointFile file;
  // One for each of these rows.
  std::vector<Ball> balls;
};

// Radii that the file has (pqr) say its format, too. Throws InvalidInput with one line.
[[nodiscard]] BallFile read_balls(const std::string& path, const ReadingOptions& options, const AtomRadii& radii);

// The same from memory. `name` is for messages.
[[nodiscard]] BallFile read_balls_from(std::string_view bytes, const std::string& name, const ReadingOptions& options,
                                       const AtomRadii& radii);

}  // namespace flowcert
