// The radii of critical points of index 2 as bars, from which one chooses a surface.
#pragma once

#include <optional>

#include "cli/layer.h"
#include "morse/saddle_radii.h"

namespace flowcert::cli {

// A line for each bin. The one that has the threshold is marked, or the nearest one if none has it.
void print_radius_bars(const morse::SaddleRadii& radii, const std::optional<Rational>& squared_threshold);

}  // namespace flowcert::cli
