// The text of a ProgressLine does not change, so a thread replaces the line now and then: the work may wait for
// minutes. The last program of a pipe holds a lock on the terminal, for the first one to see. Others do not look at it.
#include "cli/case_progress.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "io/number_text.h"

namespace flowcert::cli {

namespace {

constexpr std::chrono::milliseconds kLook{100};
// A line shows within this time (kSteady and kRedraw in cli/progress.cpp).
constexpr std::chrono::milliseconds kBetweenLines{500};

struct flock whole_terminal() {
  struct flock lock{};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

void hold_terminal() {
  struct flock lock = whole_terminal();
  ::fcntl(STDERR_FILENO, F_SETLK, &lock);
}

bool is_terminal_held() {
  struct flock lock = whole_terminal();
  return ::fcntl(STDERR_FILENO, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace

CaseProgress::CaseProgress(std::string what, int stream, PlaceInPipe place)
    : what_(std::move(what)), stream_(stream), place_(place) {
  if (::isatty(STDERR_FILENO) == 0) return;
  if (place_ == PlaceInPipe::kLast) hold_terminal();
  shown_ = std::make_unique<ProgressLine>(what_, stream_);
  showing_ = thread_without_signals([this](const std::stop_token& stop) { show_until(stop); });
}

std::string CaseProgress::text() const {
  const std::size_t wrong = wrong_.load(std::memory_order_relaxed);
  return fmt::format("{}: {} of {}{}", what_, with_commas(done_.load(std::memory_order_relaxed)),
                     counted(total_.load(std::memory_order_relaxed), "case"),
                     wrong == 0 ? "" : fmt::format(", {} wrong", with_commas(wrong)));
}

void CaseProgress::show_until(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  auto changed = std::chrono::steady_clock::now();
  std::size_t told = 0;
  while (!stop.stop_requested()) {
    if (place_ == PlaceInPipe::kFirst && is_terminal_held()) {
      before_.reset();
      shown_.reset();
      return;
    }
    const auto now = std::chrono::steady_clock::now();
    const std::size_t done = done_.load(std::memory_order_relaxed);
    if (done != told && now - changed >= kBetweenLines) {
      told = done;
      changed = now;
      before_ = std::move(shown_);
      shown_ = std::make_unique<ProgressLine>(text(), stream_);
    }
    never.wait_for(lock, stop, kLook, [] { return false; });
  }
}

}  // namespace flowcert::cli
