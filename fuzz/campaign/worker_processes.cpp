// Each worker reads orders from a pipe and writes messages to another one. The trial that it is at is in memory that
// it shares with its parent. The parent can still read it there when the worker has ended.
#include "fuzz/campaign/worker_processes.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "fuzz/campaign/campaign_plan.h"
#include "fuzz/campaign/child_process.h"
#include "fuzz/campaign/counterexample.h"
#include "fuzz/campaign/shrinking.h"
#include "fuzz/inputs/large_family.h"
#include "fuzz/properties/property.h"

namespace flowcert::fuzz {

// ---- The trial that a worker is at ----
// The parent can read the whole trial that was noted last, whatever the process dies of.

namespace {

constexpr std::size_t kMostNumbers = 64;
constexpr std::size_t kMostText = std::size_t{1} << 20;

// There are two places. A trial is written to the one that does not hold the latest trial.
struct Place {
  std::uint64_t number = 0;
  std::array<char, 64> source{}, property{};
  std::size_t rows = 0;
  std::array<Row, kMostRowsOfLarge> row{};
  bool has_choice = false;
  property::StartKind kind{};
  std::size_t numbers = 0;
  std::array<std::uint32_t, kMostNumbers> numbers_of_choice{};
  std::array<char, kMostText> start{};
};

template <std::size_t N>
void copy_text(const std::string& text, std::array<char, N>& to) {
  const std::size_t size = std::min(text.size(), N - 1);
  std::copy_n(text.begin(), size, to.begin());
  to[size] = '\0';
}

class SharedTrial {
 public:
  SharedTrial() {
    void* memory = ::mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    memory_ = new (memory) Memory;
  }
  ~SharedTrial() { ::munmap(memory_, sizeof(Memory)); }
  SharedTrial(const SharedTrial&) = delete;
  SharedTrial& operator=(const SharedTrial&) = delete;

  // Called by the worker.
  void note(std::size_t number, const std::string& source, const std::string& property, const property::Trial& trial);
  void count_case() { ++memory_->cases; }
  void forget() { memory_->is_trying = false; }  // nothing is being tried
  void start_batch() { memory_->cases = 0; }
  [[nodiscard]] bool is_told_to_stop() const { return memory_->stop; }

  // Called by the parent.
  [[nodiscard]] bool is_trying() const { return memory_->is_trying; }
  // The trial that was noted last, as a counterexample without a disagreement.
  [[nodiscard]] Counterexample noted() const;
  // Changes with every trial.
  [[nodiscard]] std::uint64_t trials() const { return memory_->trials; }
  // Cases done in the batch under way.
  [[nodiscard]] std::size_t cases() const { return memory_->cases; }
  void tell_to_stop() { memory_->stop = true; }

