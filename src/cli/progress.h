// What a command is at, on standard error: a bar where it is known how much there is to do, else the seconds so far.
//
// Guarantees: nothing is written unless standard error is a terminal. Nothing is shown in the first two seconds of a
// command. After them there is always the innermost line of those that exist, also while nobody says how far the work
// is. A line is erased when its work is done, by an exception as well. Reporting takes no time to speak of.
//
// The code is our own. Debian's only C++ library for this is Boost's progress_display. That cannot be erased from
// the screen, and knows neither terminals nor delays.
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "cli/layer.h"
#include "flowcert/flow_complex.h"
#include "morse/part_text.h"

namespace flowcert::cli {

// A thread that is given no signal: those go to the threads that work, because OutputFile removes its temporary file in
// a handler. Not joinable where there is no thread to be had.
[[nodiscard]] std::jthread thread_without_signals(const std::function<void(const std::stop_token& stop)>& work);

class ProgressLine {
 public:
  // `what` is ASCII. A line made while there is another one hides it. There is no line if `stream`, which the work
  // reads or writes, is a terminal, too.
  explicit ProgressLine(std::string what, int stream = -1);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void operator()(std::size_t done, std::size_t total) {
    done_.store(done, std::memory_order_relaxed);
    total_.store(total, std::memory_order_relaxed);
  }

  // What is shown at this time, in so many columns at most.
  [[nodiscard]] std::string text(std::chrono::steady_clock::time_point now, std::size_t columns) const;
  // Whether it has been there so long that it does not flicker.
  [[nodiscard]] bool is_steady(std::chrono::steady_clock::time_point now) const;

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::size_t> done_{0};
  std::atomic<std::size_t> total_{0};
  bool is_shown_;
};

// Runs the work below a line that says what it is.
template <typename Work>
auto with_progress(const char* what, const Work& work) {
  const ProgressLine progress(what);
  return work();
}

// The progress of a flow complex while it is computed. Each of its parts has a line, one after the other.
class PartProgress {
 public:
  // what_of follows the part's name, for example ", run 2 of 5".
  explicit PartProgress(std::string what_of = "") : what_of_(std::move(what_of)) {}

  void operator()(FlowComplexPart part, std::size_t done, std::size_t total) {
    if (part_ != part) {
      line_.reset();
      line_.emplace(part_text(part) + what_of_);
      part_ = part;
    }
    (*line_)(done, total);
    if (done < total) return;
    line_.reset();
    part_.reset();
  }

 private:
  std::string what_of_;
  std::optional<FlowComplexPart> part_;
  std::optional<ProgressLine> line_;
};

// The complex keeps this function. So parts that are computed later show their progress too.
inline FlowComplex::Progress part_progress(std::string what_of = "") {
  return [told = std::make_shared<PartProgress>(std::move(what_of))](FlowComplexPart part, std::size_t done,
                                                                     std::size_t total) { (*told)(part, done, total); };
}

}  // namespace flowcert::cli
