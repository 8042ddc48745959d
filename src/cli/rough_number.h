// Exact numbers in six digits, for tables, also where no double is near them.
#pragma once

#include <string>

#include "cli/layer.h"
#include "flowcert/rational.h"

namespace flowcert::cli {

// "0.25", "-1.7e+400".
[[nodiscard]] std::string rough_text(const Rational& number);

// The square root, in the same way. The square must not be negative.
[[nodiscard]] std::string rough_root_text(const Rational& square);

}  // namespace flowcert::cli
