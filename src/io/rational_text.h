// Text to an exact coordinate, as commands take it: a decimal is the nearest double (so that a pasted row of
// a file hits the sample), a hexadecimal float or a fraction p/q is taken exactly.
#pragma once

#include <string_view>

#include "flowcert/rational.h"
#include "io/layer.h"

namespace flowcert::io {

// Throws InvalidInput, one line, for what is no number.
[[nodiscard]] Rational parse_rational(std::string_view text);

// "-3/4", "5": an integer is exact, however large it is. Decimals are refused, as all else, with
// InvalidInput.
[[nodiscard]] Rational exact_rational(std::string_view text);

// Three numbers that parse_rational takes, separated by commas or blanks.
[[nodiscard]] RationalPoint parse_rational_point(std::string_view text);

}  // namespace flowcert::io
