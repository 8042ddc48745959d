// A thread draws the line four times a second, because a search may say nothing for minutes.
#include "oracle/program/waiting_line.h"

#include <unistd.h>

#include <iostream>
#include <system_error>
#include <utility>

namespace oracle {

namespace {

constexpr std::chrono::seconds kDelay{2};
constexpr std::chrono::milliseconds kRedraw{250};
constexpr char kErase[] = "\r\033[K";

}  // namespace

WaitingLine::WaitingLine(std::string what) : what_(std::move(what)) {
  if (::isatty(STDERR_FILENO) != 1) return;
  try {
    drawing_ = std::thread([this] { draw_until_done(); });
  } catch (const std::system_error&) {
    // There is no thread to be had. The work goes on without a line.
  }
}

WaitingLine::~WaitingLine() {
  if (!drawing_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    is_done_ = true;
  }
  changed_.notify_all();
  drawing_.join();
}

void WaitingLine::draw(std::chrono::seconds so_far) {
  std::cerr << kErase << what_;
  if (total_ > 0) std::cerr << ", " << done_ << " of " << total_;
  std::cerr << "  " << so_far.count() << " s" << std::flush;
  is_drawn_ = true;
}

void WaitingLine::erase() {
  if (is_drawn_) std::cerr << kErase << std::flush;
  is_drawn_ = false;
}

void WaitingLine::say(const std::string& text) {
  const std::scoped_lock lock(mutex_);
  erase();
  std::cout << text << '\n';
  if (drawing_.joinable()) std::cout.flush();
}

void WaitingLine::draw_until_done() {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, kRedraw, [this] { return is_done_; })) {
    const auto so_far = std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start);
    if (so_far >= kDelay) draw(so_far);
  }
  erase();
}

}  // namespace oracle
