// See rank_lines.h. A piece's tag says whether it is the last one of its line.
#include "fuzz/commands/mpi/rank_lines.h"

#include <array>
#include <chrono>
#include <set>
#include <thread>
#include <utility>

namespace flowcert::commands {

namespace {

// Transports of Open MPI and MPICH send 4096 bytes at once, less a header.
constexpr std::size_t kPieceSize = 2048;
constexpr int kLastTag = 1;
constexpr int kMoreTag = 2;

}  // namespace

RankLines::RankLines() {
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  received_.resize(static_cast<std::size_t>(size_));
}

void RankLines::forget_sent_pieces() {
  for (auto piece = on_their_way_.begin(); piece != on_their_way_.end();) {
    int is_sent = 0;
    const bool has_failed = MPI_Test(&piece->request, &is_sent, MPI_STATUS_IGNORE) != MPI_SUCCESS;
    piece = has_failed || is_sent != 0 ? on_their_way_.erase(piece) : std::next(piece);
  }
}

void RankLines::send(int to, const std::string& line) {
  forget_sent_pieces();
  for (std::size_t start = 0; start == 0 || start < line.size(); start += kPieceSize) {
    Piece& piece = on_their_way_.emplace_back();
    piece.text = line.substr(start, kPieceSize);
    const bool is_last = start + kPieceSize >= line.size();
    const int failure = MPI_Isend(piece.text.data(), static_cast<int>(piece.text.size()), MPI_CHAR, to,
                                  is_last ? kLastTag : kMoreTag, MPI_COMM_WORLD, &piece.request);
    if (failure != MPI_SUCCESS) on_their_way_.pop_back();
  }
}

std::optional<RankLines::Line> RankLines::receive() {
  while (true) {
    int is_there = 0;
    MPI_Status status;
    const int failure = MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
    if (failure != MPI_SUCCESS || is_there == 0) return std::nullopt;
    std::array<char, kPieceSize> bytes{};
    if (MPI_Recv(bytes.data(), static_cast<int>(bytes.size()), MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG,
                 MPI_COMM_WORLD, &status) != MPI_SUCCESS) {
      return std::nullopt;
    }
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    std::string& line = received_.at(static_cast<std::size_t>(status.MPI_SOURCE));
    line.append(bytes.data(), static_cast<std::size_t>(size));
    if (status.MPI_TAG == kLastTag) return Line{status.MPI_SOURCE, std::exchange(line, {})};
  }
}

bool RankLines::have_said(const std::string& word, int ranks, double seconds, const std::string& other) {
  const auto start = std::chrono::steady_clock::now();
  std::set<int> who;
  while (std::ssize(who) < ranks) {
    const auto line = receive();
    if (line && line->text == word) who.insert(line->from);
    if (line && line->text == other) return false;
    if (line) continue;
    const double so_far = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (so_far > seconds) return false;
    forget_sent_pieces();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace flowcert::commands
