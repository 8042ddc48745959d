// Rank 0: it has the campaign, hands its batches out to the other ranks, and gathers what comes of them.
//
// Guarantees: it never waits for a rank. The batch of a rank that is gone, or that is not heard of for too
// long, is handed out again, so that the account is the same without it; one that is heard of again is
// employed again. The campaign ends when all is done, when it is told to stop, or when no rank is left. A
// crash that a rank was making small when it was lost stays as it is, until `flowcert fuzz --resume`.
#pragma once

#include <string>
#include <vector>

#include "fuzz/commands/fuzz_progress.h"
#include "fuzz/commands/mpi/fuzz_mpi_options.h"
#include "fuzz/commands/mpi/rank_lines.h"

namespace flowcert::commands {

struct LedCampaign {
  // That were not heard of: they may be dead, and MPI would wait for them.
  int silent_ranks = 0;
  // Whether none was left although there was more to do.
  bool is_deserted = false;
};

[[nodiscard]] LedCampaign lead(fuzz::Campaign& campaign, RankLines& lines, const FuzzMpiOptions& options,
                               FuzzProgress& progress);

}  // namespace flowcert::commands
