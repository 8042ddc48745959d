// See worker_rank.h.
#include "fuzz/commands/mpi/worker_rank.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "cli/command.h"
#include "fuzz/judge/interruption.h"

namespace flowcert::commands {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollMilliseconds = 5;
// Rank 0 may be busy for a while: with its files, with many ranks.
constexpr double kPatience = 4;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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
    fmt::print(stderr, "flowcert-fuzz-mpi: rank {}: rank 0 is not heard of any more\n", lines_.rank());
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
