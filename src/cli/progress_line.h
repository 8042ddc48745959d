// A progress bar on standard error: only on a terminal, only for what takes longer than two seconds, gone
// when it is done.
//
// Our own, since Debian has no C++ library for it but Boost's progress_display, which cannot be taken back
// from the screen and knows neither terminals nor delays.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "cli/layer.h"

namespace flowcert::cli {

class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void operator()(std::size_t done, std::size_t total);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
  bool is_terminal_;
  bool is_drawn_ = false;
};

}  // namespace flowcert::cli