 private:
  struct Memory {
    std::array<Place, 2> places;
    std::atomic<std::uint64_t> trials{0};  // the latest one is in places[trials % 2]
    std::atomic<bool> is_trying{false};
    std::atomic<std::uint64_t> cases{0};
    std::atomic<bool> stop{false};
  };
  Memory* memory_;
};

void SharedTrial::note(std::size_t number, const std::string& source, const std::string& property,
                       const property::Trial& trial) {
  const std::uint64_t next = memory_->trials + 1;
  Place& place = memory_->places.at(next % 2);
  place.number = number;
  copy_text(source, place.source);
  copy_text(property, place.property);
  place.rows = std::min(trial.input.rows.size(), place.row.size());
  std::copy_n(trial.input.rows.begin(), place.rows, place.row.begin());
  if (const auto* choice = std::get_if<property::StartChoice>(&trial.start)) {
    place.has_choice = true;
    place.kind = choice->kind;
    place.numbers = std::min(choice->numbers.size(), kMostNumbers);
    std::copy_n(choice->numbers.begin(), place.numbers, place.numbers_of_choice.begin());
  } else {
    place.has_choice = false;
    copy_text(to_text(std::get<oracle::Point>(trial.start)), place.start);
  }
  memory_->trials = next;
  memory_->is_trying = true;
}

Counterexample SharedTrial::noted() const {
  const Place& place = memory_->places.at(memory_->trials % 2);
  Counterexample noted;
  noted.number = place.number;
  noted.source = place.source.data();
  noted.rows_before = place.rows;
  noted.property = place.property.data();
  noted.trial.input.rows.assign(place.row.begin(), place.row.begin() + static_cast<std::ptrdiff_t>(place.rows));
  if (place.has_choice) {
    const auto* first = place.numbers_of_choice.begin();
    noted.trial.start = property::StartChoice{place.kind, {first, first + place.numbers}};
  } else {
    noted.trial.start = point_of(place.start.data());
  }
  return noted;
}

// ---- Ends of processes ----

using Clock = std::chrono::steady_clock;
using property::Disagreement;
using property::Property;
using property::Trial;

constexpr int kPollMilliseconds = 100;
constexpr double kLongestLook = 0.2;  // the most seconds between two looks, unless suspended
// Each smaller input costs a process.
constexpr std::size_t kCrashShrinkingBudget = 300;
constexpr unsigned kCrashSeconds = 10;
constexpr int kMachineFailed = 99;  // exit status
// The campaign is over if more processes in a row are killed by others while they try nothing.
constexpr std::size_t kMostKills = 20;
// Cases under way have so long when everything is to stop.
constexpr double kSecondsToStop = 2;

// ---- A process of its own for one trial ----

// Closes all but the standard descriptors and these two. The others are the lock of the campaign's folder and ends of
// other workers' pipes, which would never close otherwise.
void close_descriptors_but(int one, int other) {
  const auto lesser = static_cast<unsigned>(std::min(one, other));
  const auto greater = static_cast<unsigned>(std::max(one, other));
  constexpr unsigned kFirst = STDERR_FILENO + 1;
  if (kFirst < lesser) ::close_range(kFirst, lesser - 1, 0);
  if (lesser + 1 < greater) ::close_range(lesser + 1, greater - 1, 0);
  ::close_range(greater + 1, ~0U, 0);
}

std::string text_of_signal(int status) {
  return fmt::format("the process ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
}

// Whether the property ends its process on this trial in the same way.
std::optional<Disagreement> same_crash(const Disagreement& crash, const std::function<void(const Trial&)>& attempt,
                                       const Trial& trial) {
  const int status = wait_for_end(start_child([&] {
    ::alarm(kCrashSeconds);
    try {
      attempt(trial);
    } catch (const property::MachineFailure&) {
      ::_exit(kMachineFailed);
    }
  }));
  if (WIFEXITED(status) && WEXITSTATUS(status) == kMachineFailed) {
    throw property::MachineFailure("a crash cannot be made small: something is wrong with this machine");
  }
  const bool is_same = WIFSIGNALED(status) && text_of_signal(status) == crash.complaint;
  return is_same ? std::optional(crash) : std::nullopt;
}

// ---- The worker's side ----

class PipeObserver : public BatchObserver {
 public:
  PipeObserver(int descriptor, SharedTrial& shared) : descriptor_(descriptor), shared_(shared) {}

  void tries(std::size_t number, const std::string& source, const std::string& property, const Trial& trial) override {
    shared_.note(number, source, property, trial);
  }
  void has_done(std::size_t, const std::string&) override {
    shared_.forget();
    shared_.count_case();
  }
  void found(const Counterexample& counterexample) override { tell(message_of(counterexample)); }
  void discovered(const Discovery& discovery) override { tell(message_of(discovery)); }
  [[nodiscard]] bool is_stopped() override { return shared_.is_told_to_stop(); }

  void tell(const std::string& message) const {
    if (!write_line(descriptor_, message)) ::_exit(1);
  }

 private:
  int descriptor_;
  SharedTrial& shared_;
};

void run_property(const std::vector<Property>& properties, const std::string& name, const Trial& trial) {
  if (name == "signature") (void)signature_of(trial.input);
  for (const Property& property : properties) {
    if (property.name == name) (void)disagreement(property, trial);
  }
}

void report_shrunk(const std::vector<Property>& properties, const Counterexample& crash, PipeObserver& observer) {
  if (crash.is_small) return;
  const auto attempt = [&](const Trial& trial) { run_property(properties, crash.property, trial); };
  const Judge judge = [&](const Trial& trial) -> std::optional<Disagreement> {
    if (observer.is_stopped()) return std::nullopt;
    return same_crash(crash.disagreement, attempt, trial);
  };
  const Shrunk small = shrunk(crash.trial, crash.disagreement, judge, kCrashShrinkingBudget);
  if (observer.is_stopped()) return;
  Counterexample counterexample = crash;
  counterexample.trial = small.trial;
  counterexample.is_small = true;
  counterexample.is_asked = false;
  if (small.is_budget_up) counterexample.most_tried = kCrashShrinkingBudget;
  observer.tell(message_of(counterexample));
}

void do_batches(const CampaignPlan& plan, const std::vector<Property>& properties, int orders, PipeObserver& observer,
                SharedTrial& shared) {
  LineReader reader(orders);
  while (true) {
    auto line = reader.next_line();
    if (!line) {
      if (!reader.read_more()) return;
      continue;
    }
    const BatchOrder order = order_of(*line);
    shared.start_batch();
    observer.tell(message_of(order.batch, run_batch(plan, properties, order, observer)));
    shared.start_batch();
  }
}

void be_a_worker(const CampaignPlan& plan, const std::vector<Property>& properties, int orders, int messages,
                 SharedTrial& shared, const std::optional<Counterexample>& crash) {
  PipeObserver observer(messages, shared);
  try {
    if (crash) report_shrunk(properties, *crash, observer);
    do_batches(plan, properties, orders, observer, shared);
  } catch (const property::MachineFailure& failure) {
    observer.tell(failure_message(failure.what()));
  } catch (const std::system_error& failure) {
    observer.tell(failure_message(failure.what()));
  }
}

// ---- The parent's side ----

class Worker {
 public:
  Worker(const CampaignPlan& plan, const std::vector<Property>& properties, const std::optional<Counterexample>& crash)
      : crash_(crash) {
    process_ = start_child([&] {
      close_descriptors_but(orders_.reading(), messages_.writing());
      be_a_worker(plan, properties, orders_.reading(), messages_.writing(), shared_, crash);
    });
    orders_.close_reading();
    messages_.close_writing();
    reader_ = LineReader(messages_.reading());
  }
  ~Worker() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      (void)wait_for_end();
    }
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void give(const BatchOrder& order) {
    batch = order.batch;
    (void)write_line(orders_.writing(), to_text(order));
  }
  void dismiss() { orders_.close_writing(); }
  void kill() {
    is_killed_ = true;
    ::kill(process_, SIGKILL);
  }
  // Whether this process has killed it.
  [[nodiscard]] bool is_killed() const { return is_killed_; }
  int wait_for_end() { return fuzz::wait_for_end(std::exchange(process_, -1)); }

  // Whether it has been at one trial for too long. If nobody looked for a while, that time does not count, because
  // this process was then suspended as well.
  bool hangs(double seconds) {
    const double since = seconds_since(last_look_);
    last_look_ = Clock::now();
    const std::uint64_t trials = shared_.trials();
    const bool is_at_the_same = trials == last_trials_ && shared_.is_trying();
    last_trials_ = trials;
    seconds_at_trial_ = is_at_the_same ? seconds_at_trial_ + std::min(since, kLongestLook) : 0;
    return seconds_at_trial_ > seconds;
  }

  [[nodiscard]] int descriptor() const { return messages_.reading(); }
  [[nodiscard]] LineReader& reader() { return reader_; }
  [[nodiscard]] SharedTrial& shared() { return shared_; }
  [[nodiscard]] const SharedTrial& shared() const { return shared_; }

  // Whether it still makes a crash small, and has tried nothing itself yet.
  [[nodiscard]] bool makes_crash_small() const { return crash_ && shared_.trials() == 0; }
  [[nodiscard]] const std::optional<Counterexample>& crash() const { return crash_; }

  std::optional<std::size_t> batch;
  std::optional<Counterexample> hanging_at;

 private:
  std::optional<Counterexample> crash_;  // it makes this one small first
  SharedTrial shared_;
  Pipe orders_, messages_;
  pid_t process_ = -1;
  LineReader reader_{-1};
  bool is_killed_ = false;
  std::uint64_t last_trials_ = 0;
  double seconds_at_trial_ = 0;
  Clock::time_point last_look_ = Clock::now();
};

class Work {
 public:
  Work(BatchSource& source, const std::vector<Property>& properties, const WorkOptions& options)
      : source_(source), properties_(properties), options_(options) {}

