// The points of a conformance vector as a point file (spec/formats.md, section 1).
//
// Guarantees: a reader that rounds to nearest gets exactly the doubles of the vector: decimals are the
// shortest that read back to them. What an invalid case has in place of a number is written as it is, and is
// all that is wrong with the file.
#pragma once

#include <optional>
#include <string>

#include "fuzz/judge/vector_cases.h"

namespace flowcert::judge {

enum class PointFileFormat { kXyz, kOff };

struct PointFileStyle {
  PointFileFormat format = PointFileFormat::kXyz;
  bool hexadecimal = false;  // hexadecimal floats instead of decimals
};

// Nothing for a case that is about the text of an XYZ file, in another format.
[[nodiscard]] std::optional<std::string> point_file_text(const VectorCase& one, const PointFileStyle& style);

// "points.xyz"
[[nodiscard]] std::string point_file_name(const PointFileStyle& style);

}  // namespace flowcert::judge
