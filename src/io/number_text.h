// Text to double, exactly as the spec reads numbers.
//
// Guarantees: a decimal becomes the nearest double, ties to even, however long it is; what is too small for
// the smallest subnormal becomes zero. A hexadecimal float (0x…) is taken exactly or refused. NaN, infinities
// and whatever would round to an infinity are refused. Does not look at the locale. Source: spec clauses
// FC-IN-01 and FC-IN-02.
#pragma once

#include <string>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

struct NumberText {
  double value = 0;
  // Why the text is refused; null when it is a number.
  const char* fault = nullptr;
};

// All of `text` must be the number. A leading '+' is accepted.
[[nodiscard]] NumberText parse_number(std::string_view text);

// `text` for a message: in single quotes, on one line and not long, whatever it holds.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace flowcert::io