  void run() {
    for (unsigned k = 0; k < options_.jobs; ++k) {
      add_worker(source_.next_crash());
    }
    while (!workers_.empty()) {
      wait();
      if (options_.is_stopped()) stop();
      for (const auto& worker : workers_) look_after(*worker);
      options_.progress(under_way());
    }
  }

 private:
  void add_worker(const std::optional<Counterexample>& crash) {
    workers_.push_back(std::make_unique<Worker>(source_.plan(), properties_, crash));
    if (is_stopping_) workers_.back()->shared().tell_to_stop();
    employ(*workers_.back());
  }
  void employ(Worker& worker) {
    worker.batch.reset();
    const auto order = is_stopping_ ? std::nullopt : source_.next_batch();
    if (order) {
      worker.give(*order);
    } else {
      worker.dismiss();
    }
  }

  void wait() {
    std::vector<pollfd> waited;
    waited.reserve(workers_.size());
    for (const auto& worker : workers_) waited.push_back({worker->descriptor(), POLLIN, 0});
    if (::poll(waited.data(), waited.size(), kPollMilliseconds) <= 0) return;
    std::vector<std::size_t> ended;
    for (std::size_t k = 0; k < waited.size(); ++k) {
      if (waited[k].revents == 0) continue;
      if (!workers_[k]->reader().read_more()) ended.push_back(k);
      take_messages(*workers_[k]);
    }
    std::ranges::reverse(ended);
    for (const std::size_t k : ended) take_end(k);
  }

