// A bound on lengths or radii, as commands and expressions take it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/layer.h"
#include "morse/length_bound.h"

namespace flowcert::io {

// "X", in units of the input; "3spacing", a multiple of the samples' spacing; "q0.9", a quantile of all lengths;
// "auto", the length below the valley of their histogram. Numbers are read exactly. Throws InvalidInput for anything
// else: the message begins with the option, and which one of these it is, from 1.
[[nodiscard]] LengthBound length_bound_of(std::string_view text, const std::string& option, std::size_t ordinal);

}  // namespace flowcert::io
