// A piece's tag says whether it is the last one of its line.
#include "fuzz/commands/mpi/ranks.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <thread>
#include <utility>

#include "certify/programs/limited_program.h"
#include "cli/command.h"
#include "fuzz/campaign/batch.h"
#include "io/diagnostic.h"

namespace flowcert::commands {

// ---- Lines ----

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
    // forget_sent_pieces() waits for it.
    // NOLINTNEXTLINE(clang-analyzer-optin.mpi.MPI-Checker)
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
    if (fuzz::seconds_since(start) > seconds) return false;
    forget_sent_pieces();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

// ---- The leading rank ----

namespace {

using Clock = std::chrono::steady_clock;
using fuzz::seconds_since;

constexpr std::chrono::milliseconds kPause{5};
// mpirun passes a signal on, and kills all ranks a second later. So rank 0 waits only so long after a signal.
constexpr double kSecondsAfterSignal = 0.5;

struct Worker {
  int rank = 0;
  bool is_ready = false;
  bool is_silent = false;
  bool is_gone = false;
  bool is_busy = false;  // it has an order, which may have been taken back
  std::optional<std::size_t> batch;
  std::size_t cases = 0;  // done of its batch
  Clock::time_point heard = Clock::now();

  [[nodiscard]] bool is_there() const { return !is_silent && !is_gone; }
};

class Lead {
 public:
  Lead(fuzz::Campaign& campaign, RankLines& lines, const FuzzMpiOptions& options, FuzzProgress& progress)
      : campaign_(campaign), lines_(lines), options_(options), progress_(progress) {
    for (int rank = 1; rank < lines.size(); ++rank) workers_.emplace_back().rank = rank;
  }

  LedCampaign run() {
    tell_all("plan " + fuzz::to_text(campaign_.plan()));
    while (!is_over()) {
      if (!is_stopping_ && is_told_to_stop()) stop();
      if (!take_lines()) std::this_thread::sleep_for(kPause);
      look_for_silence();
      hand_out();
      if (seconds_since(told_) > options_.heartbeat_seconds()) tell_all("alive");
      progress_(under_way());
    }
    return outcome();
  }

 private:
  void tell_all(const std::string& line) {
    told_ = Clock::now();
    for (const Worker& worker : workers_) {
      if (!worker.is_silent) lines_.send(worker.rank, line);
    }
  }
  void say(const Worker& worker, const std::string& what) const {
    if (is_stopping_) return;
    io::tell(fmt::format("flowcert-fuzz-mpi: rank {} {}{}\n", worker.rank, what,
                         worker.batch ? fmt::format("; batch {} is handed out again", *worker.batch) : ""));
  }

  // Returns false if there was no line.
  bool take_lines() {
    bool is_any = false;
    while (const auto line = lines_.receive()) {
      if (line->from == 0) continue;
      is_any = true;
      Worker& worker = workers_.at(static_cast<std::size_t>(line->from) - 1);
      worker.heard = Clock::now();
      if (worker.is_silent) say(worker, "is heard of again");
      worker.is_silent = false;
      take_line(worker, line->text);
    }
    return is_any;
  }

  void take_line(Worker& worker, const std::string& line) {
    if (line.starts_with('{')) return take_message(worker, line);
    if (line.starts_with("cases ")) worker.cases = std::stoull(line.substr(6));
    if (line.starts_with("gone ") && !worker.is_gone) leave_out(worker, "is gone: " + line.substr(5));
    if (line.starts_with("ready ")) {
      worker.is_ready = line.substr(6) == fuzz::program_version();
      if (!worker.is_ready) leave_out(worker, "is of another version: " + line.substr(6));
      if (is_stopping_) lines_.send(worker.rank, "stop");
    }
  }

  void take_message(Worker& worker, const std::string& message) {
    if (!fuzz::ends_batch(message)) return campaign_.absorb(message);
    worker.is_busy = false;
    // A whole batch counts even if another rank has got it meanwhile. A part of a batch counts only if nobody will do
    // the batch again.
    if (!fuzz::ends_whole_batch(message) && !(is_stopping_ && worker.batch)) return take_back(worker);
    campaign_.absorb(message);
    worker.batch.reset();
    worker.cases = 0;
  }

  void take_back(Worker& worker) {
    worker.cases = 0;
    if (!worker.batch) return;
    campaign_.give_back(*worker.batch);
    worker.batch.reset();
    is_dry_ = false;
  }
  void leave_out(Worker& worker, const std::string& why) {
    say(worker, why);
    worker.is_gone = true;
    take_back(worker);
  }
  void look_for_silence() {
    for (Worker& worker : workers_) {
      if (worker.is_silent || seconds_since(worker.heard) < options_.silence_seconds) continue;
      say(worker, fmt::format("has not been heard of for {} s", options_.silence_seconds));
      worker.is_silent = true;
      take_back(worker);
    }
  }

