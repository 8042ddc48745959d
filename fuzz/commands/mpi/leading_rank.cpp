// See leading_rank.h.
#include "fuzz/commands/mpi/leading_rank.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "fuzz/campaign/message.h"
#include "fuzz/judge/interruption.h"

namespace flowcert::commands {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{5};
// After a signal: mpirun passes one on and kills all ranks a second later.
constexpr double kSecondsAfterSignal = 0.5;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Worker {
  int rank = 0;
  bool is_ready = false;
  bool is_silent = false;
  bool is_gone = false;
  bool is_busy = false;  // with an order, its own or one that was taken back
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
    fmt::print(stderr, "flowcert-fuzz-mpi: rank {} {}{}\n", worker.rank, what,
               worker.batch ? fmt::format("; batch {} is handed out again", *worker.batch) : "");
  }

  // False if there was none.
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
    // A whole batch counts even if another rank has got it meanwhile. Half of one only when nobody will do
    // it.
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
    return Interruption::signal() != 0 ||
           (options_.seconds && progress_.seconds_so_far() >= *options_.seconds);
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

LedCampaign lead(fuzz::Campaign& campaign, RankLines& lines, const FuzzMpiOptions& options,
                 FuzzProgress& progress) {
  return Lead(campaign, lines, options, progress).run();
}

}  // namespace flowcert::commands
