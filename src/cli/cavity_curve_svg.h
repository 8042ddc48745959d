// The number of cavities for each probe as a picture: an SVG file that any browser shows.
#pragma once

#include <string>

#include "cli/layer.h"
#include "flowcert/pores.h"

namespace flowcert::cli {

// source: what the numbers are of, which is written under the title. O(cavities).
[[nodiscard]] std::string cavity_curve_svg(const Pores& pores, const std::string& source);

}  // namespace flowcert::cli
