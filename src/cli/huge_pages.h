// The program's memory in huge pages, where the system grants them to those who ask.
//
// Guarantees: results are the same with and without. Where addresses are limited to less than 1 GiB, nothing changes.
// A large input is walked from any of its points to any other, so that most accesses to pages of 4 KiB also miss the
// table of pages. In huge ones, 2 MiB, a million points take 40 % less time (tests/bench/README.md).
// Linux's transparent_hugepage/enabled is `madvise`, as many distributions have it; where it is `always` there is
// nothing to ask for, and where it is `never` nothing to get.
#pragma once

#include "cli/layer.h"

namespace flowcert::cli {

// Called once, at the beginning of the program. From then on `new` asks.
void prepare_for_huge_pages();

}  // namespace flowcert::cli
