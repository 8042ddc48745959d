// Reads point files: XYZ/text, OFF, PLY (ascii and both binaries), OBJ, each also gzip-compressed.
//
// Guarantees: all or nothing. Either every row of the file comes back, in the file's order, finite and
// exactly the double that the file means (nearest to a decimal, ties to even; hexadecimal floats and binary
// floats exact), or InvalidInput is thrown and names file and line. Nothing is merged or skipped, and no
// number in a header can make it allocate more than a small multiple of the file's (decompressed) size.
// Independent of the locale. Source: spec clauses FC-IN-01, FC-IN-02, FC-IN-05; spec/formats/points.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flowcert/point_set.h"

namespace flowcert {

struct PointFile {
  std::vector<Point> rows;
  // The coordinates were stored as 32-bit floats (binary PLY), and are the doubles of the same values.
  bool single_precision = false;
  // The file declares 32-bit floats but holds decimals (ascii PLY): they are the nearest doubles all the
  // same.
  bool declares_single_precision = false;
  // "xyz", "off", "ply" or "obj": what the file was read as.
  std::string format;
};

// Reads the file at `path`, by the format of its ending (before .gz; xyz for an unknown one). "-" is standard
// input, whose format is recognised by content. Throws InvalidInput: one line, "FILE:LINE: reason" or "FILE:
// reason".
[[nodiscard]] PointFile read_points(const std::string& path);

// The same from memory. `name` is used in messages and, by its ending, for the format; "-" is by content.
[[nodiscard]] PointFile read_points_from(std::string_view bytes, const std::string& name);

}  // namespace flowcert
