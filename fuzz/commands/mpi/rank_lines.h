// Lines of text between the ranks of an MPI program.
//
// Guarantees: nothing here waits for another rank, whatever has become of it. Lines of one rank arrive whole
// and in order. A line to a rank that is gone is lost, and nobody is told: who is not heard of is gone.
//
// Lines are cut into pieces so small that every transport sends them at once, without asking the receiver
// first: a receiver that has asked for the rest of a message would wait for a rank that is killed meanwhile.
#pragma once

#include <mpi.h>

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/commands/layer.h"

namespace flowcert::commands {

class RankLines {
 public:
  // Of MPI_COMM_WORLD, between MPI_Init and MPI_Finalize.
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

}  // namespace flowcert::commands
