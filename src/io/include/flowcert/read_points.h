// Reads point files: tables of numbers, PTS, chemical XYZ, OFF, PLY, OBJ, PCD, NPY, and molecules as PDB, PQR or CIF,
// each also gzip-compressed. The content of a file says which of these it is.
//
// Guarantees: all or nothing. Either every row of the file comes back, in order, or InvalidInput names file and line.
// Coordinates are finite, and are the doubles that the file means: nearest to a decimal (ties to even), exact for
// hexadecimal and binary floats. What can be read in two ways is refused. Nothing is merged. Nothing is left out but
// what ReadingOptions says, and the notes count it. No number in a header can make it allocate more than a small
// multiple of the file's (decompressed) size. The locale has no influence. Source: spec clauses FC-IN-01, FC-IN-02,
// FC-IN-05; spec/formats/points.md.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/atom_names.h"
#include "flowcert/point_set.h"

namespace flowcert {

// What a user says of a file. An option that the file's format does not know is an error.
struct ReadingOptions {
  // "table", "pts", "chemical", "off", "ply", "obj", "pcd", "npy", "pdb", "pqr" or "cif". Empty: the content says it.
  std::string format{};
  // Of a table: which of its columns are x, y, z, by numbers from 1 or by names, as "2,3,4" or "x,y,z". Empty: those
  // named x, y, z, or else the first three.
  std::string columns{};
  // The third coordinate of all rows of a table of two columns.
  std::optional<double> z{};
  // Of a molecule: only the atoms of these chains. They must exist. None: those of all chains.
  std::vector<std::string> chains{};
  // Of a molecule: words for its atoms, as "protein", "chain A" or "no water". Each adds atoms or takes them away, and
  // the first that takes away begins with all atoms. None: all atoms.
  std::vector<std::string> atoms{};
  // Of a molecule: "all", or the names of models with commas. Empty: the first model.
  std::string models{};
  // Of chemical XYZ: which of its frames, from 1. 0: the first.
  std::size_t frame = 0;
  // Leaves out rows with a coordinate that is not a finite number. Without it they are errors.
  bool skip_invalid = false;
  // Also reads compressed files that grow to more than a hundred times their size, or 4 GB.
  bool unlimited = false;
  // Of atoms with radii (read_balls.h) alone: takes those of a crystal's file as a finite set, without their images.
  bool finite = false;
  // Called now and then while the file is read. It may throw, which ends the reading.
  std::function<void()> progress{};
};

// What a user should know of how a file was read. line is 0 where there is none.
struct ReadingNote {
  std::size_t line = 0;
  std::string text;

  friend bool operator==(const ReadingNote&, const ReadingNote&) = default;
};

struct PointFile {
  std::vector<Point> rows;
  // Of a molecule, the names of all rows; otherwise empty.
  AtomNames atoms;
  // As in ReadingOptions.
  std::string format;
  std::vector<ReadingNote> notes;
  // With skip_invalid: which of the file's rows are left out, counted from 0, ascending.
  std::vector<std::size_t> left_out;
};

// Reads the file at `path`; "-" is standard input. Throws InvalidInput with one line, "FILE:LINE: reason" or
// "FILE: reason".
[[nodiscard]] PointFile read_points(const std::string& path, const ReadingOptions& options = {});

// The same from memory. `name` is for messages.
[[nodiscard]] PointFile read_points_from(std::string_view bytes, const std::string& name,
                                         const ReadingOptions& options = {});

}  // namespace flowcert
