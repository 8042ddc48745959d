// What a fuzz target is: one function from bytes to a complaint.
//
// Guarantees: none here. Each of the files that are named as their targets defines the function;
// entry_point.cpp makes it what libFuzzer and AFL++ call, replay.cpp what runs it on files.
#pragma once

#include <string>

#include "fuzz/inputs/byte_input.h"

namespace flowcert::fuzz {

// Empty if all is well; otherwise everything that there is to say, input and answers. Whatever else happens,
// an exception that leaves it too, is a finding.
[[nodiscard]] std::string complaint_of(Bytes bytes);

}  // namespace flowcert::fuzz
