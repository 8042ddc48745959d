// A line is written over itself, at most ten times a second.
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace flowcert::cli {

namespace {

constexpr std::chrono::seconds kDelay{2};
constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::size_t kWidth = 32;

}  // namespace

ProgressLine::ProgressLine(std::string what) : what_(std::move(what)), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (is_drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::operator()(std::size_t done, std::size_t total) {
  if (!is_terminal_ || total == 0) return;
  const Clock::time_point now = Clock::now();
  if (now - start_ < kDelay || now - last_drawn_ < kRedraw) return;
  last_drawn_ = now;
  is_drawn_ = true;
  const std::size_t filled = kWidth * done / total;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double left = done == 0 ? 0 : seconds * static_cast<double>(total - done) / static_cast<double>(done);
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3} %  {:.0f} s left\033[K", what_, "", filled, "", kWidth - filled,
             100 * done / total, left);
  std::fflush(stderr);
}

}  // namespace flowcert::cli
