// See conformance_run.h.
#include "fuzz/judge/conformance_run.h"

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "fuzz/judge/case_run.h"
#include "fuzz/judge/interruption.h"
#include "fuzz/judge/scratch_folder.h"

namespace flowcert::judge {

namespace {

using Progress = std::function<void(std::size_t done, std::size_t total)>;

// Workers take the next case each, until there is none, or one of them cannot go on.
class ConformanceRun {
 public:
  ConformanceRun(const std::vector<const VectorCase*>& cases, const ConformanceOptions& options,
                 const Progress& progress)
      : cases_(cases), options_(options), progress_(progress), outcomes_(cases.size()) {}

  std::vector<CaseOutcome> outcomes() {
    {
      std::vector<std::jthread> workers;
      for (unsigned k = 1; k < options_.jobs; ++k) workers.emplace_back([this] { work(); });
      work();
    }
    if (Interruption::signal() != 0) throw Interrupted{Interruption::signal()};
    if (failure_) std::rethrow_exception(failure_);
    return std::move(outcomes_);
  }

 private:
  void work() {
    while (!is_over()) {
      const std::size_t k = next_++;
      if (k >= cases_.size()) return;
      try {
        outcomes_[k] = run_case(*cases_[k], options_, scratch_.path(), [this] { return is_over(); });
      } catch (const std::exception& error) {
        stop(fmt::format("{}: {}", cases_[k]->id, error.what()));
      }
      const std::lock_guard lock(mutex_);
      progress_(++done_, cases_.size());
    }
  }

  void stop(const std::string& why) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::make_exception_ptr(std::runtime_error(why));
    has_failed_ = true;
  }

  [[nodiscard]] bool is_over() const { return has_failed_ || Interruption::signal() != 0; }

  const std::vector<const VectorCase*>& cases_;
  const ConformanceOptions& options_;
  const Progress& progress_;
  std::vector<CaseOutcome> outcomes_;  // each written by one worker
  ScratchFolder scratch_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;  // of what follows
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<CaseOutcome> run_conformance(const std::vector<const VectorCase*>& cases,
                                         const ConformanceOptions& options, const Progress& progress) {
  return ConformanceRun(cases, options, progress).outcomes();
}

}  // namespace flowcert::judge
