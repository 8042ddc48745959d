// A thread draws the line, ten times a second, because the work may say nothing for minutes. It exists only while a
// line does, and only for a terminal.
#include "cli/progress.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "io/diagnostic.h"

namespace flowcert::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kDelay{2};
constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::chrono::milliseconds kSteady{300};
constexpr std::size_t kBarWidth = 32;
constexpr std::size_t kUsualColumns = 80;

std::size_t terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : kUsualColumns;
}

// The lines that exist, and the thread that draws the innermost steady one.
class Screen {
 public:
  static Screen& instance() {
    static Screen screen;
    return screen;
  }

  void add(const ProgressLine& line) {
    const std::scoped_lock lock(mutex_);
    lines_.push_back(&line);
    if (lines_.size() == 1)
      drawing_ = thread_without_signals([this](const std::stop_token& stop) { draw_until(stop); });
  }

  void remove(const ProgressLine& line) {
    std::jthread finished;  // is joined at the end, without the lock
    {
      const std::scoped_lock lock(mutex_);
      std::erase(lines_, &line);
      if (drawn_ == &line) erase();
      if (!lines_.empty()) return;
      finished = std::move(drawing_);
      finished.request_stop();
    }
    changed_.notify_all();
  }

 private:
  void draw_until(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      draw();
      changed_.wait_for(lock, kRedraw);
    }
  }

  void draw() {
    const Clock::time_point now = Clock::now();
    if (now - begin_ < kDelay) return;
    const auto steady =
        std::find_if(lines_.rbegin(), lines_.rend(), [now](const ProgressLine* line) { return line->is_steady(now); });
    if (steady == lines_.rend()) return;
    drawn_ = *steady;
    io::tell("\r" + drawn_->text(now, terminal_columns() - 1) + "\033[K");
  }

  void erase() {
    io::tell("\r\033[K");
    drawn_ = nullptr;
  }

  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<const ProgressLine*> lines_;
  const ProgressLine* drawn_ = nullptr;
  std::jthread drawing_;
};

}  // namespace

std::jthread thread_without_signals(const std::function<void(const std::stop_token& stop)>& work) {
  std::jthread thread;
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    thread = std::jthread(work);
  } catch (const std::system_error&) {
    // The work goes on without it.
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

ProgressLine::ProgressLine(std::string what, int stream)
    : what_(std::move(what)), is_shown_(::isatty(STDERR_FILENO) == 1 && ::isatty(stream) == 0) {
  if (is_shown_) Screen::instance().add(*this);
}

ProgressLine::~ProgressLine() {
  if (is_shown_) Screen::instance().remove(*this);
}

bool ProgressLine::is_steady(Clock::time_point now) const { return now - start_ >= kSteady; }

std::string ProgressLine::text(Clock::time_point now, std::size_t columns) const {
  const std::size_t total = total_.load(std::memory_order_relaxed);
  const std::size_t done = std::min(done_.load(std::memory_order_relaxed), total);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  std::string line;
  if (done == 0) {
    line = fmt::format("{}  {:.0f} s", what_, seconds);
  } else {
    const std::size_t filled = kBarWidth * done / total;
    const double left = seconds * static_cast<double>(total - done) / static_cast<double>(done);
    line = fmt::format("{} [{:#<{}}{:.<{}}] {:3} %  {:.0f} s left", what_, "", filled, "", kBarWidth - filled,
                       100 * done / total, left);
    if (line.size() > columns) line = fmt::format("{} {} %", what_, 100 * done / total);
  }
  return line.substr(0, columns);
}

}  // namespace flowcert::cli
