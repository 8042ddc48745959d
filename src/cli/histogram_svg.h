// A histogram as a picture: an SVG file that any browser shows.
//
// Guarantees: the text is a well-formed document of its own, with no script and no reference to another file. The same
// histogram gives the same bytes.
#pragma once

#include <string>

#include "cli/histogram.h"

namespace flowcert::cli {

// source: what the numbers are of, which is written under the title.
[[nodiscard]] std::string histogram_svg(const Histogram& histogram, const std::string& source);

}  // namespace flowcert::cli
