// What made a result, in enough detail for somebody else to make it again. `flowcert --version` prints it, and every
// output has it in the header (spec/formats/README.md).
#pragma once

#include <string>

#include "flowcert/point_set.h"

namespace flowcert {

struct Reproducibility {
  std::string version;
  std::string commit;  // "unknown" outside a git checkout
  std::string kernel;
  std::string compiler;
  std::string cgal;
};

[[nodiscard]] Reproducibility reproducibility();

// SHA-256, in hexadecimal, of all rows: x, y, z as little-endian IEEE doubles, with -0.0 as 0.0. O(rows).
[[nodiscard]] std::string coordinates_sha256(const PointSet& points);

// One line for formats that only have room for a comment. It has the format and its version, the reproducibility
// line, and the hash of the input.
[[nodiscard]] std::string made_by_text(const char* format, int format_version, const PointSet& points);

}  // namespace flowcert
