// The formats of point files: their names, how they are recognised by a file's content, and their readers.
//
// Each reader takes the whole file, decompressed and without a byte order mark. The file is not blank. Each guarantees
// what flowcert/read_points.h promises.
#pragma once

#include <string>
#include <string_view>

#include "io/layer.h"
#include "io/point_rows.h"

namespace flowcert::io {

enum class PointFormat { kTable, kPts, kChemical, kOff, kPly, kObj, kPcd, kNpy, kPdb, kPqr, kCif };

// As --format says it.
[[nodiscard]] std::string_view name_of(PointFormat format);
// Throws InvalidInput where no format has this name.
[[nodiscard]] PointFormat format_named(std::string_view name);

// The format that the content has. Throws InvalidInput where it has none or two of them; the message says what the
// content looks like, which formats are read, and how to name one. file: for messages; its ending decides nothing.
[[nodiscard]] PointFormat format_of_content(std::string_view bytes, std::string_view file);

// Whoever names columns has a table, whatever else is in its rows; below a count it is PTS.
[[nodiscard]] PointFormat format_with_columns(std::string_view bytes);

// What read_points_from and read_balls_from have in common. balls: null where no radii are asked for.
[[nodiscard]] PointFile read_content(std::string_view bytes, const std::string& name, const ReadingOptions& options,
                                     BallRows* balls);

void read_as(PointFormat format, std::string_view bytes, PointRows& rows);

void read_table(std::string_view text, PointRows& rows);
void read_pts(std::string_view text, PointRows& rows);
void read_chemical(std::string_view text, PointRows& rows);
void read_off(std::string_view text, PointRows& rows);
void read_ply(std::string_view bytes, PointRows& rows);
void read_obj(std::string_view text, PointRows& rows);
void read_pcd(std::string_view bytes, PointRows& rows);
void read_npy(std::string_view bytes, PointRows& rows);
void read_pdb(std::string_view text, PointRows& rows);
void read_pqr(std::string_view text, PointRows& rows);
void read_cif(std::string_view text, PointRows& rows);

// ---- What a first line can be ----

// The keyword of an OFF file, with its prefixes, at the front of a word; empty if there is none. Digits may follow it.
[[nodiscard]] std::string_view off_keyword(std::string_view word);
// Whether a line of a PDB file can begin so.
[[nodiscard]] bool is_pdb_record(std::string_view line);
// Whether `word` can begin a line of an OBJ file.
[[nodiscard]] bool is_obj_keyword(std::string_view word);
// Whether `word` can begin a line of a PCD file's header.
[[nodiscard]] bool is_pcd_keyword(std::string_view word);
// Whether chemical XYZ can have this line for an atom: an element or a number of one, and three numbers.
[[nodiscard]] bool is_chemical_atom(std::string_view line);
// Whether a table can have this line for a row: three numbers or more at its front.
[[nodiscard]] bool is_row_of_numbers(std::string_view line);

}  // namespace flowcert::io
