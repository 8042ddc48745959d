// A rank that works: its process of batches, and the way of lines between it and rank 0.
//
// Guarantees: it says that it is there as long as it is, however long a case takes. It comes back when rank 0
// has ended the campaign, and ends by itself when rank 0 is not heard of any more. By a signal that asks it
// to end it leaves the campaign, after the case under way, which goes on without it.
//
// Lines to rank 0: those of batch_process.h, and "alive", and "ended" when the process is gone.
// From it: those of batch_process.h, "alive", "end", and then "finalize", or "leave" if a rank is missing.
#pragma once

#include "fuzz/commands/mpi/batch_process.h"
#include "fuzz/commands/mpi/fuzz_mpi_options.h"
#include "fuzz/commands/mpi/rank_lines.h"

namespace flowcert::commands {

void work_for_rank_0(RankLines& lines, BatchProcess& process, const FuzzMpiOptions& options);

}  // namespace flowcert::commands
