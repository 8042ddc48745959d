// Where memory ends, the program says "flowcert-oracle: out of memory" and ends with status 2, also in GMP, which by
// itself would abort.
#pragma once

namespace oracle {

// Called once, at the beginning.
void prepare_for_out_of_memory();
[[noreturn]] void end_out_of_memory();

}  // namespace oracle
