// A fuzz target is one function from bytes to a complaint.
//
// Guarantees: none here. Each target has a file that defines the function; read_points.cpp and read_claims.cpp serve a
// target for each format. entry_point.cpp makes it what libFuzzer and AFL++ call, and replay.cpp runs it on files.
#pragma once

#include <string>

#include "fuzz/inputs/byte_input.h"

namespace flowcert::fuzz {

// Empty if all is well; otherwise everything that there is to say, input and answers. Anything else that happens,
// such as an exception that leaves it, is a counterexample too.
[[nodiscard]] std::string complaint_of(Bytes bytes);

}  // namespace flowcert::fuzz
