// What made a result: enough for somebody else to make it again. Printed by `flowcert --version` and written
// into the header of every output (spec/formats/README.md).
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

// SHA-256, in hexadecimal, of x, y, z of each row as little-endian IEEE doubles, -0.0 as 0.0. O(rows).
[[nodiscard]] std::string coordinates_sha256(const PointSet& points);

// One line, for formats that have room for a comment only: format and its version, the reproducibility line,
// the hash of the input.
[[nodiscard]] std::string made_by_text(const char* format, int format_version, const PointSet& points);

}  // namespace flowcert
