// The ranks of `flowcert-fuzz-mpi`: rank 0 leads, the others work, and lines of text go between them.
#pragma once

#include <mpi.h>

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/commands/fuzz_progress.h"
#include "fuzz/commands/layer.h"
#include "fuzz/commands/mpi/batch_process.h"

namespace flowcert::commands {

// ---- Lines ----
// Nothing here waits for another rank, even if that rank is dead. Lines of one rank arrive whole and in order. A line
// to a rank that is gone is lost, and nobody hears of it. A rank counts as gone when it is not heard of.
//
// Lines are cut into pieces so small that every transport sends them at once, without asking the receiver first.
// Otherwise a receiver that asks for the rest of a message would wait for a rank that is killed meanwhile.

class RankLines {
 public:
  // The ranks are those of MPI_COMM_WORLD; it lives between MPI_Init and MPI_Finalize.
  RankLines();
  RankLines(const RankLines&) = delete;
  RankLines& operator=(const RankLines&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  void send(int to, const std::string& line);
  struct Line {
    int from = 0;
    std::string text;
  };
  // Returns nothing if no line is there yet.
  [[nodiscard]] std::optional<Line> receive();
  // Whether `ranks` ranks say `word` within `seconds`, and no rank says `other` before. All other lines that arrive
  // meanwhile are lost.
  [[nodiscard]] bool have_said(const std::string& word, int ranks, double seconds, const std::string& other = "");

 private:
  struct Piece {
    MPI_Request request = MPI_REQUEST_NULL;
    std::string text;
  };

  void forget_sent_pieces();

  int rank_ = 0;
  int size_ = 1;
  std::list<Piece> on_their_way_;      // a list: MPI keeps the addresses
  std::vector<std::string> received_;  // by rank: the pieces of a line so far
};

// ---- The leading rank ----
// Rank 0 has the campaign, hands its batches out to the other ranks, and gathers what comes of them.
//
// Guarantees: it never waits for a rank. If a rank is gone, or silent for too long, its batch is handed out again, so
// the results are the same. A rank that is heard of again is employed again. The campaign ends when all is done, when
// somebody stops it, or when no rank is left. If a rank is lost while it makes a crash small, the crash stays as it
// is until `flowcert fuzz --resume`.
struct LedCampaign {
  // The ranks that were not heard of. They may be dead, and MPI would wait for them.
  int silent_ranks = 0;
  // Whether no rank was left although there was more to do.
  bool is_deserted = false;
};

[[nodiscard]] LedCampaign lead(fuzz::Campaign& campaign, RankLines& lines, const FuzzMpiOptions& options,
                               FuzzProgress& progress);

// ---- A working rank ----
// A rank that works passes lines between rank 0 and its process of batches.
//
// Guarantees: it says that it is there as long as it runs, however long a case takes. It returns when rank 0 has
// ended the campaign, and aborts when rank 0 is not heard of any more. After a signal that asks it to end, it
// finishes the case under way and leaves; the campaign goes on without it.
//
// It sends rank 0 the lines of batch_process.h, "alive", and "ended" when its process is gone. Rank 0 sends the lines
// of batch_process.h, "alive", "end", and then "finalize", or "leave" if a rank is missing.
void work_for_rank_0(RankLines& lines, BatchProcess& process, const FuzzMpiOptions& options);

}  // namespace flowcert::commands
