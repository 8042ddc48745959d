// What a program does where memory ends.
//
// Guarantees: after prepare_for_out_of_memory() it says "PROGRAM: out of memory" and ends with status 2, at once,
// wherever new, GMP or main() finds no memory: nothing is unwound, so that nothing on the way takes the failure for
// something else, as streams do. No temporary file of an OutputFile stays.
#pragma once

#include "io/layer.h"

namespace flowcert::io {

inline constexpr int kOutOfMemoryStatus = 2;

// Called once, at the beginning of a program, whose name must last.
void prepare_for_out_of_memory(const char* program);

// Says it and ends, without taking memory.
[[noreturn]] void end_out_of_memory();

// While it stands, this thread gets std::bad_alloc instead, and the program goes on. For what a stranger's answer
// takes.
class ThrowsOutOfMemory {
 public:
  ThrowsOutOfMemory();
  ~ThrowsOutOfMemory();
  ThrowsOutOfMemory(const ThrowsOutOfMemory&) = delete;
  ThrowsOutOfMemory& operator=(const ThrowsOutOfMemory&) = delete;
};

}  // namespace flowcert::io
