// A fuzz target is one function from bytes to a complaint.
//
// Guarantees: none here. Each target has a file that defines the function; read_points.cpp and read_claims.cpp serve a
// target for each format. entry_point.cpp makes it what libFuzzer and AFL++ call, and replay.cpp runs it on files.
#pragma once

#include <initializer_list>
#include <string>

#include "fuzz/inputs/byte_input.h"

namespace flowcert::property {
struct Trial;
}  // namespace flowcert::property

namespace flowcert::fuzz {

// Empty if all is well; otherwise everything that there is to say, input and answers. Anything else that happens,
// such as an exception that leaves it, is a counterexample too.
[[nodiscard]] std::string complaint_of(Bytes bytes);

// For targets that hold properties of campaigns: the complaint of the first of the named ones that does not hold, with
// the input as rows of a point file. Empty if all hold. The names must exist.
[[nodiscard]] std::string complaint_of(std::initializer_list<const char*> properties, const property::Trial& trial);

}  // namespace flowcert::fuzz