  void take_messages(Worker& worker) {
    while (const auto line = worker.reader().next_line()) {
      if (const auto failure = failure_in(*line)) throw property::MachineFailure(*failure);
      source_.absorb(*line);
      if (!ends_batch(*line)) continue;
      kills_ = 0;
      employ(worker);
    }
  }

  void take_end(std::size_t k) {
    const std::unique_ptr<Worker> worker = std::move(workers_[k]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(k));
    const int status = worker->wait_for_end();
    const bool is_through = WIFEXITED(status) && !worker->batch;
    const bool is_left_off = worker->is_killed() && !worker->hanging_at;
    if (worker->batch) source_.give_back(*worker->batch);
    if (is_through || is_left_off) {
      const auto left = is_stopping_ ? std::nullopt : source_.next_crash();
      if (left) add_worker(left);
      return;
    }
    if (worker->makes_crash_small()) return add_worker(after_making_small(*worker, status));
    const std::optional<Counterexample> crash = crash_of_end(*worker, status);
    // The crash is reported at once, as it is, so that the batch is done without it. The small one follows.
    if (crash) source_.absorb(message_of(*crash));
    add_worker(crash);
  }

  // Returns nothing if the case seems not to be the reason.
  std::optional<Counterexample> crash_of_end(const Worker& worker, int status) {
    const std::string how = WIFSIGNALED(status) ? text_of_signal(status) : "the process ended by itself";
    if (worker.hanging_at) {
      return ended(*worker.hanging_at, "hang", fmt::format("not done after {} s", options_.hang_seconds));
    }
    if (!worker.shared().is_trying()) {
      if (!is_by_others(status) || ++kills_ > kMostKills) throw std::runtime_error(how);
      return std::nullopt;
    }
    Counterexample noted = worker.shared().noted();
    if (is_by_others(status) && killed_at_.insert(noted.number).second) return std::nullopt;
    return ended(std::move(noted), "crash", how);
  }
  // A case that hangs is not shrunk.
  [[nodiscard]] Counterexample ended(Counterexample noted, const std::string& kind, const std::string& how) const {
    noted.seed = source_.plan().seed;
    noted.disagreement = {kind, "", how, "", "", "", ""};
    noted.is_small = kind != "crash";
    return noted;
  }
  // Tries once more if others killed the process. Otherwise the crash stays as it is.
  std::optional<Counterexample> after_making_small(const Worker& worker, int status) {
    return is_by_others(status) && ++kills_ <= kMostKills ? worker.crash() : std::nullopt;
  }
  // A user may have killed it, or the system for want of memory. The second time, the case is taken as the reason.
  static bool is_by_others(int status) { return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL; }

  void look_after(Worker& worker) {
    if (worker.is_killed()) return;
    if (worker.hangs(options_.hang_seconds)) worker.hanging_at = worker.shared().noted();
    const bool is_late = is_stopping_ && seconds_since(stopped_) > kSecondsToStop;
    if (worker.hanging_at || is_late) worker.kill();
  }

  void stop() {
    if (!is_stopping_) stopped_ = Clock::now();
    is_stopping_ = true;
    for (const auto& worker : workers_) worker->shared().tell_to_stop();
  }

  [[nodiscard]] std::size_t under_way() const {
    std::size_t sum = 0;
    for (const auto& worker : workers_) sum += worker->batch ? worker->shared().cases() : 0;
    return sum;
  }

  BatchSource& source_;
  const std::vector<Property>& properties_;
  const WorkOptions& options_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::set<std::size_t> killed_at_;  // cases during which a process was killed by others
  std::size_t kills_ = 0;            // kills while nothing was tried, since the last batch was done
  bool is_stopping_ = false;
  Clock::time_point stopped_;
};

}  // namespace

void work_on(BatchSource& source, const std::vector<Property>& properties, const WorkOptions& options) {
  // The end of its messages shows that a worker is gone, so no signal is needed.
  const auto before = ::signal(SIGPIPE, SIG_IGN);
  Work(source, properties, options).run();
  ::signal(SIGPIPE, before);
}

}  // namespace flowcert::fuzz
