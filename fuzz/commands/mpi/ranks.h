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
// Nothing here waits for another rank, whatever has become of it. Lines of one rank arrive whole and in order. A
// line to a rank that is gone is lost, and nobody is told: who is not heard of is gone.
//
// Lines are cut into pieces so small that every transport sends them at once, without asking the receiver
// first: a receiver that has asked for the rest of a message would wait for a rank that is killed meanwhile.

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
  // Nothing: none is there yet.
  [[nodiscard]] std::optional<Line> receive();
  // Whether so many ranks say this word within so many seconds, and none before says the other one. Further
  // lines are lost.
  [[nodiscard]] bool have_said(const std::string& word, int ranks, double seconds,
                               const std::string& other = "");

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
// Rank 0: it has the campaign, hands its batches out to the other ranks, and gathers what comes of them.
//
// Guarantees: it never waits for a rank. The batch of a rank that is gone, or that is not heard of for too
// long, is handed out again, so that the account is the same without it; one that is heard of again is
// employed again. The campaign ends when all is done, when it is told to stop, or when no rank is left. A
// crash that a rank was making small when it was lost stays as it is, until `flowcert fuzz --resume`.
struct LedCampaign {
  // That were not heard of: they may be dead, and MPI would wait for them.
  int silent_ranks = 0;
  // Whether none was left although there was more to do.
  bool is_deserted = false;
};

[[nodiscard]] LedCampaign lead(fuzz::Campaign& campaign, RankLines& lines, const FuzzMpiOptions& options,
                               FuzzProgress& progress);

// ---- A working rank ----
// A rank that works: its process of batches, and the way of lines between it and rank 0.
//
// Guarantees: it says that it is there as long as it is, however long a case takes. It comes back when rank 0
// has ended the campaign, and ends by itself when rank 0 is not heard of any more. By a signal that asks it
// to end it leaves the campaign, after the case under way, which goes on without it.
//
// Lines to rank 0: those of batch_process.h, and "alive", and "ended" when the process is gone.
// From it: those of batch_process.h, "alive", "end", and then "finalize", or "leave" if a rank is missing.
void work_for_rank_0(RankLines& lines, BatchProcess& process, const FuzzMpiOptions& options);

}  // namespace flowcert::commands
