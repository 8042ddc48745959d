// How many cases of a run are done, on a terminal, by ProgressLine: "verifying: 312 of 500 cases, 4 wrong  7 s", with
// the seconds since the last one.
//
// Guarantees: those of ProgressLine. Of the programs of one pipe, `generate | PROGRAM | verify`, only the last one
// shows a line, because they share a terminal.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>

#include "cli/layer.h"
#include "cli/progress.h"

namespace flowcert::cli {

enum class PlaceInPipe { kFirst, kLast };

class CaseProgress {
 public:
  // `stream` as for ProgressLine.
  CaseProgress(std::string what, int stream, PlaceInPipe place);
  CaseProgress(const CaseProgress&) = delete;
  CaseProgress& operator=(const CaseProgress&) = delete;

  // Shows `wrong` if there is any. This takes no time to speak of.
  void operator()(std::size_t done, std::size_t total, std::size_t wrong = 0) {
    wrong_.store(wrong, std::memory_order_relaxed);
    total_.store(total, std::memory_order_relaxed);
    done_.store(done, std::memory_order_relaxed);
  }

 private:
  void show_until(const std::stop_token& stop);
  [[nodiscard]] std::string text() const;

  std::string what_;
  int stream_;
  PlaceInPipe place_;
  std::atomic<std::size_t> done_{0}, total_{0}, wrong_{0};
  // A line needs a moment before it shows. Until then the one before does.
  std::unique_ptr<ProgressLine> before_, shown_;
  std::jthread showing_;  // the last member, so that it ends before the lines do
};

}  // namespace flowcert::cli
