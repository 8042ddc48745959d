// What the oracle is at, on standard error: how many of how many, and for how many seconds.
//
// Guarantees: nothing is written unless standard error is a terminal, and nothing in the first two seconds. The line is
// erased at the end. The oracle shares no code with the fast program, so it has its own.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace oracle {

class WaitingLine {
 public:
  explicit WaitingLine(std::string what);
  ~WaitingLine();
  WaitingLine(const WaitingLine&) = delete;
  WaitingLine& operator=(const WaitingLine&) = delete;

  // Prints a line on standard output, which the same terminal may show.
  void say(const std::string& text);
  void tell(std::size_t done, std::size_t total) {
    done_ = done;
    total_ = total;
  }

 private:
  void draw(std::chrono::seconds so_far);
  void erase();
  void draw_until_done();

  std::string what_;
  std::atomic<std::size_t> done_{0}, total_{0};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_done_ = false, is_drawn_ = false;
  std::thread drawing_;
};

}  // namespace oracle