  void hand_out() {
    if (is_stopping_) return;
    for (Worker& worker : workers_) {
      if (!worker.is_ready || !worker.is_there() || worker.is_busy) continue;
      const auto order = campaign_.next_batch();
      is_dry_ = !order;
      if (!order) return;
      worker.batch = order->batch;
      worker.is_busy = true;
      lines_.send(worker.rank, "order " + fuzz::to_text(*order));
    }
  }

  [[nodiscard]] bool is_told_to_stop() const {
    return Interruption::signal() != 0 || (options_.seconds && progress_.seconds_so_far() >= *options_.seconds);
  }
  void stop() {
    is_stopping_ = true;
    stopped_ = Clock::now();
    for (const Worker& worker : workers_) {
      if (worker.is_ready && worker.is_there()) lines_.send(worker.rank, "stop");
    }
  }

  [[nodiscard]] bool is_deserted() const {
    for (const Worker& worker : workers_) {
      if (worker.is_there()) return false;
    }
    return true;
  }
  [[nodiscard]] bool is_over() const {
    const bool is_hurried = is_stopping_ && Interruption::signal() != 0;
    if (is_hurried && seconds_since(stopped_) > kSecondsAfterSignal) return true;
    return is_deserted() || ((is_stopping_ || is_dry_) && campaign_.is_settled());
  }

  [[nodiscard]] LedCampaign outcome() const {
    const bool is_done = is_stopping_ || (is_dry_ && campaign_.is_settled());
    LedCampaign led{0, !is_done};
    for (const Worker& worker : workers_) led.silent_ranks += worker.is_silent ? 1 : 0;
    return led;
  }

  [[nodiscard]] std::size_t under_way() const {
    std::size_t sum = 0;
    for (const Worker& worker : workers_) sum += worker.cases;
    return sum;
  }

  fuzz::Campaign& campaign_;
  RankLines& lines_;
  const FuzzMpiOptions& options_;
  FuzzProgress& progress_;
  std::vector<Worker> workers_;
  Clock::time_point told_ = Clock::now();
  Clock::time_point stopped_ = told_;
  bool is_stopping_ = false;
  bool is_dry_ = false;  // no batch is left to be handed out
};

}  // namespace

LedCampaign lead(fuzz::Campaign& campaign, RankLines& lines, const FuzzMpiOptions& options, FuzzProgress& progress) {
  return Lead(campaign, lines, options, progress).run();
}

// ---- A working rank ----

namespace {

constexpr int kPollMilliseconds = 5;
// Rank 0 may be busy for a while, with its files or with many ranks.
constexpr double kPatience = 4;

class WorkerRank {
 public:
  WorkerRank(RankLines& lines, BatchProcess& process, const FuzzMpiOptions& options)
      : lines_(lines), process_(process), options_(options) {}

  void run() {
    while (!is_at_the_end_) {
      take_lines_of_rank_0();
      for (const std::string& line : process_.lines(kPollMilliseconds)) tell(line);
      if (process_.has_ended() && !has_told_end_) tell_end();
      if (Interruption::signal() != 0 && !is_leaving_) leave();
      if (seconds_since(told_) > options_.heartbeat_seconds()) tell("alive");
      // While rank 0 opens the campaign it says nothing.
      if (heard_ && seconds_since(*heard_) > kPatience * options_.silence_seconds) end_without_rank_0();
    }
  }

 private:
  void tell(const std::string& line) {
    told_ = Clock::now();
    lines_.send(0, line);
  }
  void tell_end() {
    has_told_end_ = true;
    tell(is_leaving_ ? "gone it was told to end by a signal" : "gone its process has ended");
  }
  void leave() {
    is_leaving_ = true;
    process_.give("stop");
  }

  void take_lines_of_rank_0() {
    while (const auto line = lines_.receive()) {
      heard_ = Clock::now();
      if (line->text == "end") {
        is_at_the_end_ = true;
      } else if (line->text != "alive") {
        process_.give(line->text);
      }
    }
  }

  [[noreturn]] void end_without_rank_0() {
    io::tell(fmt::format("flowcert-fuzz-mpi: rank {}: rank 0 is not heard of any more\n", lines_.rank()));
    MPI_Abort(MPI_COMM_WORLD, kUnusable);
    std::abort();
  }

  RankLines& lines_;
  BatchProcess& process_;
  const FuzzMpiOptions& options_;
  std::optional<Clock::time_point> heard_;
  Clock::time_point told_ = Clock::now();
  bool is_leaving_ = false;
  bool has_told_end_ = false;
  bool is_at_the_end_ = false;
};

}  // namespace

void work_for_rank_0(RankLines& lines, BatchProcess& process, const FuzzMpiOptions& options) {
  const Interruption interruption;
  WorkerRank(lines, process, options).run();
}

}  // namespace flowcert::commands
